### Texte der Kalibrierung: Schritte, Vorgaben, Ergebnis.

calibrate-no-shirt = Noch kein Shirt
calibrate-no-shirt-lead = Die Kalibrierung lernt aus den Signalen des Shirts. Wählen Sie zuerst das Shirt.
calibrate-no-shirt-go = Shirt wählen
calibrate-step = Schritt { $step } von { $steps }
calibrate-repetition = Wiederholung { $repetition } von { $all }
calibrate-steps = Die Schritte der Kalibrierung
calibrate-step-waiting = noch offen
calibrate-step-running = wird aufgezeichnet
calibrate-step-done = fertig
calibrate-step-skipped = übersprungen
calibrate-step-failed = muss wiederholt werden
calibrate-start = Start
calibrate-again = Schritt wiederholen
calibrate-cancel = Abbrechen
calibrate-skip = Bewegung überspringen
calibrate-next = Weiter
calibrate-auto = Nach jedem Schritt automatisch weiter
calibrate-ready-self = Die simulierte Person folgt dem Kreis. Tippen Sie auf „{ $button }“.
calibrate-ready-visitor = Sie bewegen den Körper: Halten Sie die Tastfelder oder Tasten gedrückt, wie der Kreis es zeigt. Tippen Sie auf „{ $button }“.
calibrate-ready-patient = Wenn der Patient bereit ist, tippen Sie auf „{ $button }“.
calibrate-done = Fertig. Gehen Sie weiter, oder wiederholen Sie den Schritt.
calibrate-poor = Aufgezeichnet, aber damit würde man schlecht fahren. Wiederholen Sie den Schritt, oder gehen Sie trotzdem weiter.
calibrate-going-on = Gut gemacht. Gleich geht es weiter …
calibrate-now = Bereit zum Fahren
calibrate-now-lead = { $count } andere Personen haben sich in diesem Shirt bewegt. Beim virtuellen Rollstuhl ersetzen deren Bewegungen vorerst die eigenen. Die folgenden Bewegungen verbessern die Kalibrierung Gelenk für Gelenk, jetzt oder später.
calibrate-now-go = Jetzt fahren
calibrate-earlier = Es gibt eine Kalibrierung vom { $day } (Version { $version }). Machen Sie „Ausruhen“ und „Frei bewegen“. Danach kann sie wieder verwendet werden, angepasst an den heutigen Sitz des Shirts. Ein einzelnes Gelenk lässt sich nicht wiederholen, weil das Shirt neu angezogen wurde. Eine neue Kalibrierung braucht alle Schritte.
calibrate-earlier-lead = Die Kalibrierung vom { $day } (Version { $version }) kann wieder verwendet werden. Sie wird an den heutigen Sitz des Shirts angepasst, und die Steuerung bleibt, wie sie ist. Die folgenden Bewegungen ergeben dagegen eine neue Kalibrierung. Sie braucht alle Schritte.
calibrate-earlier-go = Mit dieser Kalibrierung fahren
calibrate-short = Kurze Kalibrierung
calibrate-whole = Ganze Kalibrierung
calibrate-short-good = Die Kalibrierung ist gut genug. Halten Sie still, und starten Sie den Durchgang.
calibrate-wait = Warten
calibrate-fitting = Die Bewegungen werden ausgewertet …
cue-ready = Bereit machen
cue-rest = Ausruhen
cue-free = Frei bewegen
cue-return = Langsam zurück
cue-move = Bewegen
cue-move-elbow = Beugen
cue-move-wrist = Beugen
cue-move-shoulder = Vorschieben
cue-seconds = { $seconds } s
cue-next-ready = Danach: bereit machen
cue-next-rest = Danach: ausruhen
cue-next-free = Danach: frei bewegen
cue-next-return = Danach: langsam zurück
cue-next-move = Danach: bewegen
cue-next-move-elbow = Danach: beugen
cue-next-move-wrist = Danach: beugen
cue-next-move-shoulder = Danach: vorschieben
cue-next-end = Danach: Ende dieses Schritts
cue-trace = Die Signale des Shirts, die letzten 10 Sekunden
result-title = Mögliche Bewegungen
result-lead = Jede Karte zeigt, wie klar die Hauptbewegung eines Gelenks ist und wie gut sie voraussichtlich funktioniert. Die Marken zeigen die 80 bis 90 % der Studie von 2008.
result-repeat = Wiederholen
result-evr = Klare Hauptbewegung: { $percent }
result-signal = Signal: { $word }
result-repeats = Wiederholbar: { $word }
signal-strong = stark
signal-fair = mittel
signal-weak = schwach
repeats-well = gut
repeats-fairly = mittel
repeats-poorly = schlecht
result-from-others = Von anderen Personen
result-from-both = Von anderen Personen und eigener Bewegung
result-from-own = Eigene Bewegung
result-from-others-lead = Aus den Bewegungen von { $count } anderen Personen gelernt.
result-expected-hits = Von 100 Bewegungen werden etwa { $value } erkannt (± { $uncertainty }).
result-expected-false = In Ruhe löst die Bewegung etwa { $value }-mal pro Minute aus (± { $uncertainty }).
result-expected-prompted = Nach den Wiederholungen dieser Bewegung ist die erste Zahl sicherer (± { $uncertainty }). Dann ist auch bekannt, wie oft die Bewegung in Ruhe auslöst.
result-expected-hits-none = Wie viele von 100 Bewegungen erkannt werden, ist noch nicht bekannt. In der freien Bewegung kam diese Richtung nicht vor.
result-expected-false-none = Wie oft die Bewegung in Ruhe auslöst, ist bekannt, sobald sie wiederholt wurde.
result-expected-own-hits = Von 100 Bewegungen werden etwa { $value } erkannt. So wenige Wiederholungen belegen nur, dass es mindestens { $bound } sind.
result-expected-own-false = In Ruhe löst die Bewegung { $value }-mal pro Minute aus. Eine so kurze Ruhe belegt nur, dass es weniger als { $bound }-mal ist.
result-expected-none = Wie gut die Bewegung funktioniert, ist bekannt, sobald sie wiederholt wurde.
result-sits-shifted = Das Shirt ist verdreht ({ $joint }): um { $count } von { $sensors } Sensoren.
result-sits-mirrored = Das Shirt ist auf links gedreht oder seitenverkehrt angezogen ({ $joint }).
result-sits-lead = Diese Kalibrierung berücksichtigt das. Sie können es so lassen. Oder Sie richten das Shirt, wie das Bild es zeigt, und beginnen die Kalibrierung neu. Wenn Sie sicher sind, dass es richtig sitzt, tippen Sie auf „Sitzt richtig“.
result-sits-right = Sitzt richtig
result-sits-right-label = Sitzt richtig ({ $joint }): das Shirt so kalibrieren, wie es getragen wird
result-sits-left = Das Shirt scheint verdreht ({ $joint }). Es wird verwendet, wie es getragen wird, weil Sie „Sitzt richtig“ angegeben haben.
result-sits-follow = Als verdreht behandeln
result-sits-follow-label = Als verdreht behandeln und das berücksichtigen ({ $joint })
result-sits-picture-mirrored = Die Sensoren einer Seite liegen auf der anderen Seite ({ $joint }): Wenden Sie das Shirt, oder ziehen Sie es über den anderen Arm
result-sits-side-front = vorne
result-sits-side-back = hinten
result-sits-side-outside = außen
result-sits-side-inside = innen
result-sits-picture = Drehen Sie das Shirt um { $count } von { $sensors } Sensoren ({ $joint })
result-details = Details
result-details-signal = Die volle Bewegung ist { $value }-mal so stark wie das Rauschen in Ruhe (Signal-Rausch-Verhältnis).
result-details-repeats = Die Spitzenwerte der Wiederholungen liegen höchstens { $percent } auseinander.
result-details-evr = Anteil des Signals in einer Richtung (erklärte Varianz, EVR): { $percent }.
result-again = Gelenk wiederholen
result-again-label = Gelenk wiederholen: { $joint }
result-maps-pca = Standard
result-maps-guided = Aus Vorgaben gelernt
result-maps-choose = { $joint }: welche Kalibrierung verwendet wird
result-maps-better = Eine andere Kalibrierung ist verfügbar
result-maps-in-use-guided = Die aus den Vorgaben gelernte Kalibrierung wird verwendet
result-maps-in-use-prior = Die von anderen Personen gelernte Kalibrierung wird verwendet
result-maps-prior = Von anderen gelernt
result-maps-lead-prior =
    { $count ->
        [one] Jeder Wert stammt von { $count } Wiederholung dieser Person. Diese Wiederholung hat die von anderen gelernte Kalibrierung nicht mitbestimmt.
       *[other] Jeder Wert stammt von { $count } Wiederholungen dieser Person. Die von anderen gelernte Kalibrierung wurde jeweils ohne die Wiederholung ergänzt, an der sie geprüft wurde.
    }
