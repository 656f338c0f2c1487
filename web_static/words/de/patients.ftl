### Texte der Seite „Patienten“.

patients-title = Wer ist gekommen?
patients-lead = Patienten sind hier mit Code und Pseudonym bekannt. Ein Name ist nicht nötig.
patients-search = Nach Code oder Pseudonym suchen
patients-new = Neuer Patient
patients-new-title = Neuer Patient
patients-code = Code
patients-code-hint = Buchstaben, Ziffern, Punkt, Bindestrich; zum Beispiel P-015.
patients-pseudonym = Pseudonym
patients-pseudonym-hint = Ein Wort, das Sie und der Patient wiedererkennen. Nicht der echte Name.
patients-note = Notiz
patients-note-hint = Kann leer bleiben.
patients-add = Hinzufügen und Sitzung starten
patients-start = Sitzung starten
patients-go-on = Weiter
patients-end = Sitzung beenden
patients-here = Sitzung offen
patients-ends =
    Eine Sitzung von { $code } ist offen: { $name } hat sie um { $time } begonnen, { $trials ->
        [one] { $trials } Durchgang
       *[other] { $trials } Durchgänge
    }. Es kann nur eine Sitzung offen sein.
patients-ends-somebody =
    Eine Sitzung von { $code } ist offen: begonnen um { $time }, { $trials ->
        [one] { $trials } Durchgang
       *[other] { $trials } Durchgänge
    }. Es kann nur eine Sitzung offen sein.
patients-ends-go = Beenden und { $next } starten
patients-sessions =
    { $count ->
        [one] { $count } Sitzung
       *[other] { $count } Sitzungen
    }
patients-trials =
    { $count ->
        [one] { $count } Durchgang
       *[other] { $count } Durchgänge
    }
patients-never = noch keine Sitzung
patients-last = letzte Sitzung { $day }
patients-delete = { $code } löschen
patients-deleted = { $code } wurde gelöscht.
patients-empty = Die Liste ist leer. Fügen Sie den ersten Patienten hinzu. Code und Pseudonym genügen.
patients-none-found = Kein Treffer für „{ $words }“. Prüfen Sie die Schreibweise, oder fügen Sie einen neuen Patienten hinzu.
patients-alone = In dieser Klinik arbeitet noch niemand anderes.
patients-ended = Die Sitzung ist beendet.
