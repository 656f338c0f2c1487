### The kinds of shirts on the Shirt page; what shirts say of themselves, and why one cannot be used.

## The form of each kind of shirt: its title, what it is, how it is named when it is in use, its fields.

shirtdev-rate = Frames a second
shirtdev-file = File
shirtdev-key = Key
# In “ ” stands a command, which is not translated.
shirtdev-key-hint = Only a shirt with a key may drive a real chair. “bodydrive shirt pair” on this machine makes one.
# The document that names the shirt's sensors.
shirtdev-layout = Layout
shirtdev-layout-hint = A JSON file that names the sensors. Without one, the layout in use now is kept.
shirtdev-simulator-title = Simulated shirt
shirtdev-simulator-about = A fabric with 52 sensors, calculated from the body inside it.
shirtdev-simulator-in-use = Simulated shirt, { $rate } frames a second
# A number from 1 to 999; each is a shirt with other sensors.
shirtdev-simulator-seed = Which simulated shirt
shirtdev-simulator-sensors = Its sensors
shirtdev-simulator-all-work = All work
shirtdev-simulator-two-dead = Two are dead
shirtdev-replay-title = Replay of a file
shirtdev-replay-about = Signals that were recorded before, played as if they came now.
shirtdev-replay-in-use = Replay of { $file }
shirtdev-replay-loop = Begin again at the end
shirtdev-udp-title = A shirt over the network
shirtdev-udp-about = Frames that arrive by UDP on this machine.
shirtdev-udp-in-use = Network shirt on port { $port }
# An address of this machine.
shirtdev-udp-host = Listen on
shirtdev-udp-port = Port
# LSL is the Lab Streaming Layer, a network protocol of laboratories.
shirtdev-lsl-title = Streams of the Lab Streaming Layer
shirtdev-lsl-about = LSL: amplifiers, motion capture and other devices of a laboratory.
shirtdev-lsl-in-use = LSL streams
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

# $problem is a message device-key-...
shirtdev-not-opened = the shirt is not opened: { $problem }
shirtdev-udp-no-address = the shirt cannot be received on { $host }: this is no address, correct it
shirtdev-udp-failed = the shirt cannot be received on { $place } ({ $why }): use an address of this machine and a port that is free
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

# So that no old frame drives, the number of the newest one is stored in a file.
shirtdev-newest-unknown = { $file }: nothing says which frame of this shirt was the newest, and an old one must not drive: pair the shirt anew

## Why frames are not used: each stands in brackets, behind what is left out.

shirtdev-newest-not-stored = the number of the newest frame cannot be stored ({ $why }): free some disk space
shirtdev-frame-late = its frames arrive { $delay } s late, and a late one counts as none: bring the shirt nearer to its receiver, and check what else uses the network
shirtdev-frame-short = a datagram of { $size } bytes is too short to be a frame
shirtdev-frame-foreign = what arrives does not come from a shirt
shirtdev-frame-version = the shirt speaks version { $version } of the protocol, version { $understood } is understood
shirtdev-frame-flags = the shirt uses flags { $flags } that are not understood
shirtdev-frame-sensors = the shirt sends { $sent } sensors, its layout has { $expected }: use the layout of this shirt
shirtdev-frame-needs-key = the shirt signs its frames: choose its key
shirtdev-frame-not-signed = a frame was not signed with this shirt's key, or arrived damaged
shirtdev-frame-damaged = a frame arrived damaged
