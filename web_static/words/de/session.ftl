### Texte zur Dokumentation einer Sitzung, zu Sitzungen und Einwilligungen eines Patienten und zu zwei Sitzungen nebeneinander.

rail-session = Sitzungen
record-title = Sitzung { $number } von { $code }
record-sessions = Sitzungen von { $code }
record-sessions-lead = Öffnen Sie eine Sitzung, um ihre Dokumentation zu sehen. Oder haken Sie zwei an, um sie nebeneinander zu sehen.
record-sessions-none = Es gibt noch keine Sitzung. Die erste beginnt, wenn Sie auf der Seite „Patienten“ eine Sitzung starten.
record-link = Sitzungen und Einwilligungen
record-link-label = Sitzungen und Einwilligungen von { $code }
record-back = Alle Sitzungen
record-story = Ablauf
record-story-label = Ablauf der Sitzung { $number }
record-story-title = Ablauf der Sitzung { $number } von { $code }
record-story-record = Dokumentation
origin-words = Herkunft: { $clinic }; importiert von { $person }, { $moment }
record-began = Begonnen { $moment }
record-began-by = Begonnen { $moment } von { $person }
record-version = Software { $version }
record-version-none = Software nicht erfasst
record-state-open = Jetzt offen
record-state-ended = Nicht abgezeichnet
record-state-signed = Abgezeichnet
record-only-read = Sie dürfen diese Dokumentation lesen und nichts ändern.
record-goal = Ziel, in den Worten des Patienten
record-goal-none = Es wurde kein Ziel eingetragen.
record-goal-hint = Was der Patient in dieser Sitzung erreichen möchte.
record-goal-save = Ziel speichern
record-goal-saved = Das Ziel wurde gespeichert.
record-notes = Notizen
record-notes-none = Es wurde keine Notiz geschrieben.
record-note-new = Neue Notiz
record-note-add = Notiz hinzufügen
record-note-revise = Ändern
record-note-revise-label = Ändern: Notiz von { $person }, { $moment }
record-note-save = Änderung speichern
record-note-text = Text der Notiz
record-note-by = { $person }, { $moment }
record-note-revised = { $person }, geändert { $moment }
record-note-history =
    { $count ->
        [one] { $count } frühere Fassung
       *[other] { $count } frühere Fassungen
    }
record-scales = Assessments
record-scales-none = Es wurde kein Assessment eingetragen.
record-scale-name = Assessment
record-scale-name-hint = Zum Beispiel SCIM III oder WST 5.0.
record-scale-total = Gesamtwert
record-scale-total-hint = Nur der Gesamtwert. Die Fragen der meisten Bögen sind lizenzpflichtig.
record-scale-total-missing = Geben Sie den Gesamtwert als Zahl ein.
record-scale-day = Datum
record-scale-add = Hinzufügen
record-scale-remove = Entfernen
record-scale-remove-label = Entfernen: { $name }, { $day }
record-driven = Was gefahren wurde
record-driven-none = In dieser Sitzung wurde nichts gefahren.
record-driven-trial = { $plan }, Durchgang { $number }
record-driven-counts = zählt
record-driven-discarded = verworfen: { $reason }
record-driven-drives =
    { $count ->
        [one] { $count } Fahrt mit einem echten Rollstuhl
       *[other] { $count } Fahrten mit einem echten Rollstuhl
    }
