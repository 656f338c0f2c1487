### Texts of the real chair: choosing it, arming it, driving it, and the speed dial.

which-virtual = Silla virtual
which-feel = Comportamiento
which-feel-unicycle = Responde al instante
which-feel-unicycle-hint = Como en el estudio publicado.
which-feel-wheelchair = Como una silla real
which-feel-wheelchair-hint = Responde con retraso, las ruedas orientables tienen que girar y las ruedas motrices patinan un poco.
which-real = Silla real
which-real-go = Conducir “{ $name }”…
which-none = Todavía no hay ninguna vinculada.
which-none-go = Vincular
which-none-ask = Todavía no hay ninguna vinculada. Un administrador la vincula en Ajustes.
chair-title = Conducir “{ $name }”
chair-lead = Revise las tres tarjetas y después habilite la silla. El paciente está sentado en la silla y una persona está junto al interruptor de parada.
chair-lead-simulated = Revise las tres tarjetas y después habilite la silla. Una persona está junto al interruptor de parada de la silla.
chair-virtual = Usar la silla virtual
chair-card = La silla
chair-state-disarmed = Deshabilitada
chair-state-checking = Espera reposo
chair-state-armed = Habilitada
chair-state-fault = No está lista
chair-state-silent = Sin respuesta
chair-battery = Batería
chair-battery-unknown = sin datos
chair-switch = Interruptor de parada
chair-switch-pressed = pulsado
chair-switch-released = sin pulsar
chair-age = Última respuesta
chair-age-value = hace { $age } s
chair-now = ahora mismo
chair-never = nunca
chair-drives = Velocidad actual
chair-measured = Medida
chair-commanded = Ordenada
chair-drives-value = { $v } m/s, { $omega } °/s
chair-simulated = Demostración: el cuerpo simulado puede conducir esta silla, así que nadie debe sentarse en ella.
chair-switch-why = Suelte el interruptor de parada de la silla: mientras está pulsado, la silla no se mueve.
chair-joystick-why = Suelte el joystick de la propia silla: mientras se mueve, la silla solo le obedece a él.
apply-card = Ajustes que se aplicarán
apply-set = Configuración
apply-change = Cambiarla
apply-forward-back = Avance y retroceso
apply-turning = Giro
apply-level-clinic = el límite de la clínica
apply-level-chair = el límite de la silla
apply-level-dial = con el selector de velocidad al { $share }
apply-more = Aceleraciones, atenuación, huella
apply-hash = Huella
apply-hash-hint = Las configuraciones con la misma huella se conducen igual.
apply-crawls = Falta el documento de esta silla: no pasará de 0,3 m/s, indiquen lo que indiquen estos ajustes. Mida primero su joystick.
apply-document = Documento de la silla
apply-document-hint = Las primeras cifras de la huella del archivo que indica a qué velocidad mueve el joystick esta silla.
apply-cruise = Se detiene sola tras
apply-cruise-value = { $time } s sin movimiento
apply-turn-cruise = Deja de girar sola tras
apply-turn-cruise-value = { $time } s sin movimiento
apply-practised = Practicada
apply-practised-trials =
    { $count ->
        [one] { $count } ensayo con la silla virtual, { $when }
       *[other] { $count } ensayos con la silla virtual, el último: { $when }
    }
apply-differs = Diferencias con “{ $title }” ({ $hash }), la última que se practicó:
apply-unpractised = Todavía nadie ha conducido la silla virtual de esta clínica con esta configuración.
apply-practise = Practicarla ahora
differs-change = { $what }: { $before } → { $now }.
differs-title = Nombre de la configuración: “{ $before }” → “{ $now }”.
differs-profile = La calibración es otra.
differs-order = Los movimientos y los números son los mismos, pero se guardaron en otro orden.
differs-gesture-added = { $gesture }: movimiento nuevo.
differs-gesture-removed = { $gesture }: ya no se usa.
differs-gesture-joint = { $gesture }: ahora se hace con otra articulación.
differs-gesture-direction = { $gesture }: ahora cuenta en la otra dirección.
differs-gesture-from = { $gesture }, cuenta desde: { $before } → { $now }.
differs-gesture-full = { $gesture }, máximo en: { $before } → { $now }.
differs-gesture-moving = mover
differs-gesture-holding = mantener
differs-how-u1-acceleration = mantiene la velocidad
differs-how-u1-velocity = sigue el movimiento
differs-how-u2-acceleration = mantiene el giro
differs-how-u2-velocity = sigue el movimiento
differs-gain = { $gestures }, ganancia { $gain }
differs-nothing = nada
neutral-card = En reposo
neutral-lead = Antes de que la silla se mueva, todos los movimientos deben quedar por debajo de su marca durante medio segundo.
neutral-rest = El cuerpo está en reposo.
neutral-moves = En movimiento: { $gestures }.
neutral-no-shirt = La camiseta no envía señales, así que no se sabe nada del cuerpo: revísela en la página Camiseta.
neutral-stop = Gesto de parada: { $gestures }, a la vez.
neutral-no-stop = No hay ningún gesto de parada asignado: el paciente no puede parar la silla con el cuerpo. Asigne uno en la página Controles.
arm-go = Habilitar
arm-busy = Habilitando…
arm-ready = No falta nada. Tras habilitar la silla, conduce el paciente.
arm-missing =
    { $count ->
        [one] Falta una cosa:
       *[other] Faltan { $count } cosas:
    }
arm-missing-short =
    { $count ->
        [one] Falta una cosa, véala arriba.
       *[other] Faltan { $count } cosas, véalas arriba.
    }
arm-lost = Esta página no tiene conexión con el programa: espere hasta que vuelva.
arm-fault = Sigue activa una parada o un fallo: anule la parada en la franja de arriba.
arm-front = Mantenga esta página en primer plano mientras la silla se conduce. Si la página se oculta o pierde la conexión, la silla se detiene.
driving-title = Conducción de “{ $name }”
driving-checking = Reposo…
driving-checking-why = Deje los brazos relajados. La silla está lista cuando el cuerpo está en reposo.
driving-armed = En marcha
driving-armed-why = Conduce el paciente. STOP, la barra espaciadora y el gesto de parada detienen la silla.
driving-disarmed = Deshabilitada
driving-disarmed-why = La silla está detenida.
driving-speed = Velocidad
driving-reverse = marcha atrás
driving-turn-left = giro a la izquierda, { $turn } °/s
driving-turn-right = giro a la derecha, { $turn } °/s
driving-straight = en línea recta
driving-stands = detenida
driving-end = Terminar
driving-ending = Terminando…
driving-movements = Movimientos
driving-commands = Comandos
driving-paused = La conducción espera a Continuar y a un nuevo momento de reposo. Si no se continúa, termina en { $left }
driven-title = La conducción ha terminado
driven-distance = Distancia
driven-time = Tiempo
driven-end = Cómo terminó
driven-end-by-hand = Terminada a mano
driven-end-fault = Terminada por una parada o un fallo
driven-end-time-out = Se acabó el tiempo
driven-end-lost = El proceso de control terminó
driven-hash = Conducida con la configuración de huella { $hash }.
driven-again = Volver a la silla
driven-gone = Esta conducción ya no está en la lista: vuelva a la silla.
dial-title = Selector de velocidad
dial-label = Selector de velocidad, proporción de las velocidades
dial-up-to = hasta { $speed } m/s
dial-hint = Bajar la velocidad tiene efecto inmediato. Subirla tiene efecto cuando la silla está detenida y el cuerpo en reposo.
