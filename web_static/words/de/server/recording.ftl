### Texts about the recording of a run: what is damaged or missing in it, and what to do.

# Two sentences, one after the other.
recording-both = { $first } { $second }
# A sentence that an earlier version of the program stored.
recording-noted = { $sentence }
recording-none = { $folder }: in diesem Ordner ist keine Aufzeichnung; nennen Sie den Ordner einer Aufzeichnung
recording-exists = { $folder }: eine Aufzeichnung mit diesem Namen gibt es schon; beginnen Sie eine neue
# reason: what the operating system says of it, in its own language.
recording-not-written = Die Aufzeichnung konnte nicht geschrieben werden ({ $reason }): Schaffen Sie Speicherplatz, und starten Sie dann noch einmal.
recording-never-armed = Der Rollstuhl durfte in diesem Durchgang nie fahren: Es gibt nichts auszuwerten.
recording-cut = Die Aufzeichnung wurde abgebrochen: Was bis dahin geschrieben war, ist vorhanden.
recording-cut-loss = Die Aufzeichnung wurde abgebrochen: Was bis dahin geschrieben war, ist vorhanden. Sie endet { $end } s nach ihrer ersten Zeile; von der Zeit bis zum Abbruch fehlen höchstens { $lost } s.
recording-unreadable = { $file }: diese Datei wurde abgeschnitten oder geändert und ist nicht lesbar; stellen Sie sie aus einem Backup wieder her.
recording-unchecked = { $file }: diese Datei wurde abgeschnitten oder geändert, deshalb lässt sich die Aufzeichnung nicht prüfen.
recording-changed = { $file }: diese Datei wurde geändert; verlassen Sie sich nicht darauf, und stellen Sie sie aus einem Backup wieder her.
recording-file-missing = { $file }: die Datei vor dieser fehlt; was danach kam, wird weggelassen.
recording-bytes-changed = { $file }: Bytes dieser Datei oder ihrer Prüfsummen wurden geändert; was danach kommt, wird weggelassen.
# run.json: the name of a file, not translated.
recording-run-json-changed = { $folder }: run.json wurde geändert; verwendet wird, was in der Aufzeichnung selbst darüber steht.
recording-run-json-unreadable = { $folder }: run.json ist nicht lesbar, deshalb ist über diese Aufzeichnung nichts bekannt als ihre Zahlen.
