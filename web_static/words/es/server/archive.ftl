### Texts about the archive of a patient: one file, by which a patient's records come from one clinic to another.
### Where a text begins with { $file }:, the pages leave these first words out.

archive-session-here = Hay una sesión de este paciente abierta: termínela primero y después cree el expediente.

archive-none = { $file }: esto no es un expediente de bodydrive, o está incompleto: indique otro archivo.
# $name: of a file within the archive.
archive-changed = { $file }: dentro del expediente, “{ $name }” se modificó o está incompleto, y no se ha importado nada: copie otra vez el expediente.
# $schema: a whole number.
archive-newer = { $file }: este expediente lo creó un bodydrive más reciente (esquema { $schema }), y no se ha importado nada: actualice el de este equipo.
# $why: one of the clauses below.
archive-wrong = { $file }: este expediente no se puede leer porque { $why }; no se ha importado nada.
archive-code-taken = El código “{ $code }” es de otro paciente de esta clínica, y no se ha importado nada: dé otro código a ese paciente e importe de nuevo.
archive-recordings-here = Hay grabaciones de este expediente que pertenecen a otro paciente de esta clínica, y no se ha importado nada: busque a ese paciente en la lista de pacientes, o en “{ deleted-title }” de la página “{ rail-backup }”.
archive-patient-here = { $code } ya está en esta clínica, y no se ha importado nada: sustituya ese paciente o déjelo como está.
archive-session-open = Hay una sesión de { $code } abierta aquí, y no se ha importado nada: termínela primero e importe de nuevo.
# $made: a date.
archive-incident = { $code } forma parte del incidente del { $made } y no se puede sustituir: antes, un administrador debe quitar la marca del incidente.
# $until: a date.
archive-records-kept = Hubo sesiones de { $code } en esta clínica, y su historial debe conservarse hasta el { $until }: el paciente no se puede sustituir y no se ha importado nada.

## Clauses that say why an archive cannot be read: each stands in archive-wrong as $why. “Its” is “of the archive”.
## $row: the number of a row. $table, $column, $field: names in the file, which stay as they are.

archive-memory = necesita demasiada memoria
# $problem: a sentence without a full stop.
archive-text-refused = se rechaza uno de sus textos: { $problem }
archive-recording-names = los nombres de sus grabaciones no son correctos
archive-recording-unnamed = contiene una grabación que ninguna fila nombra
archive-recording-channels = los canales de la grabación “{ $recording }” no son los de su disposición
archive-recording-gestures = los gestos de la grabación “{ $recording }” no son los que ella nombra
# $problem: archive-field.
archive-recording-field = en la grabación “{ $recording }”, { $problem }
archive-recording-unreadable = la grabación “{ $recording }” no se puede leer
archive-comment-without-author = uno de sus comentarios no tiene autor
archive-other-tables = sus tablas son otras
archive-other-columns = las columnas de su tabla “{ $table }” son otras
archive-rows-most = tiene más de { NUMBER($most, useGrouping: 1) } filas
archive-one-patient = no tiene exactamente un paciente
archive-session-not-ended = una de sus sesiones no ha terminado
archive-row-contradicts = la fila { $row } de su tabla “{ $table }” contradice otra fila
# $problem: archive-field.
archive-row-field = en la fila { $row } de su tabla “{ $table }”, { $problem }
# $problem: archive-date, another text without a full stop, or what a library says, in English.
archive-field = “{ $field }” no es correcto ({ $problem })
archive-date = esto no es una fecha entre 1970 y 2200
archive-value-empty = en la fila { $row } de su tabla “{ $table }”, la columna “{ $column }” está vacía
archive-value-type = en la fila { $row } de su tabla “{ $table }”, la columna “{ $column }” es de otro tipo
archive-value-long = en la fila { $row } de su tabla “{ $table }”, la columna “{ $column }” es demasiado larga
archive-value-place = en la fila { $row } de su tabla “{ $table }”, la columna “{ $column }” no es { $row }
archive-value-refers = en la fila { $row } de su tabla “{ $table }”, la columna “{ $column }” remite a una fila que no existe
archive-value-date = en la fila { $row } de su tabla “{ $table }”, la columna “{ $column }” no es una fecha
archive-map-from = la fila { $row } de su tabla “profile” procede de una versión que no existe
archive-map-back = la fila { $row } de su tabla “profile” no indica a qué versión vuelve
archive-controls-map = en la fila { $row } de su tabla “parameters”, “profile_id” remite a una fila que no existe
archive-controls-current = en la fila { $row } de su tabla “parameters”, “current” no es correcto, porque la configuración actual es otra
