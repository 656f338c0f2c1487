### Problems with the devices in general: their configurations, addresses, drivers, keys; the simulated body.

# $given is what a person wrote, in quotes.
device-no-host = { $given } is no address: write a name such as chair.local, or an address such as 192.168.1.20
device-no-line = { $given } is no serial line: write a name such as /dev/ttyUSB0 or COM3
device-no-cable = { $given } is a radio link (Bluetooth), over which others could send: connect the board by its cable

# $kind and $kinds are names in configurations, which are not translated: simulator, replay, serial, udp
device-unknown-kind =
    { $device ->
        [body] there is no body of the kind '{ $kind }': use one of { $kinds }
        [chair] there is no chair of the kind '{ $kind }': use one of { $kinds }
        [head] there is no head tracker of the kind '{ $kind }': use one of { $kinds }
       *[shirt] there is no shirt of the kind '{ $kind }': use one of { $kinds }
    }
device-needs-kind =
    { $device ->
        [body] a body configuration needs a "kind": give one of { $kinds }
        [chair] a chair configuration needs a "kind": give one of { $kinds }
        [head] a head tracker configuration needs a "kind": give one of { $kinds }
       *[shirt] a shirt configuration needs a "kind": give one of { $kinds }
    }
device-no-library =
    { $device ->
        [body] the body '{ $kind }' needs the library '{ $library }', which is not installed: install it
        [chair] the chair '{ $kind }' needs the library '{ $library }', which is not installed: install it
        [head] the head tracker '{ $kind }' needs the library '{ $library }', which is not installed: install it
       *[shirt] the shirt '{ $kind }' needs the library '{ $library }', which is not installed: install it
    }
# $driver is the name of a part of the program, such as app.hardware.head.opentrack.
device-no-driver =
    { $device ->
        [body] the driver { $driver } of the body '{ $kind }' is missing from this installation: install bodydrive again
        [chair] the driver { $driver } of the chair '{ $kind }' is missing from this installation: install bodydrive again
        [head] the driver { $driver } of the head tracker '{ $kind }' is missing from this installation: install bodydrive again
       *[shirt] the driver { $driver } of the shirt '{ $kind }' is missing from this installation: install bodydrive again
    }
device-no-class = the driver { $driver } has no class { $name }: correct its table in app/hardware

## The key that a shirt or a chair shares with this machine. Each also stands behind a colon.

device-key-unreadable = the key file { $file } cannot be read ({ $why }): give the file that pairing made
device-key-no-text = the key file { $file } cannot be read (it is no text): give the file that pairing made
# In ` ` stands a command, which is not translated.
device-key-not-private = the key file { $file } can be read by others: run `chmod 600 { $file }`, or pair anew
device-key-no-key = the key file { $file } holds no key: it must be one line, a number up to 65535, a space, 64 hex digits
device-key-changed = the key file { $file } holds another key than it did: choose it again

## The simulated body.

# $joint and $joints are names in configurations, which are not translated: right_elbow, left_wrist
bodydev-no-joint = this body has no joint '{ $joint }': use { $joints }
bodydev-no-place = joint '{ $joint }' cannot go to { $place }: give a place between 0 and 1
bodydev-file-no-joint = { $file }: there is no joint of the simulated body in this file, name columns like { $columns }
bodydev-file-times = { $file }: the times in column 't' do not rise from row to row, correct them
# The movement is repeated in a loop.
bodydev-file-short = { $file }: { $length } s of movement are too short to go round, give at least { $least } s
bodydev-file-slow = { $file }: a movement needs at least { $least } rows a second, record it again
bodydev-file-uneven = { $file }: the times in column 't' are too uneven, record it again without long gaps
