### Texts of the drive page: choosing a path, driving, a trial that is over.

drive-none-title = Todavía no hay con qué conducir
drive-none-lead = Primero la calibración: aprende qué movimientos puede hacer este cuerpo.
drive-none-go = Calibrar
drive-no-path = Este plano ya no tiene el recorrido “{ $path }”: elija otra tarea.
drive-title = ¿Adónde?
drive-why-first = Una primera tarea: los pasillos del estudio publicado. La silla se coloca en la salida.
drive-why-again = La última tarea que se hizo. La silla se coloca en la salida.
drive-why-next-level = Los tres últimos ensayos llegaron a la meta sin contacto y ninguno empeoró más allá de la variabilidad: esta tarea es un nivel más difícil.
drive-why-chosen = La tarea que usted eligió. La silla se coloca en la salida.
drive-choose = Elegir otra
drive-choose-title = Elegir una tarea
drive-choose-lead = Elija un tipo de tarea, después la dificultad y después la tarea.
drive-choose-groups = Tipos de tareas
drive-group-first = Primeros pasos
drive-group-corridors = Pasillos
drive-group-doors = Puertas
drive-group-obstacles = Obstáculos
drive-group-following = Seguir
drive-group-outdoors = Exterior
drive-group-own = Planos propios
drive-own-none = Esta clínica todavía no tiene planos propios.
drive-own-go = Dibujar o importar un plano
drive-places = Otros elementos de la conducción
drive-place-chair = Silla
drive-place-chair-unicycle = Virtual, responde al instante
drive-place-chair-wheelchair = Virtual, como una silla real
drive-place-chair-lead = Practique con la silla virtual o conduzca una real.
drive-place-screen = La pantalla del paciente
drive-place-screen-lead = Una segunda pantalla para el paciente: la vista, indicaciones grandes y la velocidad. En ella no se puede cambiar nada.
drive-place-plans = Planos
drive-place-plans-state = Dibujar o importar uno
drive-screens =
    { $count ->
        [one] { $count } vinculada
       *[other] { $count } vinculadas
    }
drive-screens-bad =
    { $count ->
        [one] { $count } vinculada, sin imagen
       *[other] { $count } vinculadas, no todas con imagen
    }
drive-screens-away =
    { $count ->
        [one] { $count } vinculada, sin conexión
       *[other] { $count } vinculadas, no todas conectadas
    }
drive-screens-none = Ninguna vinculada
drive-done = Volver a la tarea
drive-level = Dificultad de “{ $plan }”
drive-no-shirt = Un ensayo necesita una camiseta: todavía no se ha elegido ninguna.
drive-no-shirt-go = Elegir camiseta
drive-obstacle-shirt = Ir a la camiseta
drive-obstacle-calibrate = Calibrar
drive-obstacle-controls = Ir a los controles
drive-start = Empezar ensayo
drive-start-plan = Empezar con el plano dibujado
drive-length = { $length } m
drive-size = { $width } × { $height } m
drive-body-person-practised = Conduce la persona simulada, con práctica.
drive-body-person-novice = Conduce la persona simulada, sin experiencia.
drive-body-visitor = Usted conduce con los botones o las teclas.
drive-body-recorded = Los movimientos grabados de una persona conducen la silla. No siguen el recorrido.
drive-body-patient = Conduce el paciente.
drive-body-change = Cambiar
drive-camera = Muévala usted con esta cámara
drive-camera-hint = Graba sus movimientos, no la imagen, y los borra al final.
drive-plan-label = Plano de { $plan } con el recorrido “{ $path }”
task-path = Seguir la línea
task-follow = Seguir
task-turn = Girar
task-back = Marcha atrás
task-course = Circuito
trial-stage = { $stage } de { $stages } · { $title }
trial-turned = faltan { $left }°
trial-turned-over = { $left }° de más
trial-spot = a { $distance } m del punto
trial-behind-near = { $distance } m por detrás: demasiado cerca
trial-behind-right = { $distance } m por detrás: distancia correcta
trial-behind-far = { $distance } m por detrás: demasiado lejos
trial-name = Ensayo { $number } · { $plan }
trial-done = { $done } de { $length } m
trial-off = a { $distance } m del recorrido
trial-contacts =
    { $count ->
        [one] { $count } contacto
       *[other] { $count } contactos
    }