record-tests = Zwei-Minuten-Tests
record-driven-task = Durchgang
record-driven-kept = Zählt
record-sets = Kalibrierung und Steuerung
record-set = Kalibrierung { $version } mit dem Set „{ $title }“
record-details = Details
record-set-hash = Fingerabdruck des Sets: { $hash }
record-sign = Abzeichnen
record-sign-lead = Das Abzeichnen sperrt Ziel, Notizen, Assessments und Durchgänge dieser Sitzung. Nur Verantwortliche können sie entsperren.
record-sign-ends = Diese Sitzung ist noch offen. Sie endet mit dem Abzeichnen.
record-sign-go = Abzeichnen
record-sign-sure = Als { $person } abzeichnen?
record-sign-yes = Ja, abzeichnen
record-signed = Abgezeichnet von { $person }, { $moment }.
record-signed-past = Abgezeichnet von { $person }, { $moment }; entsperrt von { $owner }, { $unlocked }: { $reason }
record-signed-done = Die Sitzung ist abgezeichnet.
record-unlock = Entsperren
record-unlock-reason = Grund für das Entsperren
record-unlock-reason-hint = Der Grund bleibt im Verlauf und im Protokoll.
record-unlock-yes = Sitzung entsperren
record-compare = Beide vergleichen
record-compare-pick = Sitzung { $number } vergleichen
record-compare-choose =
    { $count ->
        [one] Haken Sie noch eine Sitzung an.
       *[other] Haken Sie zwei Sitzungen an.
    }
record-compare-title = Zwei Sitzungen nebeneinander
record-compare-lead = { $code }: Sitzung { $earlier } und Sitzung { $later }
record-compare-nothing = In keiner der beiden Sitzungen wurde etwas gefahren.
record-compare-trials = Durchgänge der Sitzung { $number }: gefahren { $driven }, zählen { $counted }, verglichen { $compared }.
record-compare-tests = Sitzung { $number }: vollständige Tests: { $complete }.
record-compare-tests-newest = Hier steht jeweils der neueste vollständige Test.
record-compare-none = Kein Durchgang dieser Aufgabe lässt sich vergleichen: Die ersten drei dienen der Eingewöhnung. Fahren Sie die Aufgabe in einer weiteren Sitzung noch einmal.
record-compare-range = ({ $low } bis { $high })
record-compare-spread = Jeder Wert ist der Median. Die Hälfte der Durchgänge liegt in dem Bereich in Klammern.
record-compare-task = { $plan }: { $path }
record-compare-changed = Was sich an Kalibrierung und Steuerung geändert hat
record-compare-same = Kalibrierung und Steuerung sind gleich.
record-compare-unknown = Die Steuerung lässt sich nicht vergleichen: In einer der beiden Sitzungen wurde nichts gefahren, oder eine andere Programmversion hat sie gespeichert.
record-compare-maps = Kalibrierung { $earlier } in Sitzung { $first }, Kalibrierung { $later } in Sitzung { $second }.
consent-title = Einwilligungen
consent-lead = Jede ist aus, bis der Patient sie erteilt. Er kann sie jederzeit widerrufen.
consent-recording = Aufzeichnung
consent-recording-hint = Signale und Durchgänge werden mit einem getragenen Shirt oder einer Kamera aufgezeichnet; das Bild der Kamera wird weder aufgezeichnet noch gesendet. Üben mit dem simulierten Shirt braucht keine Einwilligung.
consent-clinic-prior = Verwendung für andere Patienten der Klinik
consent-clinic-prior-hint = Durchgänge helfen, eine Änderung von Schwankung zu unterscheiden. Bewegungen helfen neuen Patienten, früher zu fahren. Niemand ist darin erkennbar. Wird die Einwilligung widerrufen, werden sie wieder entfernt.
consent-sharing = Weitergabe nach außen
consent-sharing-hint = Dokumentation darf die Klinik als Bericht, geteilter Link oder Export verlassen.
consent-given = Erteilt { $day }
consent-by = Erteilt { $day }, eingetragen von { $person }
consent-off = Nicht erteilt
consent-day = Tag der Einwilligung
consent-give = Eintragen
consent-give-label = Einwilligung eintragen: { $consent }
consent-withdraw = Widerrufen
consent-withdraw-label = Einwilligung widerrufen: { $consent }
consent-history = Verlauf
consent-past = { $day } bis { $withdrawn }, widerrufen von { $person }
consent-needed = { $code } hat nicht in die Aufzeichnung eingewilligt.
consent-needed-why = Mit einem getragenen Shirt wird ohne Einwilligung nichts aufgezeichnet. Fragen Sie den Patienten, und tragen Sie die Einwilligung ein.
consent-needed-go = Einwilligung eintragen
