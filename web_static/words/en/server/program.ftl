### The program itself: its processes, its machine, and what is read from files in a process of their own.

## The processes

realtime-granted = The control loop has real-time scheduling.
realtime-refused = Real-time scheduling was not granted: close other programs while driving.
realtime-memory-refused = Memory is not kept in RAM: a machine short of memory may delay the control loop.
realtime-memory-locked = The control loop's memory is kept in RAM.
computing-ended = The process that computes figures has ended: try again.
computing-too-long = This took more than { $limit } s to compute: close other programs, then try again.
python-faulty = Python { $version } has known faults in reading zip and tar files: import no archive and restore no backup of unknown origin, and install Python { $least } or newer.
network-page-first = A device that warns of the certificate opens { $page } first: the page there explains what to do.

## What is wrong with a file: the end of a sentence that begins with the file's name.

reading-failed = this file could not be read, or takes too long: save it anew or make it smaller
reading-too-long = reading this file takes too long: make it smaller, then add it again
reading-memory = this needs too much memory, make it smaller

## Names

names-two-scripts = In '{ $word }' letters of two scripts stand together: type it in one script.
names-code-taken = There is a patient of the code '{ $other }' already, and '{ $name }' looks the same: choose another one.
names-file-taken = There is a file or plan '{ $other }' already, and '{ $name }' looks the same: choose another name.
names-person-taken = There is somebody called '{ $other }' already, and '{ $name }' looks the same: choose another name.

## The source of a recording: "Simulated shirt (simulated person), virtual chair: practice only"

source-shirt-simulator = Simulated shirt
source-shirt-replay = Recorded signals
source-shirt-serial = Worn shirt on a cable
source-shirt-udp = Worn shirt
source-shirt-slimevr = Worn trackers
source-shirt-camera = Camera
source-shirt-phones = Worn phones
source-shirt-bluetooth = Worn Bluetooth sensors
source-shirt-brainflow = Worn board (BrainFlow)
source-shirt-lsl = Signals over LSL
source-shirt-unknown = Shirt not recorded
source-other-shirt = Shirt of the kind '{ $kind }'
source-body-person = simulated person
source-body-visitor = moved on the screen
source-body-recorded = recorded body
source-chair-virtual = virtual chair
source-chair-udp = real chair
source-chair-unknown = chair not recorded
source-other-chair = chair of the kind '{ $kind }'
source-with-body = { $shirt } ({ $body })
source-signals = { $shirt }, { $chair }
source-practice-only = { $source }: practice only

## The layout of a shirt: the end of a sentence that begins with the file or form.

layout-channel-twice = channel '{ $name }' stands there twice: give each its own name
layout-joint-twice = joint '{ $name }' stands there twice: give each its own name
layout-no-joint = channel '{ $channel }' names joint '{ $joint }', which is not among the joints: add it or use one of { $joints }
layout-no-channel = joint '{ $joint }' has no channel: give it one or leave it out
layout-no-ring = channel '{ $channel }' has a place but no ring: name its ring or leave out the place
layout-ring-of-several = ring '{ $ring }' goes round several joints: give each joint a ring of its own
layout-ring-places =
    { $count ->
        [one] ring '{ $ring }' has { $count } sensor, so that its place must be { $last } or left out
       *[other] ring '{ $ring }' has { $count } sensors, so that their places must be 0 to { $last }, each once, or left out for all of them
    }
