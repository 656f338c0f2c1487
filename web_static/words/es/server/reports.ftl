### Texts of reports (PDF and HTML) of a session or of a patient's course of sessions, and refusals to make one.

# Refusals

report-no-session-yet = Este paciente todavía no tiene ninguna sesión: abra una primero y cree después el informe.
report-no-session = Este paciente no tiene la sesión { $session }: elija una que se haya abierto.
report-no-language = --language { $language } no se puede usar. Indique uno de estos: { $languages }.
# $refusal is a sentence: the patient has not consented to sharing outside the clinic.
report-needs-consent = { $refusal } Una copia para el paciente no necesita consentimiento.

# Head of the document

report-of-course =
    { $count ->
        [one] Evolución en { $count } sesión
       *[other] Evolución en { $count } sesiones
    }
report-of-session = Sesión { $session }
report-made = { $clinic }, informe del { $moment }
report-source = Origen:
report-no-source = No cuenta ningún ensayo, así que las señales no tienen origen.

# Headings and labels

report-goal = Objetivo
report-goals-between = Objetivos de las sesiones intermedias
report-trials = Ensayos
report-no-trial = No cuenta ningún ensayo.
report-tests = Pruebas de dos minutos
report-drives = Conducciones de sillas reales
report-condition = Condiciones
report-scales = Escalas
report-no-scale = No se anotó ninguna escala.
report-sessions = Sesiones
report-notes = Notas
report-comments = Comentarios sobre los ensayos
report-signature = Firma
# Below the line on which somebody signs on paper.
report-signature-line = Nombre, fecha y firma

# Facts: names and values

report-fact-reader = Destinatario
report-fact-reader-patient = Copia para el paciente
report-fact-when = Cuándo
# $first and $last are days.
report-days = del { $first } al { $last }
# $begun is a day with a time of day, $ended a time of the same day.
report-when-ended = { $begun } a { $ended }
report-when-open = { $begun }, todavía abierta
report-fact-opened = Apertura por
report-fact-opened-unknown = sin datos
report-fact-trials = Ensayos
report-trials-counted =
    { $count ->
        [one] cuenta { $count } ensayo
       *[other] cuentan { $count } ensayos
    }
report-trials-left-out =
    { $count ->
        [one] cuenta { $count } ensayo, excluidos: { $left } ({ $reasons })
       *[other] cuentan { $count } ensayos, excluidos: { $left } ({ $reasons })
    }
# A reason for which a trial was left out.
report-trial-not-measured = no se pudo medir
report-fact-imported = Importación
# Sessions that were held in another clinic: from $first to $last, of that clinic, imported by a person on a day.
report-imported =
    { $count ->
        [one] Sesión { $first } de { $clinic }, por { $person }, { $day }
       *[other] Sesiones { $first } a { $last } de { $clinic }, por { $person }, { $day }
    }
report-fact-software = Programa
# $recorded are the versions of the program with which the sessions were recorded.
report-software = bodydrive { $version }; grabado con { $recorded }
report-software-unknown = bodydrive { $version }; en el momento de la sesión: sin datos
report-fact-fingerprint = Huella de los controles (SHA-256)
report-fingerprint-none = ninguna: no se condujo nada
report-fact-head = Cabecera del registro
# The rows of the clinic's log, and the check sum of the newest one.
report-head =
    { $count ->
        [one] { $count } fila, { $hash }
       *[other] { $count } filas, { $hash }
    }
report-head-unknown = sin datos

# What people wrote

report-no-goal = No se anotó ningún objetivo.
report-no-note = No hay notas.
report-note = { $written }, { $person }
report-note-revised = { $written }, { $person }, corregida: { $revised }
# $remark is the head of a note or of a comment: who wrote it, and when.
report-remark-of-session = Sesión { $session }, { $remark }
# $plan is the title of the floor plan, $time a moment of the trial.
report-comment = { $plan }, ensayo { $number }, en { $time } s: { $person }, { $written }
report-comment-revised = { $plan }, ensayo { $number }, en { $time } s: { $person }, { $written }, corregido: { $revised }
report-comments-left-out =
    { $count ->
        [one] No se muestra { $count } comentario sobre ensayos anteriores.
       *[other] No se muestran { $count } comentarios sobre ensayos anteriores.
    }
report-signed = Firmada por { $person }, { $moment }.
report-signed-all = Todas las sesiones están firmadas, la última por { $person }, { $moment }.

# Tables of sessions and of outcome scales

