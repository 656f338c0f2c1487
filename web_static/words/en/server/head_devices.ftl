### What the head trackers say of themselves, and why one cannot be used.

headdev-simulated-rests = The simulated head rests.
headdev-simulated-looks = The simulated head looks around.
headdev-tablet-unused = The tablet's orientation is not used.
headdev-tablet-silent = No orientation comes from a tablet: open its page and let it use the sensor.
headdev-tablet = The tablet reports its orientation.
headdev-recorded-rests = The recorded head { $file } is not played.
headdev-recorded-plays = Recorded head { $file } is played.
headdev-recorded-short = { $file }: a recorded head needs at least { $least } s and times that grow, record it again

# $tracker is opentrack or FreePIE, $place the address HOST:PORT on this machine.
headdev-udp-failed =
    the head tracker { $tracker } cannot be received on { $place } ({ $why ->
        [no-address] no such address
       *[other] { $why }
    }): use an address of this machine and a port that is free
headdev-udp-closed = Nothing listens for the head tracker { $tracker }.
# $refused counts datagrams (packets of the network) that hold no pose of a head.
headdev-udp-silent =
    No poses from { $tracker } on { $place }{ $refused ->
        [0] {""}
        [one] , { $refused } datagram refused
       *[other] , { $refused } datagrams refused
    }.
headdev-udp =
    Head tracker { $tracker } on { $place }{ $refused ->
        [0] {""}
        [one] , { $refused } datagram refused
       *[other] , { $refused } datagrams refused
    }.

# The Flock of Birds is a tracker of the company Ascension; FLY is a position of its switch.
headdev-flock-failed = the Flock of Birds on { $device } cannot be opened ({ $why }): check cable, power and the device's name
headdev-flock-lost =
    The Flock of Birds on { $device } was lost ({ $why ->
        [unknown] it went away
       *[other] { $why }
    }): check its cable, then choose it again.
headdev-flock-closed = The Flock of Birds on { $device } is not open.
headdev-flock-silent = The Flock of Birds on { $device } sends nothing: switch it to FLY, and check its baud rate.
headdev-flock = Flock of Birds on { $device }.
