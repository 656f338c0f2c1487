### Texts about backups of a clinic, about restoring one, and about the archive of an incident.

backups-warning-folder-gone = No se encuentra la carpeta de las copias de seguridad: conecte el disco o la unidad de red donde está.
backups-warning-none = Todavía no hay ninguna copia de seguridad correcta: elija una carpeta en otro disco y haga una.
# $days: 3 or more.
backups-warning-old = La última copia de seguridad correcta es de hace { $days } días: la lista de copias indica por qué; haga una ahora.

backups-no-folder = No se ha elegido ninguna carpeta: elija primero una.
backups-folder-relative = Indique la ruta completa de la carpeta, que empieza por /.
backups-folder-inside = Esta carpeta está dentro de la carpeta de la clínica, o la contiene: elija una en otro disco.
backups-folder-gone = No se encuentra la carpeta { $folder }: conecte el disco donde está.
backups-folder-gone-choose = No se encuentra la carpeta { $folder }: conecte el disco donde está, o elija otra.
# $problem: what the operating system says, in its language.
backups-folder-not-writable = No se puede escribir en la carpeta { $folder } ({ $problem }): elija otra.
backups-header-missing = { $folder } contiene copias de seguridad, pero falta su archivo { $file }: elija otra carpeta.
backups-header-unreadable = { $folder } no es una carpeta de copias de seguridad: su archivo { $file } no se puede leer.
backups-of-other-clinic = { $folder } contiene las copias de seguridad de otra clínica: elija una carpeta propia para esta.
backups-of-other-passphrase = { $folder } contiene copias de seguridad con otra frase de contraseña, o sin ninguna: use lo mismo que cuando se creó esa carpeta, o elija una carpeta vacía.

backups-passphrase-short = Indique una frase de contraseña de al menos 8 caracteres.
backups-wrong-passphrase = La frase de contraseña no es correcta, o el archivo se modificó: indique la frase de contraseña con la que se creó.
# HOW-TO-OPEN.txt is a file in the backup, in English.
backups-passphrase-slow = Este equipo es demasiado lento o está demasiado ocupado para la frase de contraseña: cierre otros programas e inténtelo de nuevo, o siga las instrucciones de HOW-TO-OPEN.txt en la copia de seguridad.

backups-busy = Se está haciendo una copia de seguridad: espere a que termine.
backups-under-way = Ya se está haciendo una copia de seguridad: espere a que termine.
backups-other-under-way = Se está haciendo otra copia de seguridad de esta clínica: espere a que termine.
backups-process-ended = El proceso que hace la copia de seguridad se ha cerrado: compruebe los discos e inténtelo de nuevo.
# $problem: what the operating system or a library says, in its language.
backups-failed = No se pudo hacer la copia de seguridad ({ $problem }): compruebe los discos e inténtelo de nuevo.
# $problem: what the operating system says, in its language. $place: a file or folder.
backups-failed-at = No se pudo hacer la copia de seguridad ({ $problem }: { $place }): compruebe los discos e inténtelo de nuevo.
# A recording is left out while it is being made.
backups-left-out =
    { $recordings ->
        [one] Una grabación estaba en marcha y no se incluyó: la próxima copia de seguridad la contiene.
       *[other] { $recordings } grabaciones estaban en marcha y no se incluyeron: la próxima copia de seguridad las contiene.
    }
backups-changed-meanwhile = { $file } cambió mientras se copiaba: inténtelo de nuevo.
backups-file-there = Ya hay un archivo { $file }: elija otro nombre.
backups-no-folder-for-file = No hay ninguna carpeta { $folder }: créela, o elija otro lugar.
backups-no-clinic = No hay ninguna clínica en { $folder }: indique su carpeta con --state.
backups-not-set-up = La clínica de { $folder } todavía no está configurada: abra primero sus páginas.
backups-unequal = La copia de seguridad { $file } no se lee igual que se escribió: este disco está dañado, use otro.
backups-unequal-in-folder = La copia de seguridad en { $folder } no se lee igual que se escribió: este disco está dañado, use otro.
# $files: how many.
backups-parts-unequal =
    { $files ->
        [one] { $files } archivo de { $folder } no se lee igual que se escribió: este disco está dañado, use otro.
       *[other] { $files } archivos de { $folder } no se leen igual que se escribieron: este disco está dañado, use otro.
    }

# A backup, or the archive of an incident.
backups-damaged = Este archivo está dañado o incompleto: use otro.
backups-part-damaged = Esta copia de seguridad está dañada: { $file } falta o se modificó. Use otra.
backups-none = Esto no es una copia de seguridad de bodydrive, o se modificó: use otra.
backups-other-version = Esta copia de seguridad la hizo otra versión de bodydrive: restáurela con esa versión.
# $folder: into which a backup is to be restored. $found: a file or folder in it. $kept: the name of a file.
backups-not-empty = { $folder } no está vacía, contiene { $found }: restaure en una carpeta vacía. De una clínica que hubiera allí antes, deje solo { $kept }.
backups-restored-unequal = { $file } no es igual a lo que se copió: use otra copia de seguridad u otro disco.

backups-incident-other-key = Este archivo de incidente se firmó con una clave distinta de la indicada: pregunte de dónde procede.
backups-incident-wrong-signature = La firma de este archivo de incidente no es válida: el archivo se modificó después de crearlo.
backups-incident-changed = { $file } se modificó o falta en este archivo de incidente.