report-sessions-session = Sesión
report-sessions-date = Fecha
report-sessions-opened = Abierta por
report-sessions-trials = Ensayos
report-sessions-discarded = Excluidos
report-sessions-signed = Firmada por
report-scales-scale = Escala
report-scales-total = Total
report-scales-totals = Totales, primero el más antiguo
report-scales-day = Fecha

# Condition: the calibration, the controls and their settings

report-condition-none = No se condujo nada, así que no hay condiciones que indicar.
report-condition-others =
    { $count ->
        [one] Se muestra la configuración más reciente; también se condujo con { $count } más.
       *[other] Se muestra la configuración más reciente; también se condujo con otras { $count }.
    }
report-fact-calibration = Calibración
# $origin is how this version of the calibration came about, $parent the version that it was made from (0: none),
# $methods how it was calibrated, $source what was worn, or saw the movements.
report-calibration =
    Versión { $version }{ $origin ->
        [adaptation] , adaptada
        [donning] , ajustada a la colocación de la camiseta
        [back] , recuperada
       *[calibration] { "" }
    }{ $parent ->
        [0] { "" }
       *[other] { " " }{ $origin ->
            [back] al volver desde
           *[other] a partir de
        } la versión { $parent }
    }, { $methods }{ $source ->
        [camera] , con una cámara
        [phones] , con teléfonos
        [slimevr] , con rastreadores
        [bluetooth] , con sensores Bluetooth
        [brainflow] , con una placa (BrainFlow)
        [lsl] , con señales por LSL
        [simulated] , de una camiseta simulada
        [unknown] , origen no registrado
       *[worn] { "" }
    }
report-method-pca = estándar
report-method-guided = aprendida de las indicaciones
report-method-prior = aprendida de otras personas
report-fact-modes = Cómo conduce
report-modes =
    Avance y retroceso: { $forward ->
        [acceleration] mantiene la velocidad
        [velocity] sigue el movimiento
       *[unknown] sin datos
    }. Giro: { $turning ->
        [acceleration] mantiene el giro
        [velocity] sigue el movimiento
       *[unknown] sin datos
    }
report-fact-set = Configuración
report-fact-stops = Se detiene sola tras
report-stops = { $time } s
report-stops-turning = { $time } s; al girar, { $turning } s
report-fact-speeds = Velocidades
report-speeds = Avance { $forward }, marcha atrás { $reverse } m/s, giro { $turn } °/s
report-fact-damping = Atenuación del temblor
report-damping = { $frequency } Hz
report-setting-unknown = sin datos
report-controls-control = Control
report-controls-movement = Movimiento
report-controls-from = Cuenta desde
report-controls-full = Máximo en
report-controls-gain = Ganancia
report-control-faster = Más rápido
report-control-slower = Más lento
report-control-left = Girar a la izquierda
report-control-right = Girar a la derecha
report-control-stop = Parar
# A movement of a joint, for example "Right wrist, going back, held".
report-movement =
    { $joint }{ $direction ->
        [back] , al volver
       *[forth] { "" }
    }{ $feature ->
        [displacement] , manteniendo
       *[rate] { "" }
    }
report-share = { $share } %
# A share of the person's full movement in each second.
report-share-rate = { $share } % / s

# Drives of real chairs

report-drives-drive = Conducción
report-drives-chair = Silla
report-drives-begun = Comienzo
report-drives-lasted = Duración
report-drives-distance = Distancia recorrida
report-drives-end = Final
report-drives-session = Sesión
report-drives-count = Conducciones
report-drives-chairs = Sillas
report-drives-faults = Terminadas por una parada o un fallo
report-drive-ended = terminada a mano
report-drive-fault = terminada por una parada o un fallo
report-drive-goes-on = en marcha
report-drive-end-unknown = sin datos
report-drive-minutes = { $minutes } min { $seconds } s
report-drive-seconds = { $seconds } s
report-drive-distance = { $distance } m
report-drive-distance-unknown = la silla no la indicó

# A task: its measures, trajectories and learning curve

report-measures-measure = Medida
report-measures-now = Ahora
report-measures-band = Variabilidad
report-measures-verdict = Valoración
report-nothing-before = nada con que comparar
report-task-trials =
    { $count ->
        [one] Cuenta { $count } ensayo; la meta se alcanzó en { $reached }.
       *[other] Cuentan { $count } ensayos; la meta se alcanzó en { $reached }.
    }
