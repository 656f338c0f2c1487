### Texts of the two-minute test before driving.

rail-interface-test = Prueba de dos minutos
test-lead = Aparecen dianas en una cruz, y el paciente lleva un punto hasta cada una con los movimientos de los controles. Mientras tanto no se mueve ninguna silla. La prueba muestra si los movimientos funcionan bien hoy, antes de conducir.
test-cross = Cruz con una diana y un punto: arriba es más rápido, abajo es más lento, izquierda y derecha es girar
test-before = El punto está en el centro. El paciente permanece en reposo, y la prueba comienza tres segundos después de tocar “Empezar prueba”.
test-wait = La prueba comienza.
test-phase-ready = Reposo. La primera diana aparece en un momento.
test-phase-running = Lleve el punto hasta la diana y manténgalo allí un segundo.
test-phase-over = Terminada. Se está calculando el resultado.
test-count =
    { $count ->
        [one] { $count } diana alcanzada
       *[other] { $count } dianas alcanzadas
    }
test-start = Empezar prueba
test-end-it = Terminar prueba
test-drive = Ir a conducir
test-result = Prueba { $number }
test-session = Sesión { $number }
test-number = Prueba
test-reached = Dianas alcanzadas: { $acquired }. Dianas no alcanzadas en { $seconds } s: { $missed }.
test-so-far =
    { $count ->
        [one] Hasta ese momento, tras { $seconds } s: { $count } diana.
       *[other] Hasta ese momento, tras { $seconds } s: { $count } dianas.
    }
test-end-by-hand = Esta prueba se terminó antes de tiempo, así que no cuenta.
test-end-stopped = Esta prueba se detuvo, así que no cuenta.
test-end-fault = Esta prueba se interrumpió porque la camiseta o el programa dejaron de enviar señales. No cuenta.
test-end-complete = La grabación de esta prueba no se puede leer, así que no tiene cifras.
test-details = Más cifras y su significado
test-ways = Caminos hacia las dianas por dirección
test-ways-way = Camino
test-ways-acquired = Alcanzadas
test-ways-missed = Falladas
test-ways-time = Tiempo
test-way-ahead = Arriba (más rápido)
test-way-back = Abajo (más lento)
test-way-left = Izquierda
test-way-right = Derecha
test-publications = En las publicaciones: tasa de adquisición, rendimiento según ISO 9241-411 con la anchura efectiva, tiempo hasta la primera entrada, tiempo de ajuste final, eficiencia de la trayectoria.
test-curve = Evolución de las pruebas
test-one = A partir de la segunda prueba, aquí aparecen una curva y una comparación.
test-against = La más reciente frente a la prueba { $number }
test-noise = La variabilidad es cuánto difieren entre sí las pruebas de esta persona sin que haya un cambio; una valoración necesita cinco pruebas completas. Nunca se comparan pruebas de distinto origen, por ejemplo con camiseta simulada y con camiseta puesta.
test-workload = Exigencia de la prueba
test-workload-lead = Seis preguntas para el paciente, de 0 a 100. Se puede omitir cualquiera.
test-workload-mental = Mente: ¿cuánto hubo que pensar?
test-workload-physical = Cuerpo: ¿cuánto esfuerzo físico exigió?
test-workload-temporal = Tiempo: ¿cuánta prisa sintió?
test-workload-performance = Éxito: ¿cómo salió?
test-workload-effort = Esfuerzo: ¿cuánto tuvo que esforzarse?
test-workload-frustration = Ánimo: ¿cuánta molestia o desánimo sintió?
test-workload-low-other = Muy poco
test-workload-high-other = Mucho
test-workload-low-performance = Perfecto
test-workload-high-performance = Muy mal
test-workload-none = Sin respuesta
test-workload-leave-out = Omitir
test-workload-clear = Omitir: { $question }
test-workload-save = Guardar respuestas
test-workload-saved = Guardado.
test-workload-sum = Carga de trabajo (media de las seis): { $value } de 100.
test-workload-of = prueba { $number }: { $value }
patient-test-ready = Reposo. Una diana aparece en un momento.
patient-test-running = Lleve el punto hasta la diana.
patient-test-over = Terminado. Descanse un poco.
drive-place-test = Prueba de dos minutos
drive-place-test-state = Cómo funcionan hoy los movimientos
