### The kinds of shirts on the Shirt page; what shirts say of themselves, and why one cannot be used.

## The form of each kind of shirt: its title, what it is, how it is named when it is in use, its fields.

# Whether a kind of shirt may drive a real chair, where shirts are chosen.
shirtdev-chair-wired = May drive a real chair when its cable is plugged into this machine: only the shirt can send on it.
shirtdev-chair-with-key = May drive a real chair with a key only, for otherwise anybody on the network could send.
shirtdev-chair-nobody-wears = Never drives a real chair, for nobody wears it.
shirtdev-chair-nobody-proves = Never drives a real chair, for nothing proves whose movements it shows.
# What a kind -needs and -costs, and how long it -takes, stands in source-needs, source-costs, source-takes of shirt.ftl.
shirtdev-rate = Frames a second
shirtdev-file = File
shirtdev-key = Key
# In “ ” stands a command, which is not translated.
shirtdev-key-hint = Over the network, only a shirt with a key may drive a real chair. “bodydrive shirt pair” on this machine makes one.
# The document that names the shirt's sensors.
shirtdev-layout = Layout from a file
shirtdev-layout-hint = A JSON file that names the sensors. Without one, the layout in use now is kept.
shirtdev-simulator-title = Simulated shirt
shirtdev-simulator-about = A fabric with 52 sensors, calculated from the body inside it.
shirtdev-simulator-in-use = Simulated shirt, { $rate } frames a second
shirtdev-simulator-needs = nothing else
shirtdev-simulator-costs = nothing
shirtdev-simulator-takes = no time: it moves at once
# A number from 1 to 999; each is a shirt with other sensors.
shirtdev-simulator-seed = Which simulated shirt
shirtdev-simulator-sensors = Its sensors
shirtdev-simulator-all-work = All work
shirtdev-simulator-two-dead = Two are dead
shirtdev-replay-title = Replay of a file
shirtdev-replay-about = Signals that were recorded before, played as if they came now.
shirtdev-replay-in-use = Replay of { $file }
shirtdev-replay-needs = a recording of this program, or a file of signals (CSV or Parquet)
shirtdev-replay-costs = nothing
shirtdev-replay-takes = a minute
shirtdev-replay-loop = Begin again at the end
shirtdev-replay-layout-hint = A JSON file that names the columns, by their names or in their order. Without one, the columns say their joints, such as right_elbow_1.
shirtdev-serial-title = A shirt on a cable
shirtdev-serial-about = A board, such as an Arduino, that sends its sensors over USB or another serial line.
shirtdev-serial-in-use = Shirt on the cable at { $device }
shirtdev-serial-needs = a shirt with stretch sensors, a board such as an Arduino, and a USB cable
shirtdev-serial-costs = about €100 to 150
shirtdev-serial-takes = an afternoon to build, then a minute, then the calibration
shirtdev-serial-device = Serial line
shirtdev-serial-device-hint = As the system names it. A name under /dev/serial/by-id/ stays the same when the cable is put in again.
shirtdev-serial-baud = Baud rate
shirtdev-serial-format = Format
shirtdev-serial-format-hint = Frames have a checksum: a damaged one is left out. In a line, a lost digit changes a number.
shirtdev-serial-format-frames = Frames with a checksum
shirtdev-serial-format-lines = Plain lines of numbers
shirtdev-udp-title = A shirt over the network
shirtdev-udp-about = Frames that arrive by UDP on this machine.
shirtdev-udp-in-use = Network shirt on port { $port }
shirtdev-udp-needs = a shirt that sends frames by UDP, in the network of this machine
shirtdev-udp-costs = what the shirt costs
shirtdev-udp-takes = a minute, and another one to pair its key, then the calibration
# An address of this machine.
shirtdev-udp-host = Listen on
shirtdev-udp-port = Port
# Trackers: small sensors of orientation, each worn on one part of the body. SlimeVR and owoTrack are names.
shirtdev-slimevr-title = Trackers (SlimeVR)
shirtdev-slimevr-about = Small sensors of orientation on parts of the body, over the wireless network; phones with owoTrack, too.
shirtdev-slimevr-in-use = Trackers on port { $port }
shirtdev-slimevr-needs = two trackers or more, straps, and the wireless network of this machine
shirtdev-slimevr-costs = about €30 to 60 for each tracker
shirtdev-slimevr-takes = a minute after the trackers are in the network, then the calibration
shirtdev-slimevr-host-hint = 0.0.0.0 is every network of this machine: trackers look for it there.
shirtdev-trunk-hint = Sensors that send are offered. Head, upper arms and thighs are measured from this one.
shirtdev-chair-hint = Without a sensor on the trunk, this one stands in for it.
# A limb: an arm or a leg. Its neighbour is the next part towards the trunk, such as the upper arm for the forearm.
shirtdev-from-neighbour = Measure each part from its neighbour
# Parts of the body that wear a tracker: the label of a field, and in lists.
shirtdev-part-trunk = Trunk
shirtdev-part-chair = Chair
shirtdev-part-head = Head
shirtdev-part-left-upper-arm = Left upper arm
shirtdev-part-right-upper-arm = Right upper arm
shirtdev-part-left-forearm = Left forearm
shirtdev-part-right-forearm = Right forearm
shirtdev-part-left-hand = Left hand
shirtdev-part-right-hand = Right hand
shirtdev-part-left-fingers = Left fingers
shirtdev-part-right-fingers = Right fingers
shirtdev-part-left-thigh = Left thigh
shirtdev-part-right-thigh = Right thigh
shirtdev-part-left-lower-leg = Left lower leg
shirtdev-part-right-lower-leg = Right lower leg
shirtdev-part-left-foot = Left foot
shirtdev-part-right-foot = Right foot
shirtdev-bluetooth-title = Sensors over Bluetooth (WitMotion)
shirtdev-bluetooth-about = Small sensors of orientation on parts of the body, such as the WT901BLE.
shirtdev-bluetooth-in-use = Bluetooth sensors, { $rate } frames a second
shirtdev-bluetooth-needs = two sensors or more, straps, and a Bluetooth adapter with Low Energy (4.0 or newer)
shirtdev-bluetooth-costs = about €35 to 50 for each sensor; an adapter about €10
shirtdev-bluetooth-takes = a minute, then the calibration
# BrainFlow and OpenBCI are names. A board measures with electrodes or other sensors, and sends what it measures.
shirtdev-brainflow-title = A board (BrainFlow)
shirtdev-brainflow-about = Boards of OpenBCI and other makers, with electrodes or sensors of movement.
shirtdev-brainflow-in-use = Board { $board }
shirtdev-brainflow-needs = a board of BrainFlow's list, such as one of OpenBCI
shirtdev-brainflow-costs = about €150 for a muscle sensor to over €1,000 for an amplifier
shirtdev-brainflow-takes = some minutes, then the calibration
shirtdev-brainflow-board = Board
shirtdev-brainflow-board-hint = As BrainFlow's list of boards names it, such as CYTON_BOARD, or its number there.
# What of the board's data is used. accel, gyro and so on are names that are typed, and are not translated.
shirtdev-brainflow-data = Data
shirtdev-brainflow-data-hint = Names with commas between them: accel (acceleration), gyro, analog, resistance, exg (all electrodes), emg, or what else the board has.
# A board can send up to three streams, each at a rate of its own.
shirtdev-brainflow-preset = Stream
shirtdev-brainflow-preset-hint = Some boards send the acceleration in their second stream.
shirtdev-brainflow-preset-default = Main stream
shirtdev-brainflow-preset-auxiliary = Second stream (auxiliary)
shirtdev-brainflow-preset-ancillary = Third stream (ancillary)
shirtdev-brainflow-needs-hint = Fill in what BrainFlow's list asks for with this board, and leave the rest empty.
# Of a Bluetooth device.
shirtdev-brainflow-mac = MAC address
shirtdev-brainflow-ip = IP address
shirtdev-brainflow-port-hint = 0 where the board needs none.
shirtdev-brainflow-number = Serial number
# What else BrainFlow's list asks for with some boards.
shirtdev-brainflow-other = Other details
shirtdev-brainflow-layout-hint = A JSON file that names the sensors. Without one, each kind of data is a joint.
shirtdev-phones-title = Phones as sensors
shirtdev-phones-about = Up to six phones or tablets, tied to parts of the body, show how these turn. Each opens a page and sends; nothing is installed.
shirtdev-phones-in-use = Phones, { $rate } frames a second
shirtdev-phones-needs = one to six phones or tablets with a current browser, and something that ties them on; pages over https
shirtdev-phones-costs = nothing, where there are such devices; an armband about €10
shirtdev-phones-takes = a minute for each phone, then the calibration
shirtdev-camera-title = A camera
shirtdev-camera-about = The camera of a tablet, laptop or phone follows the upper body; nobody wears anything. Its picture stays in the browser.
shirtdev-camera-in-use = Camera, { $rate } frames a second
shirtdev-camera-needs = a device with a camera and a current browser, and light from the front; a page over https, or on this machine itself
shirtdev-camera-costs = nothing, where there is such a device
shirtdev-camera-takes = a minute or two, then the calibration
shirtdev-camera-rate-hint = Choose fewer where the device does not keep up.
# LSL is the Lab Streaming Layer, a network protocol of laboratories.
shirtdev-lsl-title = Streams of the Lab Streaming Layer
shirtdev-lsl-about = LSL: amplifiers, motion capture and other devices of a laboratory.
shirtdev-lsl-in-use = LSL streams
shirtdev-lsl-needs = a device or program that sends numbers by LSL, in the network of this machine
shirtdev-lsl-costs = nothing, where there is such a device
shirtdev-lsl-takes = a minute, then the calibration
shirtdev-lsl-name = Name of the stream
shirtdev-lsl-name-hint = Leave empty what does not matter. Several values, separated by commas, join as many streams.
# What names the device that sends the stream.
shirtdev-lsl-source = Source ID
# The kind of what the stream contains, such as EEG or MoCap.
shirtdev-lsl-type = Type
# The computer that sends the stream.
shirtdev-lsl-host = Computer
shirtdev-lsl-rate-hint = Counts only for streams that have no rate of their own.
shirtdev-lsl-layout-hint = A JSON file that names the sensors. Without one, the streams name them.

