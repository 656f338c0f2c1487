### Texts of the owner's page "This computer". What was found comes in words from the server (app/host/machine_check.py).

rail-computer = Este equipo
computer-lead = Si este equipo y las pantallas abiertas ahora son adecuados para conducir.
computer-settings-go = Medir este equipo
computer-owner = Solo los administradores miden este equipo. Pida ayuda a uno de ellos.
computer-measured = Se mide si el bucle de control llega a tiempo, qué permisos le da el sistema, el espacio libre en el disco, el reloj, los puertos y cuántas imágenes por segundo dibuja cada pantalla abierta. Abra antes las pantallas que le interesan, mejor con la vista 3D.
computer-go = Medir durante { $seconds } s
computer-again = Medir otra vez
computer-measuring =
    { $left ->
        [one] Midiendo. Queda { $left } s.
       *[other] Midiendo. Quedan { $left } s.
    }
computer-counting = Midiendo. El resultado aparece en un momento.
computer-progress = Avance de la medición
computer-machine = Este equipo
computer-screens = Pantallas abiertas ahora
computer-screens-bad =
    { $count ->
        [one] { $count } pantalla abierta ahora no es adecuada.
       *[other] { $count } pantallas abiertas ahora no son adecuadas.
    }
computer-no-screens = No hay ninguna pantalla abierta.
computer-verdict-good = Bien
computer-verdict-attention = Mejorable
computer-verdict-bad = Insuficiente
