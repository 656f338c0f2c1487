### Texts about the recording of a run: what is damaged or missing in it, and what to do.

# Two sentences, one after the other.
recording-both = { $first } { $second }
# A sentence that an earlier version of the program stored.
recording-noted = { $sentence }
recording-none = { $folder }: there is no recording in this folder, name the folder of a recording
recording-exists = { $folder }: there is a recording of this name already, begin a new one
# reason: what the operating system says of it, in its own language.
recording-not-written = The recording could not be written ({ $reason }): free some disk space, then start again.
recording-never-armed = The chair was never permitted to move in this trial: there is nothing to measure.
recording-cut = The recording was cut: what had been written by then is here.
recording-cut-loss = The recording was cut: what had been written by then is here. It ends { $end } s after its first row; of the time until the cut, at most { $lost } s are lost.
recording-unreadable = { $file }: this file was cut or changed and cannot be read: restore it from a backup.
recording-unchecked = { $file }: this file was cut or changed, so the recording cannot be checked.
recording-changed = { $file }: this file was changed, do not rely on it: restore it from a backup.
recording-file-missing = { $file }: the file before this one is missing, and what came after the missing one is left out.
recording-bytes-changed = { $file }: bytes of this file, or of its checksums, were changed: what comes after them is left out.
# run.json: the name of a file, not translated.
recording-run-json-changed = { $folder }: run.json was changed, and what the recording itself says of the run is used.
recording-run-json-unreadable = { $folder }: run.json cannot be read, so nothing is known of this run but its numbers.
