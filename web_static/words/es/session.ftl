### Texts of the record of a session, of a patient's sessions and consents, and of two sessions side by side.

rail-session = Sesiones
record-title = Sesión { $number } de { $code }
record-sessions = Sesiones de { $code }
record-sessions-lead = Abra una sesión para ver su ficha, o marque dos para verlas lado a lado.
record-sessions-none = Todavía no hay sesiones. La primera comienza cuando usted empieza una sesión en la página Pacientes.
record-link = Sesiones y consentimientos
record-link-label = Sesiones y consentimientos de { $code }
record-back = Todas las sesiones
record-story = Cronología
record-story-label = Cronología de la sesión { $number }
record-story-title = Cronología de la sesión { $number } de { $code }
record-story-record = Ficha
origin-words = De { $clinic }; importado por { $person }, { $moment }
record-began = Iniciada el { $moment }
record-began-by = Iniciada el { $moment } por { $person }
record-version = Programa { $version }
record-version-none = Versión del programa no registrada
record-state-open = Abierta ahora
record-state-ended = Sin firmar
record-state-signed = Firmada
record-only-read = Usted puede leer esta ficha, pero no cambiar nada.
record-goal = Objetivo, con las palabras del paciente
record-goal-none = No se anotó ningún objetivo.
record-goal-hint = Qué quiere conseguir el paciente en esta sesión.
record-goal-save = Guardar objetivo
record-goal-saved = Objetivo guardado.
record-notes = Notas
record-notes-none = No se escribió ninguna nota.
record-note-new = Nota nueva
record-note-add = Añadir la nota
record-note-revise = Corregir
record-note-revise-label = Corregir la nota de { $person }, { $moment }
record-note-save = Guardar la corrección
record-note-text = Texto de la nota
record-note-by = { $person }, { $moment }
record-note-revised = { $person }, corregida: { $moment }
record-note-history =
    { $count ->
        [one] { $count } texto anterior
       *[other] { $count } textos anteriores
    }
record-scales = Escalas de resultado
record-scales-none = No se anotó ninguna escala.
record-scale-name = Escala
record-scale-name-hint = Por ejemplo, SCIM III o WST 5.0.
record-scale-total = Total
record-scale-total-hint = Solo el total; los ítems de la mayoría de los formularios requieren licencia.
record-scale-total-missing = Escriba el total como número.
record-scale-day = Fecha
record-scale-add = Añadir la escala
record-scale-remove = Quitar
record-scale-remove-label = Quitar { $name }, { $day }
record-driven = Qué se condujo
record-driven-none = En esta sesión no se condujo nada.
record-driven-trial = { $plan }, ensayo { $number }
record-driven-counts = cuenta
record-driven-discarded = descartado: { $reason }
record-driven-drives =
    { $count ->
        [one] { $count } conducción de una silla real
       *[other] { $count } conducciones de una silla real
    }
record-tests = Pruebas de dos minutos
record-driven-task = Ensayo
record-driven-kept = Cuenta
record-sets = Calibración y controles
record-set = Calibración { $version } con la configuración “{ $title }”
record-details = Detalles
record-set-hash = Huella de la configuración: { $hash }
record-sign = Firma
record-sign-lead = La firma bloquea el objetivo, las notas, las escalas y los ensayos de esta sesión. Solo un administrador puede desbloquearlos.
record-sign-ends = Esta sesión todavía está abierta; termina con la firma.
record-sign-go = Firmar
record-sign-sure = ¿Firmar como { $person }?
record-sign-yes = Sí, firmar
record-signed = Firmada por { $person }, { $moment }.
record-signed-past = Firmada por { $person }, { $moment }; desbloqueada por { $owner }, { $unlocked }: { $reason }
record-signed-done = La sesión está firmada.
record-unlock = Desbloquear
record-unlock-reason = Por qué se desbloquea
record-unlock-reason-hint = El motivo queda en el historial y en el registro.
record-unlock-yes = Desbloquear la sesión
record-compare = Comparar las dos
record-compare-pick = Comparar la sesión { $number }
record-compare-choose =
    { $count ->
        [one] Marque una sesión más.
       *[other] Marque dos sesiones.
    }
record-compare-title = Dos sesiones lado a lado
record-compare-lead = { $code }: sesión { $earlier } y sesión { $later }
record-compare-nothing = No se condujo nada en ninguna de las dos sesiones.
record-compare-trials = Ensayos de la sesión { $number }: hechos { $driven }, cuentan { $counted }, se comparan { $compared }.
record-compare-tests = Sesión { $number }: pruebas completas: { $complete }.
record-compare-tests-newest = Aquí aparece la prueba completa más reciente de cada una.
record-compare-none = No se puede comparar ningún ensayo de esta tarea: los tres primeros son de familiarización. Repita la tarea en otra sesión.
record-compare-range = (de { $low } a { $high })
record-compare-spread = Cada cifra es la mediana; la mitad de los ensayos está dentro del rango entre paréntesis.
record-compare-task = { $plan }: { $path }
record-compare-changed = Qué cambió en la calibración y los controles
record-compare-same = La calibración y los controles son los mismos.
record-compare-unknown = Los controles no se pueden comparar: en una de las dos sesiones no se condujo nada, o los guardó otra versión del programa.
record-compare-maps = Calibración { $earlier } en la sesión { $first }, calibración { $later } en la sesión { $second }.
consent-title = Consentimientos
consent-lead = Cada uno está desactivado hasta que el paciente lo da, y se puede retirar en cualquier momento.
consent-recording = Grabación
consent-recording-hint = Se graban las señales y los ensayos con la camiseta puesta o con una cámara, cuya imagen no se graba ni se envía. La práctica con la camiseta simulada no necesita consentimiento.
consent-clinic-prior = Uso para otros pacientes de la clínica
consent-clinic-prior-hint = Los ensayos ayudan a distinguir un cambio de la variabilidad, y los movimientos ayudan a los pacientes nuevos a conducir antes. No se puede reconocer a nadie. Si se retira el consentimiento, estos datos se quitan.
consent-sharing = Compartir fuera
consent-sharing-hint = El historial puede salir de la clínica como informe, enlace compartido o exportación.
consent-given = Dado el { $day }
consent-by = Dado el { $day }, anotado por { $person }
consent-off = No dado
consent-day = Fecha del consentimiento
consent-give = Anotar
consent-give-label = Anotar el consentimiento: { $consent }
consent-withdraw = Retirar
consent-withdraw-label = Retirar el consentimiento: { $consent }
consent-history = Historial
consent-past = Del { $day } al { $withdrawn }, retirado por { $person }
consent-needed = { $code } no ha dado su consentimiento para la grabación.
consent-needed-why = Sin él no se graba nada con la camiseta puesta: pídaselo al paciente y anótelo.
consent-needed-go = Anotar
