### What chairs say of themselves, and why one cannot be used.

# $x and $y are the place in m.
chairdev-no-room = la silla no puede estar en ({ $x }; { $y }): hay algo en medio, elija un lugar libre
# The virtual chair's pose can be reported to another program, at the address $place.
chairdev-no-report =
    la posición de la silla no se puede enviar a { $place } ({ $why ->
        [no-address] no existe esa dirección
       *[other] { $why }
    }): indique una dirección y un puerto

# $name is the chair's name, $place its address HOST:PORT; $problem is a message device-key-...
chairdev-not-opened = no se abre la silla “{ $name }”: { $problem }
chairdev-not-reached =
    no hay conexión con la silla “{ $name }” en { $place } ({ $why ->
        [no-address] no existe ese nombre de equipo
       *[other] { $why }
    }): corrija su dirección
chairdev-silent = “{ $name }” en { $place } no responde: compruebe su alimentación y la red.
chairdev-switch-refuted = “{ $name }” en { $place }: el aviso de su interruptor de parada era antiguo, pulse y suelte el interruptor otra vez.
# $reason is a message chairdev-reason.
chairdev-telemetry =
    “{ $name }” en { $place }, { $state ->
        [stop-switch] interruptor de parada pulsado
        [disarmed] deshabilitada
        [checking] espera reposo
        [armed] habilitada
       *[fault] no está lista
    }{ $battery ->
        [unknown] {""}
       *[other] , batería al { $battery } %
    }.{ $reason ->
        [none] {""}
       *[other] {" "}{ $reason }
    }
# Why a chair stands, as it reports itself. “Sender” is the program that commands it.
chairdev-reason =
    { $reason ->
        [silent] La silla no recibió ningún comando nuevo durante demasiado tiempo.
        [stop_command] La silla recibió una parada.
        [withdrawn] El emisor retiró su permiso para conducir.
        [stop_input] La silla se detuvo con su propio interruptor.
        [not_neutral] La silla no recibió el comando de quedarse quieta durante el medio segundo posterior a habilitarla.
        [late] El equipo de la propia silla no respondió durante demasiado tiempo.
        [output] La electrónica de la silla no aceptó ningún comando.
        [own_joystick] Alguien movió el joystick de la propia silla.
        [chair_error] La silla comunica un error propio: mire su pantalla.
        [chair_off] La silla está apagada.
       *[ending] El receptor de la silla se cerró.
    }
