### Texte der Kommentare zu Momenten eines Durchgangs.

comments-title = Kommentare
comments-none = Zu diesem Durchgang gibt es keine Kommentare.
comments-lost = Die Momente lassen sich nicht zeigen, weil es keine Wiedergabe gibt.
comments-go = Zu { $t } s gehen, dem Kommentar von { $person }
comments-at = { $t } s
comments-new = Neu
comments-write = Diesen Moment kommentieren
comments-text = Kommentar bei { $t } s
comments-hint = Alle, die diesen Patienten sehen dürfen, können ihn lesen, auch über einen geteilten Link.
comments-add = Kommentar hinzufügen
comments-added = Der Kommentar wurde hinzugefügt.
comments-change = Ändern oder zurückziehen
comments-change-label = Ändern oder zurückziehen: Ihr Kommentar bei { $t } s
comments-save = Änderung speichern
comments-revised = Der Kommentar wurde geändert.
comments-withdraw = Zurückziehen
comments-withdrawn = Der Kommentar wurde zurückgezogen.
comments-by = { $person }, { $moment }
comments-by-revised = { $person }, geändert { $moment }
comments-history =
    { $count ->
        [one] { $count } frühere Fassung
       *[other] { $count } frühere Fassungen
    }
comments-unread =
    { $count ->
        [one] { $count } ungelesener Kommentar
       *[other] { $count } ungelesene Kommentare
    }