## Why a shirt may not drive a real chair.

shirtdev-nobody-wears = A simulated or played shirt arms no real chair, for nobody wears it: choose the worn shirt on the Shirt page.
shirtdev-nobody-proves = This source arms no real chair, for nothing proves whose movements it shows: choose the worn shirt on the Shirt page.
shirtdev-no-key = A shirt without a key arms no real chair, for anybody on the network could send its frames: pair it (bodydrive shirt pair), then choose its key on the Shirt page.
shirtdev-no-cable = This shirt arms no real chair, for its serial line belongs to no device on this machine, and any program could send on it: choose the line of the shirt's cable on the Shirt page.

## What shirts say of themselves, and why one cannot be opened.

shirtdev-no-standard = { $file }: the standard shirt cannot be read ({ $why }), install again
shirtdev-no-channel = the shirt '{ $shirt }' has no channel '{ $channel }' that could be dead: correct its name

shirtdev-simulator-closed = The simulated shirt is closed.
# $rate is the count of frames a second.
shirtdev-simulator-empty = Simulated shirt, { $sensors } sensors at { $rate } Hz, with nobody in it.
shirtdev-simulator = Simulated shirt, { $sensors } sensors at { $rate } Hz, with a simulated body in it.

shirtdev-replay-closed = The replay is closed.
shirtdev-replay-ended = The replay of { $file } has ended: start it again, or choose “{ shirtdev-replay-loop }”.
# $note is a further sentence: what was mended, or is missing, in the times of the file.
shirtdev-replay =
    Replay of { $file }, { $sensors } sensors at { $rate } Hz, { $played } s of { $length } s.{ $note ->
        [none] {""}
       *[other] {" "}{ $note }
    }
