### Texte der Seite „Backup“ für Verantwortliche: Backups, gelöschte Patienten, Vorkommnisse.

rail-backup = Backup
backup-lead = Kopien aller Daten dieser Klinik auf einem anderen Datenträger, und was mit gelöschten Patienten geschieht.
backup-settings-go = Backups ansehen
backup-owner = Nur Verantwortliche verwalten die Backups. Fragen Sie eine verantwortliche Person.
backup-state-title = Backups
backup-last = Das letzte gute Backup ist vom { $when }. Es wurde vollständig geprüft.
backup-now = Jetzt sichern
backup-store = Kopieren: { $done } von { $total }
backup-verify = Prüfen: { $done } von { $total }
backup-begins = Das Backup beginnt. Zuerst wird die Datenbank kopiert.
backup-progress = Fortschritt dieses Schritts
backup-done = Das Backup ist fertig.
backup-failed = Das Backup ist fehlgeschlagen.
backup-while = Sie können währenddessen weiterarbeiten und fahren.
backup-list = Die neuesten Backups
backup-good = Gut
backup-bad = Fehler
backup-of =
    { $files ->
        [one] { $files } Datei
       *[other] { $files } Dateien
    }, { $size }, { $encrypted ->
        [yes] verschlüsselt
       *[no] nicht verschlüsselt
    }, { $keys ->
        [yes] mit Schlüsseln
       *[no] ohne Schlüssel
    }
backup-place = Jede Nacht
backup-folder = Ordner
backup-folder-hint = Auf einem Stick oder Netzlaufwerk, zum Beispiel /media/backup. Leer: keine Backups.
backup-hour = Ab dieser Uhrzeit
backup-encrypted = Mit einer Passphrase verschlüsseln
backup-passphrase = Passphrase
backup-passphrase-new = Mindestens { $count } Zeichen. Bewahren Sie sie außerhalb dieser Klinik auf. Ohne sie kann niemand das Backup wiederherstellen.
backup-passphrase-kept = Eine Passphrase ist gesetzt. Lassen Sie das Feld leer, um sie zu behalten.
backup-with-keys = Auch die Schlüssel von Rollstühlen, Shirts und Klinik sichern
backup-kept = { $daily } tägliche, { $weekly } wöchentliche und { $monthly } monatliche Backups bleiben erhalten. Aufzeichnungen werden nur einmal gespeichert.
backup-save = Speichern
backup-saved = Gespeichert.
deleted-title = Gelöschte Patienten
deleted-lead = Alles zu einem gelöschten Patienten wird sofort ausgeblendet und nach { $days } Tagen endgültig gelöscht. Ältere Backups enthalten es noch. Backups im Ordner werden innerhalb von 6 Monaten ersetzt. Einzelne Backup-Dateien müssen Sie selbst löschen.
deleted-none = Es ist kein Patient gelöscht.
deleted-left =
    { $count ->
        [one] wird in { $count } Tag endgültig gelöscht
       *[other] wird in { $count } Tagen endgültig gelöscht
    }
deleted-due = wird innerhalb einer Stunde endgültig gelöscht
deleted-what =
    { $count ->
        [one] { $count } Aufzeichnung
       *[other] { $count } Aufzeichnungen
    }
deleted-undo = Rückgängig
deleted-undo-label = Löschen von { $code } rückgängig machen
deleted-undone = { $code } ist wieder da.
deleted-erase = Jetzt löschen
deleted-erase-label = Jetzt löschen: { $code }
deleted-erase-title = { $code } endgültig löschen?
deleted-erase-lead = Sitzungen, Kalibrierungen, Durchgänge und Aufzeichnungen werden sofort gelöscht. Das lässt sich nicht rückgängig machen.
deleted-erase-go = Endgültig löschen
deleted-erased = { $code } wurde endgültig gelöscht.
deleted-reason = Grund
deleted-reason-hint = Er steht im Protokoll. Bitte keine Namen.
deleted-reason-go = Mit diesem Grund löschen
records-title = Aufbewahrungsfrist
records-years = Jahre nach der letzten Sitzung
records-years-hint = Erkundigen Sie sich, was bei Ihnen gesetzlich gilt. Wer früher löscht, muss einen Grund angeben. Leer: keine Frist.
incidents-title = Vorkommnisse
incidents-lead = Der Befehl „bodydrive incident“ archiviert die letzten 24 Stunden mit Signatur. Die betroffenen Patienten werden erst endgültig gelöscht, wenn Sie die Sperre aufheben.
incidents-none = Kein Vorkommnis wurde archiviert.
incidents-of = { $when }, Fingerabdruck { $hash }
incidents-patients =
    { $count ->
        [one] { $count } Patient
       *[other] { $count } Patienten
    }
incidents-lift = Sperre aufheben
incidents-lift-label = Sperre aufheben: Vorkommnis vom { $when }
incidents-lifted = Aufgehoben { $when }: { $reason }
incidents-key = Fingerabdruck des Signaturschlüssels
