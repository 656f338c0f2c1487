### Measures of trials and of the two-minute test: their names, and what they measure.

# A level, as in "1.23 m²": $unit stands in no catalogue, because units are written alike in every language.
measure-with-unit = { $figure } { $unit }
measure-degrees = { $figure }°
# A difference of two shares, as in "fell by about 12 percentage points". $count is that number, $figure how it is written.
measure-points =
    { $count ->
        [one] { $figure } Prozentpunkt
       *[other] { $figure } Prozentpunkte
    }
measure-number = { $figure }

## Measures of a trial. The message that ends in "-subject" is the measure within a sentence, as in "Within noise over 12
## trials: the area off the path was about 1.23 m²." The one that ends in "-definition" says for exports what is measured.

measure-stages-done = Erledigte Abschnitte
measure-stages-done-subject = die Zahl der erledigten Abschnitte
measure-stages-done-definition = Zahl der erledigten Abschnitte
measure-follow-error-rms = Üblicher Fehler des Abstands beim Folgen
measure-follow-error-rms-subject = der übliche Fehler des Abstands beim Folgen
measure-follow-error-rms-definition = Quadratischer Mittelwert des Abstandsfehlers beim Folgen
measure-follow-error-max = Größter Fehler des Abstands beim Folgen
measure-follow-error-max-subject = der größte Fehler des Abstands beim Folgen
measure-follow-near = Zeitanteil nahe am verlangten Abstand
measure-follow-near-subject = der Zeitanteil nahe am verlangten Abstand
measure-heading-error-deg = Abweichung von der verlangten Ausrichtung
measure-heading-error-deg-subject = die Abweichung von der verlangten Ausrichtung
measure-heading-error-deg-definition = Fehler der Ausrichtung
measure-turn-drift = Abweichung von der Stelle
measure-turn-drift-subject = die Abweichung von der Stelle
measure-turn-drift-definition = Größter Abstand zur Stelle der Drehung
measure-cones-touched = Berührte Kegel
measure-cones-touched-subject = die Zahl der berührten Kegel
measure-cones-touched-definition = Zahl der berührten Kegel
measure-gap-clearance = Kleinster Abstand in einer Engstelle
measure-gap-clearance-subject = der kleinste Abstand in einer Engstelle
measure-gap-clearance-definition = Kleinster Abstand in Engstellen
measure-door-contacts = Berührungen an Tür oder Engstelle
measure-door-contacts-subject = die Zahl der Berührungen an einer Tür oder Engstelle
measure-door-contacts-definition = Zahl der Berührungen an Türen
measure-e-diff = Fläche neben der Strecke
measure-e-diff-subject = die Fläche neben der Strecke
measure-e-diff-definition = Fläche zwischen Fahrspur und Strecke
measure-dist = Gefahrener Weg
measure-dist-subject = der gefahrene Weg
measure-time = Zeit
measure-time-subject = die Zeit für einen Durchgang
measure-time-definition = Zeit bis zum Ziel
measure-dist-ratio = Weg im Verhältnis zur Strecke
measure-dist-ratio-subject = der gefahrene Weg im Verhältnis zur Länge der Strecke
measure-dist-ratio-definition = Gefahrener Weg geteilt durch die Länge der Strecke
measure-cross-track-rms = Üblicher Abstand zur Strecke
measure-cross-track-rms-subject = der übliche Abstand zur Strecke
measure-cross-track-rms-definition = Quadratischer Mittelwert des Abstands zur Strecke
measure-cross-track-max = Größter Abstand zur Strecke
measure-cross-track-max-subject = der größte Abstand zur Strecke
measure-mean-speed = Mittleres Tempo
measure-mean-speed-subject = die mittlere Geschwindigkeit
measure-stops = Stillstände
measure-stops-subject = die Zahl der Stillstände
measure-stops-definition = Zahl der Stillstände
measure-collisions = Berührungen
measure-collisions-subject = die Zahl der Berührungen mit Wänden und Hindernissen
measure-collisions-definition = Zahl der Kollisionen
measure-contact-time = Zeit in Berührung
measure-contact-time-subject = die Zeit in Berührung mit Wänden und Hindernissen
measure-contact-time-definition = Zeit in Berührung mit Wänden und Hindernissen
measure-turn-reversals = Wechsel der Drehrichtung
measure-turn-reversals-subject = die Zahl der Wechsel zwischen Links- und Rechtsdrehen
measure-turn-reversals-definition = Zahl der Richtungswechsel des Fahrbefehls zum Drehen
measure-pulses-per-metre = Fahrbefehle pro Meter
measure-pulses-per-metre-subject = die Zahl der Fahrbefehle pro Meter
measure-pulses-per-metre-definition = Zahl der Fahrbefehle pro Meter
measure-sparc = Gleichmäßigkeit
measure-sparc-subject = die Gleichmäßigkeit der Geschwindigkeit (höher ist gleichmäßiger)
measure-sparc-definition = Gleichmäßigkeit: spektrale Bogenlänge
measure-ldlj = Gleichmäßigkeit, zweites Maß
measure-ldlj-subject = das zweite Maß für die Gleichmäßigkeit der Geschwindigkeit (höher ist gleichmäßiger)
measure-ldlj-definition = Gleichmäßigkeit: Logarithmus des dimensionslosen Rucks