shirtdev-replay-failed = { $file }: this cannot be read ({ $why }), check it
# $layout is the name of a file.
shirtdev-file-no-joint = { $file }: nothing says which joint the column '{ $column }' belongs to, put the shirt's layout beside the file as { $layout } or name the columns like right_elbow_1
shirtdev-recording-short =
    { $frames ->
        [one] { $folder }: this recording holds { $frames } frame of a shirt, name a longer one
       *[other] { $folder }: this recording holds { $frames } frames of a shirt, name a longer one
    }
shirtdev-recording-times = { $folder }: the times of this recording do not rise, name another one
shirtdev-recording-channels =
    { $channels ->
        [one] { $folder }: this recording has { $channels } channel and its layout { $named }, name another one
       *[other] { $folder }: this recording has { $channels } channels and its layout { $named }, name another one
    }
shirtdev-recording-rate = { $folder }: this recording does not say its sample rate, name another one
# The place of a problem, in front of a colon or comma and the problem.
shirtdev-file-columns = { $file }: its columns make no layout
shirtdev-recording-layout = { $folder }: the shirt's layout in this recording

# $why is the reason that the system gives, $lines a list of serial lines that are there.
shirtdev-serial-failed =
    { $cause ->
        [missing] the shirt on { $device } cannot be opened ({ $why }): put its cable in{ $lines ->
            [none] {""}
           *[other] , or choose the name that the line has now: { $lines }
        }
        [forbidden] the shirt on { $device } cannot be opened ({ $why }): let this program use serial lines, on most systems by adding its account to the group dialout
        [busy] the shirt on { $device } cannot be opened ({ $why }): end the other program that uses it
       *[other] the shirt on { $device } cannot be opened ({ $why }): check its cable and its baud rate
    }
