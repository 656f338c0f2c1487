### Texte zur Auswertung eines Durchgangs und zweier Durchgänge nebeneinander.

compare-column = Vergleich
compare-pick = Durchgang { $number } vergleichen
compare-go = Zwei Durchgänge vergleichen
compare-chosen = Durchgang { $first } und Durchgang { $second } sind gewählt.
compare-choose =
    { $count ->
        [one] Haken Sie noch einen Durchgang an.
       *[other] Haken Sie zwei Durchgänge der Liste an.
    }
compare-title = Zwei Durchgänge nebeneinander
compare-trial = Durchgang { $number }
compare-difference = Unterschied
compare-measures = Messwerte
compare-plan = Beide Fahrspuren über der Strecke
compare-now = { $along } m entlang der Strecke, { $v } m/s, { $across } m daneben
compare-now-spot = { $v } m/s
compare-along = entlang der Strecke (m)
compare-speed = Tempo entlang der Strecke
compare-speed-axis = Tempo (m/s)
compare-across = Seitlicher Abstand zur Strecke
compare-across-axis = Abstand zur Strecke (m), links positiv
compare-start = Beide beginnen, sobald der Rollstuhl fahren durfte.
compare-other-path = Diese zwei wurden nicht auf derselben Strecke gefahren. Deshalb stehen nur ihre Messwerte nebeneinander, und Unterschiede sagen wenig aus.
compare-no-recording = Es gibt keine Wiedergabe: { $why }
compare-pairs = Wählen Sie zwei Durchgänge unter „Auswertung“.
compare-verdict = Bewertung von Durchgang { $number }
compare-used = Ein Durchgang zur Eingewöhnung wird nicht verglichen: Durchgang { $numbers }.
compare-no-measures = Keiner der beiden wurde ausgewertet.
replay-title = Noch einmal ansehen
replay-play = Abspielen
replay-pause = Pause
replay-speed = Tempo der Wiedergabe
replay-slider = Moment des Durchgangs
replay-at = { $t } von { $end } Sekunden
replay-keys = Pfeiltasten springen um eine Sekunde, mit Umschalttaste um zehn. P startet und hält an. Die Leertaste bedeutet Stopp, wie überall.
replay-plan = Von oben
replay-events = Was geschah
replay-charts = Signale, Bewegungen und Fahrbefehle
replay-charts-lead = Tippen Sie in ein Diagramm, um zu diesem Moment zu springen. Wo es grau ist, durfte der Rollstuhl nicht fahren.
replay-chart = { $title } über die Zeit
replay-chair = Rollstuhl
replay-v = Tempo
replay-omega = Drehtempo
replay-commands = Fahrbefehle
replay-activations = Wie stark jede Bewegung zählt
replay-rates = Bewegung pro Sekunde
replay-scores = Umfang der Bewegung
replay-command-speed = Tempo
replay-command-turning = Drehen
replay-unit-full = 1 ist voll
replay-unit-rate = Anteil der vollen Bewegung pro Sekunde
replay-unit-share = Anteil der vollen Bewegung
replay-signals = Signale: { $shown } von { $of } Sensoren
replay-joint = Sensoren von
replay-none = Von diesem Durchgang gibt es keine Wiedergabe.
replay-look = Noch einmal ansehen
replay-picture = Bild der Wiedergabe
replay-picture-off = Die Wiedergabe in 3D ist aus: { $why }
replay-picture-loading = Das Bild wird geladen …
replay-picture-webgl = Dieser Bildschirm kann die 3D-Ansicht nicht zeichnen (sein Browser bietet kein WebGL 2). Deshalb läuft die Wiedergabe in der Planansicht.
replay-picture-context = Der Browser hat die Grafik dieser Seite abgeschaltet. Wählen Sie „Plan“, oder warten Sie, bis sie wieder da ist.
replay-picture-again = In 3D zeigen