result-maps-lead-guided =
    { $count ->
        [one] Beide wurden aus dieser Kalibrierung gelernt. Jeder Wert stammt von { $count } Wiederholung, die zum Prüfen zurückgehalten wurde.
       *[other] Beide wurden aus dieser Kalibrierung gelernt. Jeder Wert stammt von { $count } Wiederholungen, die zum Prüfen zurückgehalten wurden.
    }
result-maps-in-phase = Anteil der Steuerung, der zur verlangten Bewegung passt
result-maps-hit = Anteil der Zeit mit verlangter Bewegung, in dem sie steuert
result-maps-false = Steuert in Ruhe, pro Minute
result-maps-kept-guided = Die aus den Vorgaben gelernte Kalibrierung wird nicht angeboten: Sie wäre für dieses Gelenk nicht besser.
result-maps-kept-prior = Die von anderen Personen gelernte Kalibrierung wird nicht angeboten: Sie wäre für dieses Gelenk nicht besser.
result-maps-details = Die Standardkalibrierung ist die Hauptrichtung der Bewegung (PCA). Die andere ist eine lineare Abbildung, die den Vorgaben folgt.
result-bar = { $joint }: klare Hauptbewegung { $percent }; in der Studie 80 bis 90 %
result-cross = Was bei einer Bewegung noch mitzählt
result-cross-lead = 1,00 ist die Stärke, mit der die verlangte Bewegung zählt. Kleine Zahlen daneben sind gut.
result-cross-asked = verlangt: { $joint }
result-left-out =
    { $count ->
        [one] { $count } Sensor ausgelassen: { $which }
       *[other] { $count } Sensoren ausgelassen: { $which }
    }
result-left-out-none = Alle Sensoren werden verwendet.
result-accept = Diese Kalibrierung verwenden
result-accepted = Diese Kalibrierung wird verwendet.
result-go-on = Weiter zur Steuerung
result-others-lead =
    { $count ->
        [one] { $count } Bewegung wurde noch nicht aufgezeichnet. Bis dahin werden dafür Kalibrierungen anderer Personen verwendet. Fahren Sie jetzt, oder zeichnen Sie zuerst die Bewegung auf.
       *[other] { $count } Bewegungen wurden noch nicht aufgezeichnet. Bis dahin werden dafür Kalibrierungen anderer Personen verwendet. Fahren Sie jetzt, oder zeichnen Sie zuerst die Bewegungen auf.
    }
result-missing = Das Ergebnis erscheint, wenn alle Schritte fertig sind.
result-missing-lead =
    { $count ->
        [one] Ein Schritt fehlt.
       *[other] { $count } Schritte fehlen.
    }
result-restart = Neu beginnen
result-restart-ask = Die Kalibrierung neu beginnen? Was bisher aufgezeichnet wurde, zählt dann nicht mehr.
result-restarted = Die Kalibrierung beginnt neu.
