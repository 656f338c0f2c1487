### Texte des Zwei-Minuten-Tests vor dem Fahren.

rail-interface-test = Zwei-Minuten-Test
test-lead = Auf einem Kreuz erscheinen Ziele. Der Patient bringt mit den Bewegungen der Steuerung einen Punkt in jedes davon. Kein Rollstuhl bewegt sich dabei. Der Test zeigt vor dem Fahren, wie gut die Bewegungen heute funktionieren.
test-cross = Kreuz mit einem Ziel und einem Punkt: oben ist schneller, unten ist langsamer, links und rechts ist drehen
test-before = Der Punkt steht in der Mitte. Der Patient ist in Ruhe, und der Test beginnt drei Sekunden nach dem Start.
test-wait = Der Test beginnt.
test-phase-ready = Ruhe. Das erste Ziel kommt gleich.
test-phase-running = Bringen Sie den Punkt in das Ziel, und halten Sie ihn dort eine Sekunde.
test-phase-over = Fertig. Das Ergebnis wird berechnet.
test-count =
    { $count ->
        [one] { $count } Ziel erreicht
       *[other] { $count } Ziele erreicht
    }
test-start = Test starten
test-end-it = Test beenden
test-drive = Zum Fahren
test-result = Test { $number }
test-session = Sitzung { $number }
test-number = Test
test-reached = { $acquired } Ziele erreicht, { $missed } verfehlt, innerhalb von { $seconds } s.
test-so-far = Bis dahin (nach { $seconds } s) erreichte Ziele: { $count }.
test-end-by-hand = Dieser Test wurde vorzeitig beendet und zählt deshalb nicht.
test-end-stopped = Dieser Test wurde gestoppt und zählt deshalb nicht.
test-end-fault = Dieser Test wurde unterbrochen, weil das Shirt oder das Programm nicht mehr sendete. Er zählt nicht.
test-end-complete = Die Aufzeichnung dieses Tests ist nicht lesbar, deshalb gibt es keine Werte.
test-details = Weitere Werte und was sie bedeuten
test-ways = Wege zu den Zielen nach Richtung
test-ways-way = Richtung
test-ways-acquired = Erreicht
test-ways-missed = Verfehlt
test-ways-time = Zeit
test-way-ahead = Oben (schneller)
test-way-back = Unten (langsamer)
test-way-left = Links
test-way-right = Rechts
test-publications = In Veröffentlichungen: acquisition rate, throughput nach ISO 9241-411 mit der effektiven Breite, first-entry time, dial-in time, path efficiency.
test-curve = Verlauf über die Tests
test-one = Ab dem zweiten Test stehen hier eine Kurve und ein Vergleich.
test-against = Neuester gegen Test { $number }
test-noise = Schwankung ist der Unterschied zwischen den eigenen Tests dieser Person, wenn sich nichts geändert hat. Eine Bewertung braucht fünf vollständige Tests. Tests mit verschiedenen Quellen, etwa mit simuliertem und mit getragenem Shirt, werden nie verglichen.
test-workload = Wie anstrengend war es?
test-workload-lead = Sechs Fragen an den Patienten, von 0 bis 100. Jede darf ausgelassen werden.
test-workload-mental = Denken: Wie viel Konzentration war nötig?
test-workload-physical = Körper: Wie anstrengend war es?
test-workload-temporal = Zeit: Wie gehetzt haben Sie sich gefühlt?
test-workload-performance = Erfolg: Wie gut ist es gelungen?
test-workload-effort = Mühe: Wie sehr mussten Sie sich anstrengen?
test-workload-frustration = Stimmung: Wie verärgert oder entmutigt waren Sie?
test-workload-low-other = Sehr wenig
test-workload-high-other = Sehr stark
test-workload-low-performance = Perfekt
test-workload-high-performance = Gar nicht
test-workload-none = Keine Antwort
test-workload-leave-out = Auslassen
test-workload-clear = Auslassen: { $question }
test-workload-save = Antworten speichern
test-workload-saved = Gespeichert.
test-workload-sum = Beanspruchung (Mittel der sechs): { $value } von 100.
test-workload-of = Test { $number }: { $value }
patient-test-ready = Ruhe. Gleich kommt ein Ziel.
patient-test-running = Bringen Sie den Punkt in das Ziel.
patient-test-over = Fertig. Ruhen Sie sich etwas aus.
drive-place-test = Zwei-Minuten-Test
drive-place-test-state = Wie gut die Bewegungen heute funktionieren
