### Texts about the recording of a run: what is damaged or missing in it, and what to do.

# Two sentences, one after the other.
recording-both = { $first } { $second }
# A sentence that an earlier version of the program stored.
recording-noted = { $sentence }
recording-none = { $folder }: en esta carpeta no hay ninguna grabación, indique la carpeta de una
recording-exists = { $folder }: ya hay una grabación con este nombre, empiece una nueva
# reason: what the operating system says of it, in its own language.
recording-not-written = La grabación no se pudo escribir ({ $reason }): libere espacio en el disco y empiece después una nueva.
recording-never-armed = En este ensayo la silla no pudo moverse en ningún momento: no hay nada que medir.
recording-cut = La grabación se cortó: aquí está lo que se había escrito hasta entonces.
recording-cut-loss = La grabación se cortó: aquí está lo que se había escrito hasta entonces. Termina { $end } s después de su primera fila; del tiempo hasta el corte se perdieron { $lost } s como máximo.
recording-unreadable = { $file }: este archivo se cortó o se modificó y no se puede leer: restáurelo desde una copia de seguridad.
recording-unchecked = { $file }: este archivo se cortó o se modificó, así que la grabación no se puede comprobar.
recording-changed = { $file }: este archivo se modificó, no se fíe de él: restáurelo desde una copia de seguridad.
recording-file-missing = { $file }: falta el archivo anterior a este, y lo que venía detrás se omite.
recording-bytes-changed = { $file }: se modificaron bytes de este archivo, o de sus sumas de comprobación: lo que viene después de ellos se omite.
# run.json: the name of a file, not translated.
recording-run-json-changed = { $folder }: run.json se modificó, y se usa lo que la propia grabación indica.
recording-run-json-unreadable = { $folder }: run.json no se puede leer, así que de esta grabación solo se conocen sus números.