shirtdev-serial-closed = No serial line is open for the shirt.
shirtdev-serial-lost = The shirt on { $device } is gone: put its cable in again, and its signals come back by themselves.
shirtdev-serial-silent = Nothing arrives from the shirt on { $device }: check that its board has power and runs its program.
# $trouble is a message shirtdev-serial-foreign or shirtdev-frame-...
shirtdev-serial-unreadable = What arrives on { $device } is no frame of this shirt ({ $trouble }).
# Stands in brackets, behind what is left out.
shirtdev-serial-foreign = choose the format and the baud rate of the board's program
# $refused counts what arrived and was no frame of this shirt; $delay are the seconds by which the newest frame came late.
shirtdev-serial =
    Shirt on { $device }, { $sensors } sensors{ $lost ->
        [0] {""}
        [one] , { $lost } frame lost
       *[other] , { $lost } frames lost
    }{ $refused ->
        [0] {""}
       *[other] , { $refused } times something else arrived ({ $trouble })
    }{ $late ->
        [yes] , { $delay } s late
       *[no] {""}
    }.

# $problem is a message device-key-...
shirtdev-not-opened = the shirt is not opened: { $problem }
shirtdev-udp-no-address = the shirt cannot be received on { $host }: this is no address, correct it
shirtdev-udp-failed =
    { $cause ->
        [taken] the shirt cannot be received on { $place } ({ $why }): end the other program that listens there, or use a port that is free
        [forbidden] the shirt cannot be received on { $place } ({ $why }): use a port from 1024 up
        [elsewhere] the shirt cannot be received on { $place } ({ $why }): use an address of this machine, or 0.0.0.0 for all of them
       *[other] the shirt cannot be received on { $place } ({ $why }): use an address of this machine and a port that is free
    }
# $trouble is a message shirtdev-newest-not-stored or shirtdev-frame-...
shirtdev-udp-closed =
    Nothing listens for the shirt{ $trouble ->
        [none] {""}
       *[other] {" "}({ $trouble })
    }.