# Of these trials, $used were for getting used to the task.
report-task-trials-used =
    { $count ->
        [one] Cuenta { $count } ensayo, { $used } de familiarización; la meta se alcanzó en { $reached }.
       *[other] Cuentan { $count } ensayos, { $used } de ellos de familiarización; la meta se alcanzó en { $reached }.
    }
# $trials are trials with what interrupted them.
report-interrupted = Interrupciones: { $trials }.
report-interrupted-more = Interrupciones: { $trials } y { $more } más.
report-interrupted-trial = ensayo { $number } ({ $interruption })
report-compared =
    Sesión { $later } ({ $second ->
        [one] { $second } ensayo
       *[other] { $second } ensayos
    }) frente a la sesión { $earlier } ({ $first ->
        [one] { $first } ensayo
       *[other] { $first } ensayos
    }).
report-compared-none = No hay ninguna sesión anterior con ensayos de esta tarea con la que comparar.
# For those who do not see the drawing. $before, $now are levels of the measure with their unit, $noise a range.
report-band = { $measure }: { $before }, ahora { $now }; dentro de la variabilidad, { $noise }.
# A range of a measure; a unit may follow.
report-range = de { $low } a { $high }
# plan: title of a floor plan or scene; path: title of one of its paths.
report-task-title = { $plan }: { $path }
report-trajectories-title = Trayectorias sobre el recorrido
# $others are the trajectories that those of session $newest are compared with; $chosen is 0 when all are drawn.
report-trajectories =
    { $count ->
        [one] { $count } trayectoria
       *[other] { $count } trayectorias
    } de la sesión { $newest } (naranja){ $others ->
        [none] { "" }
        [sessions] { " " }sobre { $before } de sesiones anteriores (gris)
       *[session] { " " }sobre { $before } de la sesión { $earlier } (gris)
    }{ $chosen ->
        [0] { "" }
       *[other] , elegidas uniformemente entre { $chosen } ensayos
    }{ $lost ->
        [0] { "" }
        [one] ; no se puede leer { $lost } grabación
       *[other] ; no se pueden leer { $lost } grabaciones
    }.
report-curve-title = Curva de aprendizaje: { $measure } en cada ensayo
report-curve-words =
    { $count ->
        [one] { $count } ensayo; la sesión { $session } está en naranja. Anillos: familiarización. S: comienza una sesión.
       *[other] { $count } ensayos; la sesión { $session } está en naranja. Anillos: familiarización. S: comienza una sesión.
    }
# For those who do not see the drawing.
report-curve-of =
    { $count ->
        [one] { $measure } en { $count } ensayo.
       *[other] { $measure } a lo largo de { $count } ensayos.
    }
# Below the axis of a learning curve, between two numbers of trials.
report-curve-axis = ensayo
report-scale-bar = { $length } m

# Two-minute tests

report-tests-test = Prueba
report-tests-complete =
    { $count ->
        [one] { $count } prueba completa.
       *[other] { $count } pruebas completas.
    }
report-tests-complete-until =
    { $count ->
        [one] { $count } prueba completa hasta la sesión { $session }.
       *[other] { $count } pruebas completas hasta la sesión { $session }.
    }
report-tests-left-out =
    { $count ->
        [one] No se muestra { $count } prueba.
       *[other] No se muestran { $count } pruebas.
    }
report-test-of-session = { $number }, sesión { $session }
# Two tests by their numbers.
report-test-against = { $later } frente a { $earlier }
report-test-ended = terminada antes de tiempo: no cuenta
report-test-stopped = detenida: no cuenta
report-test-interrupted = interrumpida: no cuenta
report-test-unreadable = su grabación no se puede leer

# Foot of the document

report-explanation = La variabilidad es cuánto difieren entre sí los ensayos de esta persona en la tarea sin que haya un cambio; si no ha cambiado nada, alrededor de una página de cada veinte indica lo contrario por azar. Un ensayo que no alcanzó la meta se considera igual o peor que el peor 10 % de los ensayos anteriores que la alcanzaron. Los tres primeros ensayos de una tarea son de familiarización y no se comparan. No se ha publicado el cambio mínimo detectable de estas medidas de la conducción de sillas de ruedas.
# $characters are numbers of characters with their English names.
report-missing-characters = Aquí ningún tipo de letra tiene estos caracteres, así que en su lugar aparecen sus números: { $characters }.
report-missing-characters-more = Aquí ningún tipo de letra tiene estos caracteres, así que en su lugar aparecen sus números: { $characters } y { $more } más.
report-character-nameless = sin nombre