## What interrupted a trial.

measure-halts = Halte durch die Technik
measure-halts-definition = Zahl der Halte durch die Technik; kein anderer Messwert enthält ihre Zeit
measure-halt-time = Dauer der Halte durch die Technik
measure-pauses = Pausen wegen des Bildschirms
measure-pauses-definition = Zahl der Pausen wegen des Bildschirms
measure-pause-time = Pausendauer wegen des Bildschirms
measure-pause-time-definition = Dauer der Pausen wegen des Bildschirms
measure-person-stops = Stopps durch eine Person
measure-person-stops-definition = Zahl der Stopps durch eine Person
measure-person-stop-time = Dauer der Stopps durch eine Person

## What the measures of a trial are of.

measure-path-length = Länge der Strecke
measure-cross-track-mean = Mittlerer Abstand zur Strecke, links positiv
measure-stages = Abschnitte
measure-cones = Kegel
measure-gaps = Engstellen

## Measures of the two-minute test, in which a dot is moved from target to target.

measure-acquisitions-per-minute = Ziele pro Minute
measure-acquisitions-per-minute-definition = Zwei-Minuten-Test: Ziele pro Minute
measure-acquisitions-per-minute-meaning = Wie viele Ziele in jeder Minute des Tests erreicht und eine Sekunde lang gehalten wurden.
measure-throughput = Tempo und Genauigkeit zusammen
measure-throughput-definition = Zwei-Minuten-Test: Durchsatz (ISO 9241-411, effektive Breite)
measure-throughput-meaning = Wie viel Information die Bewegungen tragen: Wer bei gleicher Genauigkeit doppelt so schnell ist, erreicht den doppelten Wert. Höher ist besser. Bei weniger als acht Zielen gibt es keinen Wert.
measure-first-entry = Zeit bis in ein Ziel
measure-first-entry-definition = Zwei-Minuten-Test: Zeit bis zum ersten Eintritt in ein Ziel
measure-first-entry-meaning = Vom Erscheinen eines Ziels, bis der Punkt zum ersten Mal darin ist: das Mittel der erreichten Ziele.
measure-dial-in = Zeit zum Einpendeln
measure-dial-in-definition = Zwei-Minuten-Test: Zeit vom ersten bis zum letzten Eintritt
measure-dial-in-meaning = Vom ersten Eintritt in ein Ziel, bis der Punkt darin bleibt: 0, wenn der Punkt kein Ziel wieder verlässt.
measure-path-efficiency = Geradheit des Wegs
measure-path-efficiency-definition = Zwei-Minuten-Test: gerader Weg geteilt durch den Weg des Cursors
measure-path-efficiency-meaning = Der gerade Weg geteilt durch den Weg, den der Punkt nahm: 100 % ist gerade.

## Names beside the measures.

measure-reached = Ziel erreicht
measure-workload = Beanspruchung, 0 bis 100

## Errors in a table of a trajectory, and in recordings. The name of a file may stand before the sentence. $column is the
## name of a column, such as x.

measure-no-rows = die Fahrspur hat keine Zeilen; zeichnen Sie zuerst einen Durchgang auf
measure-not-finite = in Zeile { $row } steht für { $column } keine endliche Zahl; korrigieren Sie sie
measure-time-backwards = t läuft in Zeile { $row } rückwärts; ordnen Sie die Zeilen nach der Zeit
measure-lengths = Zeilen von { $column }: { $rows }, Zeilen von t: { $times }; machen Sie beide gleich lang
measure-no-number = „{ $name }“ ist keine Zahl
measure-quality-no-frames = die Aufzeichnung enthält aus der Zeit, in der gefahren werden durfte, keine Datenpakete dieses Shirts; fahren Sie zuerst einen Durchgang
measure-quality-gestures = die Aufzeichnung enthält andere Gesten als ihre Parameter und lässt sich nicht auswerten; fahren Sie noch einmal
measure-forecast-channels = Kanäle der Aufzeichnung: { $recorded }, Kanäle des Kalibrierungsprofils: { $channels }; verwenden Sie das Profil desselben Shirts
