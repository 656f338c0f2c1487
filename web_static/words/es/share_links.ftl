### Texts of the share links of a patient, which clinicians make, list and revoke.

shares-title = Enlaces compartidos
shares-lead = Un enlace compartido muestra el historial a una persona de fuera de la clínica. Es de solo lectura, identifica al paciente por el código, dura { $days } días como máximo y necesita un PIN. En el registro queda cada apertura. Un informe, que se crea en Revisar, es un archivo que conserva quien lo recibe.
shares-none = No hay ningún enlace que se pueda abrir.
shares-all = Todas las sesiones
shares-session = Sesión { $number }
shares-state-open = Se puede abrir
shares-state-closed = Cerrado: sin consentimiento
shares-state-revoked = Anulado
shares-state-over = Caducado
shares-state-dead = Cerrado: cinco PIN incorrectos
shares-until = Hasta el { $moment }
shares-openings-none = Todavía sin abrir
shares-openings =
    { $count ->
        [one] Abierto una vez, { $moment }
       *[other] Abierto { $count } veces, la última: { $moment }
    }
shares-wrong =
    { $count ->
        [one] { $count } PIN incorrecto
       *[other] { $count } PIN incorrectos
    }
shares-made = Creado: { $moment }, por { $person }
shares-ended =
    { $count ->
        [one] { $count } enlace terminado
       *[other] { $count } enlaces terminados
    }
shares-revoke = Anular
shares-revoke-label = Anular el enlace: { $what }, creado: { $moment }
shares-revoked = El enlace se ha anulado: ya no muestra nada.
shares-what = Qué muestra
shares-for = Cuánto tiempo
shares-days =
    { $count ->
        [one] { $count } día
       *[other] { $count } días
    }
shares-make = Crear el enlace
shares-consent = Un enlace compartido necesita el consentimiento del paciente para compartir fuera de la clínica: pídalo y anótelo arriba.
shares-new = El enlace y su PIN, que se muestran solo esta vez: { $what }
shares-new-lead = Envíe el enlace. Comunique el PIN por otra vía, por ejemplo por teléfono: quien tiene ambos puede leer el historial de { $code }.
shares-pin = PIN
shares-done = Listo