trial-above = Desde arriba
trial-above-line = Línea azul: en el suelo es blanca
trial-speed = Velocidad
trial-views = Vista
trial-view-eye = Ojo
trial-view-chase = Detrás
trial-view-top = Arriba
trial-view-free = Libre
trial-view-plan = Plano
trial-view-surface = Imagen: arrastre para girar, pellizque o use la rueda para acercar, y use dos dedos o Mayús para desplazar
trial-view-free-group = Vista libre
trial-view-free-left = Girar a la izquierda
trial-view-free-right = Girar a la derecha
trial-view-free-up = Más alto
trial-view-free-down = Más bajo
trial-view-free-nearer = Acercar
trial-view-free-farther = Alejar
trial-view-settings = Ajustes del ojo
trial-view-fov-deg = Campo de visión
trial-view-eye-height = Altura de los ojos
trial-view-roll-share = Inclinación de la cabeza
trial-view-roll-share-why = Qué parte de ella muestra la imagen. Ninguna es lo más cómodo.
trial-view-reduced = Esta pantalla pide menos movimiento: la imagen no se inclina.
trial-view-head = Seguimiento de la cabeza
trial-view-head-why = La vista sigue la dirección de la cabeza.
trial-view-head-on = Seguir
trial-view-pace = { $rate } imágenes por segundo, retraso de { $age } ms
trial-view-pace-slow = { $rate } imágenes por segundo, retraso de { $age } ms. La imagen va lenta en esta pantalla: cierre otras páginas o use una ventana más pequeña.
trial-plots = Gráficos
trial-end = Terminar
trial-ending = Midiendo…
trial-ending-why = El ensayo ha terminado. El resultado aparece aquí automáticamente; un ensayo largo tarda más.
trial-moment = Un momento…
trial-moment-why = Se está preparando la imagen.
trial-rest = Reposo…
trial-rest-why = Deje los brazos relajados. La silla está lista cuando el cuerpo está en reposo.
trial-go = ¡Ya!
trial-frame = Vista 3D de la silla en el edificio
trial-pause = En pausa
trial-pause-why = La silla y el reloj están detenidos. Ambos continúan solos cuando la pantalla mantiene el ritmo durante un segundo.
trial-pause-screen-lost = La pantalla que inició el ensayo no tiene conexión o va demasiado lenta.
trial-pause-screen-hidden = La página que inició el ensayo está oculta o se ha cerrado.
trial-pause-screen-slow = La pantalla que inició el ensayo dibuja demasiado despacio.
trial-pause-left = De lo contrario, el ensayo termina en { $left }
trial-pause-often = Esta pantalla es demasiado lenta para la vista 3D. El plano dibujado exige menos.
trial-paused = El ensayo espera a Continuar. Si no se continúa, termina en { $left }
over-goal = Meta alcanzada
over-time-out = Se acabó el tiempo
over-by-hand = Terminado a mano
over-fault = Terminado por una parada o un fallo
over-null = Ensayo
over-lead = Ensayo { $number } · { $plan } · { $path } · { $when }
over-driven = Trayectoria sobre el recorrido
over-no-trajectory = Falta la grabación de este ensayo, así que no hay trayectoria. Sus medidas se conservan.
over-no-measures = Este ensayo fue demasiado corto para medirlo. La próxima vez, conduzca un poco más.
over-not-reached = No se alcanzó la meta, así que este ensayo no se puede comparar con otros.
over-way = Llegó a { $done } m de los { $length } m del recorrido.
over-not-done = La tarea no se completó, así que su tiempo no se puede comparar con el de otros ensayos.
over-stages = Etapa por etapa
over-stage-done = hecha
over-stage-open = sin hacer
over-table = Comparado con los ensayos anteriores
over-measures = Todas las medidas de este ensayo
over-measure = Medida
over-this = Este ensayo
over-previous = Ensayo { $number }
over-best = Mejor hasta ahora
over-path-length = recorrido de { $length } m
over-discard = Descartar…
over-discard-title = ¿Por qué no cuenta este ensayo?
over-discard-interrupted = Se interrumpió
over-discard-sensor = Falló un sensor
over-discard-practice = Era solo práctica
over-discard-other = Otro motivo
over-discard-go = Descartar este ensayo
over-discarded = No cuenta: { $reason }
over-discarded-toast = El ensayo { $number } ya no cuenta.
over-keep = Volver a contarlo
over-count = Contarlo
over-counted-toast = El ensayo { $number } cuenta.
over-next = Otro ensayo
over-harder = Un nivel más difícil
over-other = Otra tarea
