### Texts about backups of a clinic, about restoring one, and about the archive of an incident.

backups-warning-folder-gone = Der Ordner der Backups ist nicht da. Schließen Sie den Datenträger oder das Netzlaufwerk an, auf dem er liegt.
backups-warning-none = Es gibt noch kein gutes Backup. Wählen Sie einen Ordner auf einem anderen Datenträger, und sichern Sie dann.
# $days: 3 or more.
backups-warning-old = Das letzte gute Backup ist { $days } Tage alt. Die Liste der Backups sagt, warum. Sichern Sie jetzt.

backups-no-folder = Es ist kein Ordner gewählt. Wählen Sie zuerst einen.
backups-folder-relative = Geben Sie den vollständigen Pfad des Ordners an. Er beginnt mit /.
backups-folder-inside = Dieser Ordner liegt im Ordner der Klinik oder enthält ihn. Wählen Sie einen auf einem anderen Datenträger.
backups-folder-gone = Der Ordner { $folder } ist nicht da. Schließen Sie den Datenträger an, auf dem er liegt.
backups-folder-gone-choose = Der Ordner { $folder } ist nicht da. Schließen Sie den Datenträger an, auf dem er liegt, oder wählen Sie einen anderen Ordner.
# $problem: what the operating system says, in its language.
backups-folder-not-writable = In den Ordner { $folder } kann nicht geschrieben werden ({ $problem }). Wählen Sie einen anderen.
backups-header-missing = { $folder } enthält Backups, aber die Datei { $file } fehlt darin. Wählen Sie einen anderen Ordner.
backups-header-unreadable = { $folder } ist kein Backup-Ordner: Die Datei { $file } darin ist nicht lesbar.
backups-of-other-clinic = { $folder } enthält die Backups einer anderen Klinik. Wählen Sie für diese Klinik einen eigenen Ordner.
backups-of-other-passphrase = { $folder } enthält Backups mit einer anderen Passphrase oder ohne eine. Verwenden Sie, womit dieser Ordner angelegt wurde, oder wählen Sie einen leeren Ordner.

backups-passphrase-short = Geben Sie eine Passphrase mit mindestens 8 Zeichen an.
backups-wrong-passphrase = Die Passphrase ist falsch, oder die Datei wurde verändert. Geben Sie die Passphrase an, mit der die Datei erstellt wurde.
# HOW-TO-OPEN.txt is a file in the backup, in English.
backups-passphrase-slow = Dieser Rechner ist für die Passphrase zu langsam oder zu stark ausgelastet. Schließen Sie andere Programme, und versuchen Sie es noch einmal. Oder folgen Sie der Datei HOW-TO-OPEN.txt im Backup.

backups-busy = Ein Backup wird gerade erstellt. Warten Sie, bis es fertig ist.
backups-under-way = Ein Backup wird schon erstellt. Warten Sie, bis es fertig ist.
backups-other-under-way = Ein anderes Backup dieser Klinik wird gerade erstellt. Warten Sie, bis es fertig ist.
backups-process-ended = Der Prozess, der das Backup erstellt, wurde beendet. Prüfen Sie die Datenträger, und versuchen Sie es dann noch einmal.
# $problem: what the operating system or a library says, in its language.
backups-failed = Das Backup konnte nicht erstellt werden ({ $problem }). Prüfen Sie die Datenträger, und versuchen Sie es dann noch einmal.
# $problem: what the operating system says, in its language. $place: a file or folder.
backups-failed-at = Das Backup konnte nicht erstellt werden ({ $problem }: { $place }). Prüfen Sie die Datenträger, und versuchen Sie es dann noch einmal.
# A recording is left out while it is being made.
backups-left-out =
    { $recordings ->
        [one] Eine Aufzeichnung lief noch und wurde ausgelassen. Das nächste Backup enthält sie.
       *[other] { $recordings } Aufzeichnungen liefen noch und wurden ausgelassen. Das nächste Backup enthält sie.
    }
backups-changed-meanwhile = { $file } wurde während des Kopierens verändert. Versuchen Sie es noch einmal.
backups-file-there = Es gibt schon eine Datei { $file }. Wählen Sie einen anderen Namen.
backups-no-folder-for-file = Es gibt keinen Ordner { $folder }. Legen Sie ihn an, oder wählen Sie einen anderen Ort.
backups-no-clinic = In { $folder } gibt es keine Klinik. Geben Sie ihren Ordner mit --state an.
backups-not-set-up = Die Klinik in { $folder } ist noch nicht eingerichtet. Öffnen Sie zuerst ihre Seiten.
backups-unequal = Das Backup { $file } war beim Prüfen fehlerhaft: Dieser Datenträger ist beschädigt. Nehmen Sie einen anderen.
backups-unequal-in-folder = Das Backup in { $folder } war beim Prüfen fehlerhaft: Dieser Datenträger ist beschädigt. Nehmen Sie einen anderen.
# $files: how many.
backups-parts-unequal =
    { $files ->
        [one] { $files } Datei in { $folder } war beim Prüfen fehlerhaft: Dieser Datenträger ist beschädigt. Nehmen Sie einen anderen.
       *[other] { $files } Dateien in { $folder } waren beim Prüfen fehlerhaft: Dieser Datenträger ist beschädigt. Nehmen Sie einen anderen.
    }

# A backup, or the archive of an incident.
backups-damaged = Diese Datei ist beschädigt oder unvollständig. Nehmen Sie eine andere.
backups-part-damaged = Dieses Backup ist beschädigt: { $file } fehlt oder wurde verändert. Nehmen Sie ein anderes.
backups-none = Dies ist kein Backup von bodydrive, oder es wurde verändert. Nehmen Sie ein anderes.
backups-other-version = Eine andere Version von bodydrive hat dieses Backup erstellt. Stellen Sie es mit jener Version wieder her.
# $folder: into which a backup is to be restored. $found: a file or folder in it. $kept: the name of a file.
backups-not-empty = { $folder } ist nicht leer, darin liegt { $found }. Stellen Sie in einem leeren Ordner wieder her. Von einer früheren Klinik darf nur { $kept } bleiben.
backups-restored-unequal = { $file } ist nicht gleich dem, was gesichert wurde. Nehmen Sie ein anderes Backup oder einen anderen Datenträger.

backups-incident-other-key = Ein anderer als der angegebene Schlüssel hat diese Vorkommnis-Datei signiert. Fragen Sie, woher sie stammt.
backups-incident-wrong-signature = Die Signatur dieser Vorkommnis-Datei ist falsch: Sie wurde nach dem Erstellen verändert.
backups-incident-changed = { $file } in dieser Vorkommnis-Datei wurde verändert oder fehlt.
