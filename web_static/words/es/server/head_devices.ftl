### What the head trackers say of themselves, and why one cannot be used.

headdev-simulated-rests = La cabeza simulada está en reposo.
headdev-simulated-looks = La cabeza simulada mira alrededor.
headdev-tablet-unused = La orientación de la tableta no se usa.
headdev-tablet-silent = No llega la orientación de ninguna tableta: abra la página en la tableta y permita que use el sensor.
headdev-tablet = La tableta indica su orientación.
headdev-recorded-rests = La cabeza grabada { $file } no se reproduce.
headdev-recorded-plays = Se reproduce la cabeza grabada { $file }.
headdev-recorded-short = { $file }: una cabeza grabada necesita al menos { $least } s y tiempos que aumenten, grábela de nuevo

# $tracker is opentrack or FreePIE, $place the address HOST:PORT on this machine.
headdev-udp-failed =
    no se puede recibir el seguimiento de la cabeza { $tracker } en { $place } ({ $why ->
        [no-address] no existe esa dirección
       *[other] { $why }
    }): use una dirección de este equipo y un puerto libre
headdev-udp-closed = No se está escuchando el seguimiento de la cabeza { $tracker }.
# $refused counts datagrams (packets of the network) that hold no pose of a head.
headdev-udp-silent =
    No llega la posición de la cabeza desde { $tracker } en { $place }{ $refused ->
        [0] {""}
        [one] , { $refused } datagrama rechazado
       *[other] , { $refused } datagramas rechazados
    }.
headdev-udp =
    Seguimiento de la cabeza { $tracker } en { $place }{ $refused ->
        [0] {""}
        [one] , { $refused } datagrama rechazado
       *[other] , { $refused } datagramas rechazados
    }.

# The Flock of Birds is a tracker of the company Ascension; FLY is a position of its switch.
headdev-flock-failed = no se puede abrir Flock of Birds en { $device } ({ $why }): compruebe el cable, la alimentación y el nombre del dispositivo
headdev-flock-lost =
    Se perdió Flock of Birds en { $device } ({ $why ->
        [unknown] dejó de estar conectado
       *[other] { $why }
    }): compruebe su cable y elíjalo otra vez.
headdev-flock-closed = Flock of Birds en { $device } no está abierto.
headdev-flock-silent = Flock of Birds en { $device } no envía nada: ponga su interruptor en FLY y compruebe sus baudios.
headdev-flock = Flock of Birds en { $device }.