# $sender and $stranger are addresses. Left out are frames that do not count.
shirtdev-udp-silent =
    No frames from { $sender ->
        [unknown] a shirt
       *[other] { $sender }
    } on { $place }{ $trouble ->
        [none] {""}
       *[other] {" "}({ $trouble })
    }{ $other ->
        [0] {""}
        [one] , { $other } frame of another sender ({ $stranger }) left out
       *[other] , { $other } frames of another sender ({ $stranger }) left out
    }{ $repeated ->
        [0] {""}
        [one] , { $repeated } repeated frame left out
       *[other] , { $repeated } repeated frames left out
    }{ $late ->
        [0] {""}
        [one] , { $late } late frame left out
       *[other] , { $late } late frames left out
    }.
# $refused counts datagrams (packets of the network) that hold no good frame of this shirt.
shirtdev-udp =
    Shirt on { $place } from { $sender }, { $sensors } sensors{ $lost ->
        [0] {""}
        [one] , { $lost } frame lost
       *[other] , { $lost } frames lost
    }{ $refused ->
        [0] {""}
        [one] , { $refused } datagram refused{ $trouble ->
            [none] {""}
           *[other] {" "}({ $trouble })
        }
       *[other] , { $refused } datagrams refused{ $trouble ->
            [none] {""}
           *[other] {" "}({ $trouble })
        }
    }{ $other ->
        [0] {""}
        [one] , { $other } frame of another sender ({ $stranger }) left out
       *[other] , { $other } frames of another sender ({ $stranger }) left out
    }{ $repeated ->
        [0] {""}
        [one] , { $repeated } repeated frame left out
       *[other] , { $repeated } repeated frames left out
    }{ $late ->
        [0] {""}
        [one] , { $late } late frame left out
       *[other] , { $late } late frames left out
    }.

shirtdev-camera-closed = The camera is not in use.
# $late and $refused count what is left out; $delay is how late the newest one was.
shirtdev-camera-silent =
    No camera sends: start it on the Shirt page or on the patient's screen{ $late ->
        [0] {""}
       *[other] {" "}(its pictures arrived { $delay } s late, and a late one is not used: close other programs on that device, or choose fewer frames a second)
    }{ $refused ->
        [0] {""}
        [one] , { $refused } message refused
       *[other] , { $refused } messages refused
    }.
shirtdev-camera-nobody =
    The camera sees nobody, and its { $sensors } sensors are missing: sit so that head, shoulders and arms are in the picture{ $lost ->
        [0] {""}
        [one] , { $lost } frame lost
       *[other] , { $lost } frames lost
    }{ $refused ->
        [0] {""}
        [one] , { $refused } message refused
       *[other] , { $refused } messages refused
    }{ $late ->
        [0] {""}
        [one] , { $late } late picture left out
       *[other] , { $late } late pictures left out
    }.
# $pictures is the measured count a second, $delay the age of the newest picture in ms.
shirtdev-camera =
    Camera, { $sensors } sensors, { $pictures } pictures a second, each { $delay } ms old when it arrives{ $lost ->
        [0] {""}
        [one] , { $lost } frame lost
       *[other] , { $lost } frames lost
    }{ $refused ->
        [0] {""}
        [one] , { $refused } message refused
       *[other] , { $refused } messages refused
    }{ $late ->
        [0] {""}
        [one] , { $late } late picture left out
       *[other] , { $late } late pictures left out
    }.

shirtdev-lsl-no-library = LSL is not installed completely: install the packages pylsl and liblsl, then try again
# One stream, in a sentence that lists several. $type, $source (its source ID) and $host can be 'none'.
shirtdev-lsl-stream =
    { $name } ({ $source ->
        [none] {""}
       *[other] source ID { $source },{" "}
    }{ $type ->
        [none] {""}
       *[other] type { $type },{" "}
    }computer { $host })
shirtdev-lsl-nothing = no LSL stream of numbers is on this network: start the program that sends it, and permit UDP and TCP from port 16571 to 16604
# $sought is a list of what was entered, $streams one of streams.
shirtdev-lsl-none = no LSL stream fits { $sought }, the network has { $streams }: correct what the stream must be, or start the program that sends it
shirtdev-lsl-several = { $count } LSL streams fit, such as { $streams }: enter the source ID or the computer of one, or several source IDs with commas between them to join these streams
shirtdev-lsl-no-answer = the LSL stream { $stream } does not answer: permit UDP and TCP from port 16572 to 16604 between both computers
shirtdev-lsl-channels = the LSL streams have { $channels } channels together, at most { $most } can be used: choose fewer streams
shirtdev-lsl-misfit =
    { $channels ->
        [one] the LSL streams have { $channels } channel and the layout { $named }: bring another layout, or none
       *[other] the LSL streams have { $channels } channels and the layout { $named }: bring another layout, or none
    }
