### Texts of the owner's page "Backup": backups, deleted patients, incidents.

rail-backup = Copias de seguridad
backup-lead = Copias de todo el contenido de esta clínica en otro disco, y qué ocurre con los pacientes eliminados.
backup-settings-go = Ver las copias
backup-owner = Solo los administradores gestionan las copias de seguridad. Pida ayuda a uno de ellos.
backup-state-title = Copias de seguridad
backup-last = La última copia de seguridad correcta es del { $when }. Se ha comprobado leyéndola entera.
backup-now = Copiar ahora
backup-store = Copiando: { $done } de { $total }
backup-verify = Comprobando: { $done } de { $total }
backup-begins = La copia de seguridad comienza. Primero se copia la base de datos.
backup-progress = Avance de este paso
backup-done = La copia de seguridad está hecha.
backup-failed = La copia de seguridad ha fallado.
backup-while = Mientras tanto puede seguir trabajando y conduciendo.
backup-list = Las copias más recientes
backup-good = Correcta
backup-bad = Fallida
backup-of =
    { $files ->
        [one] { $files } archivo
       *[other] { $files } archivos
    }, { $size }, { $encrypted ->
        [yes] cifrada
       *[no] sin cifrar
    }, { $keys ->
        [yes] con claves
       *[no] sin claves
    }
backup-place = Cada noche
backup-folder = Carpeta
backup-folder-hint = En una memoria USB o una unidad de red, por ejemplo /media/backup. Vacío: sin copias de seguridad.
backup-hour = A partir de esta hora
backup-encrypted = Cifrar con una frase de contraseña
backup-passphrase = Frase de contraseña
backup-passphrase-new = Al menos { $count } caracteres. Guárdela fuera de esta clínica: sin ella nadie puede restaurar la copia.
backup-passphrase-kept = Ya hay una frase de contraseña. Deje este campo vacío para conservarla.
backup-with-keys = Copiar también las claves de las sillas, las camisetas y la clínica
backup-kept = Se conservan { $daily } copias diarias, { $weekly } semanales y { $monthly } mensuales. Cada grabación se guarda una sola vez.
backup-save = Guardar
backup-saved = Guardado.
deleted-title = Pacientes eliminados
deleted-lead = Todo lo de un paciente eliminado se oculta de inmediato y se borra a los { $days } días. Las copias de seguridad anteriores todavía lo contienen. En la carpeta se sustituyen en un plazo de 6 meses; los archivos sueltos debe borrarlos usted.
deleted-none = No se ha eliminado a nadie.
deleted-left =
    { $count ->
        [one] se borra en { $count } día
       *[other] se borra en { $count } días
    }
deleted-due = se borra en menos de una hora
deleted-what =
    { $count ->
        [one] { $count } grabación
       *[other] { $count } grabaciones
    }
deleted-undo = Deshacer
deleted-undo-label = Deshacer la eliminación de { $code }
deleted-undone = Se ha recuperado { $code }.
deleted-erase = Borrar ya
deleted-erase-label = Borrar ya: { $code }
deleted-erase-title = ¿Borrar { $code } definitivamente?
deleted-erase-lead = Las sesiones, calibraciones, ensayos y grabaciones se borran de inmediato. No se puede deshacer.
deleted-erase-go = Borrar para siempre
deleted-erased = Se ha borrado { $code }.
deleted-reason = Motivo
deleted-reason-hint = Queda en el registro. No escriba nombres.
deleted-reason-go = Eliminar por este motivo
records-title = Cuánto tiempo se conservan los historiales
records-years = Años desde la última sesión
records-years-hint = Consulte la legislación de su país. Para eliminar antes se pide un motivo. Vacío: sin plazo.
incidents-title = Incidentes
incidents-lead = El comando “bodydrive incident” archiva y firma las últimas 24 horas y marca a los pacientes afectados. Un paciente marcado no se borra hasta que usted quite la marca.
incidents-none = No se ha archivado ningún incidente.
incidents-of = { $when }, huella { $hash }
incidents-patients =
    { $count ->
        [one] { $count } paciente
       *[other] { $count } pacientes
    }
incidents-lift = Quitar la marca
incidents-lift-label = Quitar la marca del incidente del { $when }
incidents-lifted = Marca quitada el { $when }: { $reason }
incidents-key = Huella de la clave de firma
