### Texte der geteilten Links eines Patienten, die Fachkräfte erstellen, auflisten und widerrufen.

shares-title = Geteilte Links
shares-lead = Ein geteilter Link zeigt die Dokumentation jemandem außerhalb der Klinik. Er lässt sich nur lesen, nennt den Patienten nur mit dem Code, gilt höchstens { $days } Tage und braucht eine PIN. Jedes Öffnen steht im Protokoll. Ein Bericht (unter „Auswertung“) ist dagegen eine Datei, die behält, wer sie bekommt.
shares-none = Es gibt keinen Link, der sich öffnen lässt.
shares-all = Alle Sitzungen
shares-session = Sitzung { $number }
shares-state-open = Lässt sich öffnen
shares-state-closed = Ohne Einwilligung
shares-state-revoked = Widerrufen
shares-state-over = Abgelaufen
shares-state-dead = Gesperrt: fünf falsche PINs
shares-until = Bis { $moment }
shares-openings-none = Noch nicht geöffnet
shares-openings =
    { $count ->
        [one] Einmal geöffnet, { $moment }
       *[other] { $count }-mal geöffnet, zuletzt { $moment }
    }
shares-wrong =
    { $count ->
        [one] { $count } falsche PIN
       *[other] { $count } falsche PINs
    }
shares-made = Erstellt { $moment } von { $person }
shares-ended =
    { $count ->
        [one] { $count } beendeter Link
       *[other] { $count } beendete Links
    }
shares-revoke = Widerrufen
shares-revoke-label = Link widerrufen: { $what }, erstellt { $moment }
shares-revoked = Der Link wurde widerrufen. Er zeigt nichts mehr.
shares-what = Was er zeigt
shares-for = Wie lange
shares-days =
    { $count ->
        [one] { $count } Tag
       *[other] { $count } Tage
    }
shares-make = Link erstellen
shares-consent = Für einen geteilten Link muss der Patient in die Weitergabe nach außen einwilligen. Fragen Sie ihn, und tragen Sie die Einwilligung oben ein.
shares-new = Link und PIN (werden nur einmal gezeigt): { $what }
shares-new-lead = Senden Sie den Link. Teilen Sie die PIN auf anderem Weg mit, zum Beispiel am Telefon. Wer beides hat, kann die Dokumentation von { $code } lesen.
shares-pin = PIN
shares-done = Fertig