shirtdev-lsl-rate = the fastest LSL stream has { $rate } samples a second, { $low } to { $high } can be used: choose another one
shirtdev-lsl-closed = No LSL stream is open.
# $streams is a list of streams.
shirtdev-lsl-silent = No samples from { $streams }.
# $age is how long ago the newest sample was measured, $gone a list of streams whose senders have ended.
shirtdev-lsl =
    LSL streams, { $sensors } sensors at { $rate } Hz, { $age } ms old{ $lost ->
        [0] {""}
        [one] , { $lost } frame lost
       *[other] , { $lost } frames lost
    }{ $gone ->
        [none] {""}
       *[other] ; nothing more comes from { $gone }
    }.

shirtdev-brainflow-no-library = boards need the library BrainFlow ({ $why }): install it with pip install 'bodydrive[brainflow]', then choose the board again
# $boards is a list of names of boards.
shirtdev-brainflow-no-board = BrainFlow has no board { $given }: write the name or the number of one, such as { $boards }
shirtdev-brainflow-nobody-wears = { $board } plays or makes signals, and nobody wears it: choose a real board, or the simulated shirt, or the replay of a file
shirtdev-brainflow-no-stream = the board { $board } has no such stream: choose another one
# $kinds is a list of names such as accel.
shirtdev-brainflow-no-data = this stream of the board { $board } has { $kinds }: write one of these as its data, or several with commas between them
shirtdev-brainflow-channels = the board { $board } has { $channels } channels with these data, at most { $most } can be used: write fewer kinds
shirtdev-brainflow-misfit =
    { $channels ->
        [one] the board has { $channels } channel with these data and the layout { $named }: bring another layout, or none
       *[other] the board has { $channels } channels with these data and the layout { $named }: bring another layout, or none
    }
shirtdev-brainflow-rate = this stream of the board { $board } has { $rate } samples a second, { $low } to { $high } can be used: choose another one
shirtdev-brainflow-failed =
    { $cause ->
        [port] the board { $board } cannot be opened ({ $why }): check its serial line, and end the other program that uses it
        [missing] the board { $board } cannot be opened ({ $why }): switch it on, and bring it nearer
        [fields] the board { $board } cannot be opened ({ $why }): fill in what BrainFlow's list asks for with it
       *[other] the board { $board } cannot be opened ({ $why }): check that it is on, and what was filled in
    }
shirtdev-brainflow-closed = No board is open.
shirtdev-brainflow-silent =
    Nothing arrives from the board { $board }{ $why ->
        [none] {""}
       *[other] {" "}({ $why })
    }: switch it on, and its signals come back by themselves.
# $age is how much longer the newest sample took than the quickest one.
shirtdev-brainflow =
    Board { $board }, { $sensors } sensors at { $rate } Hz, { $age } ms later than the quickest{ $lost ->
        [0] {""}
        [one] , { $lost } frame lost
       *[other] , { $lost } frames lost
    }.

# So that no old frame drives, the number of the newest one is stored in a file.
shirtdev-newest-unknown = { $file }: nothing says which frame of this shirt was the newest, and an old one must not drive: pair the shirt anew

# $sensor is the name of a sensor: the address of a tracker, perhaps with a number and flex.
shirtdev-slimevr-no-name = '{ $given }' is no tracker's address: write it like A1:B2:C3:D4:E5:F6, with /1 for a second sensor and /flex for a strain sensor
shirtdev-sensor-twice = the sensor { $sensor } is on two parts of the body: leave one of them empty
shirtdev-slimevr-flex-chair = the sensor { $sensor } has no orientation: choose another one for the chair, or leave that empty
shirtdev-slimevr-closed = Nothing listens for trackers.
# $refused counts datagrams (packets of the network) that are none of a tracker.
shirtdev-slimevr =
    Trackers on { $place }: { $sending } of { $placed } send, { $sensors } sensors{ $refused ->
        [0] {""}
        [one] , { $refused } datagram refused
       *[other] , { $refused } datagrams refused
    }.
