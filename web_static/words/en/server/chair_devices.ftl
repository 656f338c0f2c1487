### What chairs say of themselves, and why one cannot be used.

# $x and $y are the place in m.
chairdev-no-room = the chair cannot stand at ({ $x }, { $y }): something is in the way, choose a free place
# The virtual chair's pose can be reported to another program, at the address $place.
chairdev-no-report =
    reports cannot be sent to { $place } ({ $why ->
        [no-address] no such address
       *[other] { $why }
    }): give a host and port

# $name is the chair's name, $place its address HOST:PORT; $problem is a message device-key-...
chairdev-not-opened = the chair { $name } is not opened: { $problem }
chairdev-not-reached =
    the chair { $name } cannot be reached at { $place } ({ $why ->
        [no-address] no such host name
       *[other] { $why }
    }): correct its address
chairdev-silent = { $name } at { $place } does not answer: check its power and the network.
chairdev-switch-refuted = { $name } at { $place }: the report of its stop switch was an old one, press and release the switch again.
# $reason is a message chairdev-reason.
chairdev-telemetry =
    { $name } at { $place }, { $state ->
        [stop-switch] stop switch pressed
        [disarmed] disarmed
        [checking] waits for rest
        [armed] armed
       *[fault] not ready
    }{ $battery ->
        [unknown] {""}
       *[other] , battery { $battery } %
    }.{ $reason ->
        [none] {""}
       *[other] {" "}{ $reason }
    }
# Why a chair stands, as it reports itself. “Sender” is the program that commands it.
chairdev-reason =
    { $reason ->
        [silent] No new command reached the chair for too long.
        [stop_command] The chair received a stop.
        [withdrawn] The sender withdrew its permission to drive.
        [stop_input] The chair was stopped by its own switch.
        [not_neutral] After it was armed, the chair was not commanded to stand for the half second that it needs.
        [late] The chair's own computer stood still for too long.
        [output] The chair's electronics accepted no commands.
        [own_joystick] Somebody moved the chair's own joystick.
        [chair_error] The chair reports an error of its own: look at its display.
        [chair_off] The chair is switched off.
       *[ending] The chair's receiver was ended.
    }
