### Texts of the page that a share link opens.

share-heading = Historial compartido
share-title = Historial de { $code }
share-pin = PIN de este enlace
share-pin-words = La clínica se lo comunicó por separado.
share-open = Abrir
share-until = Este enlace se puede abrir hasta el { $day }. Lo que muestra es confidencial.
share-no-link = Esta dirección no está completa: abra el enlace entero que envió la clínica.
share-failed = El equipo de la clínica no responde: inténtelo más tarde.
share-session = Sesión { $number }
share-goal = Objetivo
share-signed = Firmada
share-unsigned = Sin firmar
# What a trial was driven with.
share-source-simulated = simulado
share-source-camera = cámara
share-source-phones = teléfonos
share-source-slimevr = rastreadores
share-source-bluetooth = sensores Bluetooth
share-source-brainflow = placa
share-source-lsl = LSL
share-task = { $plan }: { $path }
share-trajectories =
    { $count ->
        [one] Recorrido indicado (discontinuo) y { $count } trayectoria
       *[other] Recorrido indicado (discontinuo) y { $count } trayectorias
    }
share-curve = Área fuera del recorrido (m²), ensayo por ensayo
share-values = { $first } en el primer ensayo, { $newest } en el más reciente.
share-verdicts = La sesión más reciente frente a la anterior
share-no-area = Ningún ensayo alcanzó la meta. Por eso no se muestra el área fuera del recorrido: solo se puede comparar la del recorrido entero.
share-no-verdict = Demasiado pocos ensayos para una valoración.
share-event-begin = Comienzo de la sesión
share-event-calibration =
    { $count ->
        [one] Calibración: { $count } grabación
       *[other] Calibración: { $count } grabaciones
    }
share-event-map = Calibración, versión { $version }
share-event-parameters = Controles guardados: { $text }
share-event-trial = Ensayo { $number }, { $text }: { $end }
share-event-test = Prueba de dos minutos { $number }
share-event-stop = Parada
share-event-drive = Conducción de la silla
share-event-note = Nota
share-event-comment = Comentario sobre el ensayo { $number } en { $t } s
share-event-sign-off = Firma
share-event-unlock = Desbloqueo
share-event-end = Fin de la sesión