# $sensors is a list of addresses.
shirtdev-slimevr-found = On no part of the body: { $sensors }. Choose each beside the part that wears it.
shirtdev-phones-no-number = '{ $given }' is the number of no phone: write one from 1 to { $most }
shirtdev-phones-closed = The phones are not in use.
# $late and $refused count what is left out; $delay is how late the newest one was.
shirtdev-phones =
    Phones: { $sending } of { $placed } send, { $sensors } sensors{ $refused ->
        [0] {""}
        [one] , { $refused } message refused
       *[other] , { $refused } messages refused
    }{ $late ->
        [0] {""}
        [one] , { $late } late message left out (the newest took { $delay } s longer than the quickest)
       *[other] , { $late } late messages left out (the newest took { $delay } s longer than the quickest)
    }.
# $phones is a list of numbers.
shirtdev-phones-found = On no part of the body: phone { $phones }. Choose each beside the part that wears it.
shirtdev-bluetooth-no-address = '{ $given }' is no address of a Bluetooth sensor: write it like A1:B2:C3:D4:E5:F6
# $why, here and below, is what a library or the system says.
shirtdev-bluetooth-no-library = Bluetooth sensors need the library bleak ({ $why }): install it with pip install 'bodydrive[bluetooth]', then choose them again
shirtdev-bluetooth-failed =
    this computer's Bluetooth cannot be used{ $why ->
        [none] {""}
       *[other] {" "}({ $why })
    }: check that it has a Bluetooth adapter, switch that on, and let this program's account use it
shirtdev-bluetooth-closed = The Bluetooth sensors are not in use.
# $refused counts messages that are none of such a sensor, $repeated those with nothing new in them; $trouble is what
# the system's Bluetooth says.
shirtdev-bluetooth =
    Bluetooth: { $sending } of { $placed } send, { $sensors } sensors{ $refused ->
        [0] {""}
        [one] , { $refused } message refused
       *[other] , { $refused } messages refused
    }{ $repeated ->
        [0] {""}
        [one] , { $repeated } message repeated
       *[other] , { $repeated } messages repeated
    }{ $trouble ->
        [none] {""}
       *[other] {" "}({ $trouble })
    }.
# In the next four, $parts is a list of parts of the body.
shirtdev-sensors-silent = Silent: { $parts }. Switch these on, and check their network.
shirtdev-sensors-moving = Not yet at rest: { $parts }. Stay still for a second, arms down.
shirtdev-sensors-drift = Drifts by more than 2° a second: { $parts }. Lay it down for a minute, or calibrate the sensor as its maker says.
shirtdev-sensors-battery = Battery almost empty: { $parts }. Charge it.

## Why frames are not used: each stands in brackets, behind what is left out.

shirtdev-newest-not-stored = the number of the newest frame cannot be stored ({ $why }): free some disk space
shirtdev-frame-late = its frames arrive { $delay } s late, and a late one is not used: bring the shirt nearer to its receiver, and check what else uses the network
shirtdev-frame-short = a datagram of { $size } bytes is too short to be a frame
shirtdev-frame-foreign = what arrives does not come from a shirt
shirtdev-frame-version = the shirt speaks version { $version } of the protocol, version { $understood } is understood
shirtdev-frame-flags = the shirt uses flags { $flags } that are not understood
shirtdev-frame-sensors = the shirt sends { $sent } sensors, its layout has { $expected }: use the layout of this shirt
shirtdev-frame-needs-key = the shirt signs its frames: choose its key
shirtdev-frame-not-signed = a frame was not signed with this shirt's key, or arrived damaged
shirtdev-frame-damaged = a frame arrived damaged
