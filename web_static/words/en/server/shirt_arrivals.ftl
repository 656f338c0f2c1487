### What arrives at a shirt, as the Shirt page says it by itself, and what to do when nothing does.

arrivals-good = Signals arrive.
arrivals-waiting = Waiting for signals.
# Packets are those of a network (UDP). $place is an address with a port. machine: no other machine can reach that address.
arrivals-udp-nothing =
    { $reach ->
        [machine] Nothing at all arrives at { $place }. Only programs on this machine reach that address: for a shirt elsewhere, listen on another address of this machine, or on 0.0.0.0, which is all of them.
       *[network] Nothing at all arrives at { $place }: nothing is sent there, or a firewall keeps it out. Let the shirt send to an address of this machine and port { $port }, and open UDP port { $port } in its firewall.
    }
arrivals-slimevr-nothing =
    { $reach ->
        [machine] Nothing at all arrives at { $place }. Only programs on this machine reach that address. Listen on 0.0.0.0, which is every network of this machine, so that the trackers can find it.
       *[network] Nothing at all arrives at { $place }: the trackers are in another network, or a firewall keeps their packets out. Bring them into the network of this machine, and open UDP port { $port } in its firewall.
    }
arrivals-slimevr-idle = A tracker answers, but no movement comes from it. Move it: some send nothing while they lie quite still. If it stays so, switch it off and on, and see whether a firewall keeps out what this machine sends to it.
# $source is a kind of shirt, $parts a list of parts of the body.
arrivals-partial =
    { $source ->
        [slimevr] Signals arrive, but none from: { $parts }. Switch the tracker there on. One that sends only what has changed counts as silent while it lies quite still: use firmware that sends then, too (OPTIMIZE_UPDATES off).
       *[other] Signals arrive, but none from: { $parts }. Switch the sensor there on.
    }
# $why is a message shirtdev-frame-... or arrivals-no-tracker; $sender is an address.
arrivals-foreign =
    { $count ->
        [one] { $count } packet arrived that is no frame of this shirt. It has { $size } bytes and comes from { $sender } ({ $why }).
       *[other] { $count } packets arrived that are no frames of this shirt. The newest has { $size } bytes and comes from { $sender } ({ $why }).
    }
# Stands in brackets, behind what is left out.
arrivals-no-tracker = it does not come from a tracker: let nothing else send to this port
# $why is a message shirtdev-frame-late, shirtdev-newest-not-stored or arrivals-repeated.
arrivals-none-counts = Frames arrive, but none is used ({ $why }).
arrivals-repeated = each was used before: start the shirt again
# $stranger and $sender are addresses.
arrivals-senders = Frames arrive from { $stranger }, and are left out, because the shirt is the sender at { $sender }.
arrivals-rate = { $measured } frames a second arrive, but { $expected } are set. Choose { $measured } as “{ shirtdev-rate }”, or let the device send { $expected }.
arrivals-serial-foreign = { $bytes } bytes have arrived on { $device }, but what comes is no frame of this shirt ({ $why }).
# $lines is a list of serial lines.
arrivals-serial-gone =
    The shirt on { $device } is gone: put its cable in again, and its signals come back by themselves.{ $lines ->
        [none] {""}
       *[other] {" "}When the line has another name afterwards, choose that: this machine has { $lines }.
    }
# $streams is a list of streams.
arrivals-lsl-silent =
    { $ended ->
        [yes] The program that sends { $streams } has ended: start it again on that computer, and its samples come back by themselves.
       *[no] No samples come from { $streams }: let the program that sends them begin, and open UDP and TCP ports 16572 to 16604 between both computers.
    }
arrivals-camera-nothing = No page sends as the camera: start it here or on the patient’s screen, and keep that page in view.
arrivals-camera-nobody = The camera sends, but sees nobody: sit so that head, shoulders and arms are in the picture.
arrivals-camera-idle = The camera gives the same picture again and again. Look whether it is covered or switched off, then start it again.
arrivals-camera-late = Pictures arrive { $delay } s late, and a late one is not used: close other programs on the device of the camera, or choose fewer frames a second.
arrivals-camera-slow = The camera reads { $pictures } pictures a second, too few for { $expected } frames: choose fewer frames a second, or use another device.
arrivals-page-foreign =
    { $count ->
        [one] { $count } message arrived that is no new sample: load the page that sends it again.
       *[other] { $count } messages arrived that are no new samples: load the page that sends them again.
    }
arrivals-phones-nothing = No phone sends: pair one, tap Start on it, and keep its page in view. Its page says what it lacks.
arrivals-phones-late = Messages of the phones arrive { $delay } s late, and a late one is not used: bring the phones nearer to the wireless network’s station.
# $why is what this computer's Bluetooth says.
arrivals-bluetooth-nothing =
    { $why ->
        [none] No sensor is in reach: switch them on, bring them nearer to this computer, and end their maker’s app, for a sensor has one connection only.
       *[other] Nothing arrives over Bluetooth ({ $why }): see that this computer’s adapter is in and on, switch the sensors off and on, and end their maker’s app, for a sensor has one connection only.
    }
arrivals-bluetooth-idle = A sensor is connected, but no movement comes from it: switch it off and on.
arrivals-bluetooth-foreign =
    { $count ->
        [one] { $count } message arrived that such a sensor does not send: use sensors of WitMotion with Bluetooth 5, such as the WT901BLE.
       *[other] { $count } messages arrived that such a sensor does not send: use sensors of WitMotion with Bluetooth 5, such as the WT901BLE.
    }
arrivals-bluetooth-repeated = A sensor sends one measurement again and again, and each counts once: switch it off and on.
# $part is a part of the body.
arrivals-bluetooth-rate = { $part }: its sensor sends { $measured } times a second, too few for { $expected } frames. Bring it nearer to this computer, or choose fewer frames a second.
# $board is the name of a board, $expected the rate that BrainFlow knows of it.
arrivals-brainflow-rate = { $measured } samples a second arrive from the board { $board }, but its stream has { $expected }: bring the board nearer to its receiver, or set it to { $expected } as its maker says.
