### Texts about studies with simulated people: refusals, tables, sentences on the results, and labels of the figures.

## Refusals

study-folder-is-file = { $folder } ist eine Datei und kein Ordner; nennen Sie einen anderen Ort
# --overwrite: an option of the command, not translated.
study-folder-not-empty = { $folder } ist nicht leer; nennen Sie einen anderen Ordner, oder ersetzen Sie ihn mit --overwrite
study-no-prior = für das simulierte Shirt wird keine Starthilfe mitgeliefert; erstellen Sie eine mit `make shipped FILE=prior`

## Several people, each with their own seed (a number from which a simulated person is made)

# measure: the name of a measure, as in “Area off the path”. first, last: its median with its unit, or study-none-reached.
study-over-seeds = { $measure }: Median in Durchgang 1: { $first }, in Durchgang { $trials }: { $last }; von { $seeds } Personen gefallen bei { $falls }, gestiegen bei { $rises } und innerhalb der Schwankung bei { $no_trend }; unter den ersten { $early } Durchgängen liegt der größte Schritt bei { $early_steps }.
study-over-seeds-step = { $measure }: Median in Durchgang 1: { $first }, in Durchgang { $trials }: { $last }; von { $seeds } Personen gefallen bei { $falls }, gestiegen bei { $rises } und innerhalb der Schwankung bei { $no_trend }; unter den ersten { $early } Durchgängen liegt der größte Schritt bei { $early_steps }, der des Medians ab Durchgang { $step }.
study-none-reached = niemand hat das Ziel erreicht
study-left-out =
    { $missed ->
        [one] { $missed } von { $count } Durchgängen hat das Ziel nicht rechtzeitig erreicht und ist in diesen Zahlen nicht enthalten.
       *[other] { $missed } von { $count } Durchgängen haben das Ziel nicht rechtzeitig erreicht und sind in diesen Zahlen nicht enthalten.
    }

## A fixed and an adapted map

study-area-title = Fläche neben der Strecke, m²
# Titles of columns. fixed, adapted: medians with the fixed and the adapted map; reached: how many trials reached the goal
# with each; both drove: how many people always reached the goal with both, relative there: the difference for these;
# 95 %: an interval.
study-column-session = Sitzung
study-column-seed = Seed
study-column-fixed = fest
study-column-adapted = angepasst
study-column-reached-fixed = erreicht, fest
study-column-reached-adapted = erreicht, angepasst
study-column-both-drove = mit beiden
study-column-relative = relativ
study-column-relative-there = relativ dort
study-column-interval = 95 %
study-session = Sitzung { $session }
# The bounds of an interval, in percent.
study-interval = { $low } bis { $high }
# relative: a difference in percent; interval: a text study-interval, or a dash.
study-later-sessions = Alle Durchgänge ab Sitzung 2: Mittel { $fixed } m² fest, { $adapted } m² angepasst: { $relative } (95 %: { $interval }); erreicht: { $reached_fixed } % und { $reached_adapted } %.
study-last-session = Median über { $seeds } Seeds in der letzten Sitzung: { $relative } (95 %: { $interval }). Vorschläge für eine Person: Median { $median }, höchstens { $most }. Angewendete Schritte: { $steps }; größte spürbare Änderung { $felt_change } %, größte Drehung { $turn } Grad, Vorzeichenwechsel: { $flips }.

## The two-minute test

study-test-title = Zwei-Minuten-Test, Mediane über die Personen
# Titles of columns. first entry: seconds until the target is entered first; dial-in: from then until it is held.
study-test-targets = Ziele/min
study-test-missed = verfehlt
study-test-first-entry = erster Eintritt, s
study-test-dial-in = Einpendeln, s
study-test-straightness = Geradheit
study-test-throughput = Durchsatz, bit/s (10 bis 90 %)
study-test-area = Fläche neben der Strecke, m²
study-test-reached = am Ziel
study-spread = ({ $low } bis { $high })
# between, within: a number from −1 to 1, or a dash.
study-rank-correlation = Rangkorrelation des Durchsatzes mit der Fläche neben der Strecke in den Durchgängen derselben Sitzung: zwischen Personen { $between }, innerhalb von Personen { $within }.

## Figures. Dist is the symbol of the distance driven; letter: of a panel of the figure.

study-panel-trial = ({ $letter }) Durchgang { $number }
study-panel-all = ({ $letter }) Alle { $count } Durchgänge
study-panel-people = ({ $letter }) Durchgang { $number }, { $count } Personen
study-panel-dist = ({ $letter }) Dist: gefahrener Weg
study-panel-area = ({ $letter }) { $symbol }: Fläche zwischen Fahrspur und Strecke
study-prescribed-path = vorgegebene Strecke, { $length } m (● Start, ■ Ziel)
study-trajectory = Fahrspur
study-path-length = Länge der Strecke
study-one-person = eine Person
study-middle-half = mittlere Hälfte
study-median = Median von { $count }
study-band = 95-%-Band
study-learning-curve = Lernkurve
study-trial = Durchgang
