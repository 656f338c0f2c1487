### What is said about trials: verdicts, warnings of control quality, events and interruptions.

## A verdict in a table: how a measure changed.

verdict-word-better = über die Schwankung hinaus besser
verdict-word-within = innerhalb der Schwankung
verdict-word-worse = über die Schwankung hinaus schlechter
verdict-word-few-trials = zu wenige Durchgänge
verdict-word-few-tests = zu wenige Tests
# There is no verdict.
verdict-word-none = –

## A measure that has become worse over sessions.

verdict-worse = Seit Sitzung { $session } über die eigene Schwankung dieser Person hinaus schlechter. Das hilft: Prüfen Sie den Sitz des Shirts und die Hinweise zur Qualität der Steuerung, fragen Sie nach Schmerzen, Schlaf und Medikamenten, und kalibrieren Sie neu. Sind die nächsten zwei Sitzungen ebenso schlecht, sprechen Sie mit der Ärztin oder dem Arzt.
verdict-goal-missed = Seit Sitzung { $session } wird das Ziel über die eigene Schwankung dieser Person hinaus häufiger verfehlt. Das hilft: Prüfen Sie den Sitz des Shirts und die Hinweise zur Qualität der Steuerung, fragen Sie nach Schmerzen, Schlaf und Medikamenten, und kalibrieren Sie neu. Sind die nächsten zwei Sitzungen ebenso schlecht, sprechen Sie mit der Ärztin oder dem Arzt.

## Warnings of control quality, each with advice. $joint is a name such as "Left elbow".

# The joints of a warning, as in "Left elbow and Right elbow".
warning-joints = { $joints }
warning-few-trials =
    Wenige Durchgänge: Ob Bewegungen kleiner werden, lässt sich ab { $least_trials } Durchgängen einer Aufgabe in einer Sitzung oder ab { $least_sessions } Sitzungen sagen. Bisher: { $trials ->
        [one] { $trials } Durchgang in der letzten Sitzung
       *[other] { $trials } Durchgänge in der letzten Sitzung
    }, { $sessions ->
        [one] insgesamt { $sessions } Sitzung.
       *[other] insgesamt { $sessions } Sitzungen.
    }
warning-shirt = Das Shirt sitzt nicht wie beim Kalibrieren: { $count } Sensoren ({ $joints }) lagen in Durchgang { $trial } außerhalb ihres kalibrierten Bereichs. Was diese Gelenke machten, hatte keine Wirkung.
warning-shirt-advice = Richten Sie das Shirt. Wenn es neu angezogen wurde, passen Sie die Kalibrierung unter „{ rail-calibrate }“ an seinen Sitz an.
warning-sensor-silent = { $joint }: Sensor { $sensor } lieferte während { $percent } % von Durchgang { $trial } kein Signal. In dieser Zeit hatte das Gelenk keine Wirkung.
warning-sensor-range = { $joint }: Sensor { $sensor } lag während { $percent } % von Durchgang { $trial } außerhalb seines kalibrierten Bereichs. In dieser Zeit hatte das Gelenk keine Wirkung.
warning-sensor-advice = Sehen Sie sich den Sensor auf der Seite „{ rail-shirt }“ an, richten Sie das Shirt, und stecken Sie den Stecker ganz ein. Bleibt es so, wählen Sie dort „{ sensor-unused }“, und kalibrieren Sie neu.
warning-turned = { $joint }: Die Bewegung hat sich gegenüber den ersten Durchgängen mit dieser Kalibrierung um { $degrees }° gedreht.
warning-turned-advice = Wurde das Shirt neu angezogen, oder ist es verrutscht? Richten Sie es, oder kalibrieren Sie neu.
warning-off-map = { $joint }: Die Bewegung liegt { $degrees }° neben der Kalibrierung, und { $percent } % davon erreichen die Steuerung nie.
warning-off-map-advice = Wiederholen Sie die freie Bewegung und die Vorgaben für dieses Gelenk so, wie die Person es beim Fahren bewegt.
warning-unclear = { $joint }: Die Hauptbewegung ist nur zu { $percent } % klar, weniger als in den ersten Durchgängen.
warning-unclear-advice = Bitten Sie die Person, dieses Gelenk nur auf eine Art zu bewegen. Hilft das nicht, kalibrieren Sie neu.
# Behind one of the three advices above.
warning-other-map = Dieses Gelenk steuert mit einer anderen als der Standardkalibrierung. Prüfen Sie, ob sie noch passt.
warning-trembles = { $joint }: In Ruhe zittert das Gelenk mit { $percent } % / s der vollen Bewegung, und es zählt ab { $counts_from } % / s. Es kann also von selbst auslösen. Lassen Sie es ab { $better_from } % / s zählen.
warning-trembles-advice = Achten Sie auf Tremor, Müdigkeit oder einen losen Stecker. Erhöhen Sie dann unter „{ rail-controls }“ den Wert „{ tune-from }“, oder verringern Sie „{ speed-cutoff }“: Ein kleinerer Wert dämpft stärker.
warning-noise = { $joint }: Das Rauschen in Ruhe ist { $ratio }-mal so stark wie in den ersten Durchgängen.
# Rest is a step of the calibration.
warning-noise-advice = Achten Sie auf Tremor, Müdigkeit oder, auf der Seite „{ rail-shirt }“, einen losen Stecker. Bleibt es so, wiederholen Sie den Schritt „{ calibration-rest }“ der Kalibrierung, damit die Bewegung erst über dem Rauschen zählt.
warning-smaller = { $joint }: Die Bewegung ist über { $sessions } Sitzungen um { $percent } % kleiner geworden.
warning-smaller-advice = Fragen Sie nach Kraft und Schmerzen. Bleibt es so, kalibrieren Sie neu, damit „{ tune-full }“ dem entspricht, was die Person jetzt erreicht. Halten Sie den Bewegungsumfang in der Dokumentation fest.
warning-tired = { $joint }: Die Bewegung ist innerhalb dieser Sitzung um { $percent } % kleiner geworden.
warning-tired-advice = Vielleicht ist die Person müde: Lassen Sie sie ausruhen, oder beenden Sie die Sitzung. Kalibrieren Sie nicht mit einer müden Bewegung.

## Events of a trial on its time line.

timeline-checking = Das Warten auf Ruhe begann.
timeline-armed = Der Rollstuhl durfte fahren.
timeline-disarmed = Der Rollstuhl durfte nicht mehr fahren.
timeline-contact = Der Rollstuhl berührte etwas.
timeline-goal = Das Ziel wurde erreicht.

## A recording that cannot be shown. $damage is one or more whole sentences.

trial-recording-no-place = In der Aufzeichnung dieses Durchgangs steht nicht, wo gefahren wurde. Wählen Sie einen anderen Durchgang.
trial-recording-empty = Die Aufzeichnung dieses Durchgangs ist leer. Wählen Sie einen anderen Durchgang.
trial-recording-damaged = Die Aufzeichnung dieses Durchgangs ist leer. { $damage }

## What interrupted a trial, how often, and for how long.

interruption-halted =
    { $times ->
        [one] einmal angehalten, { $seconds } s
       *[other] { $times }-mal angehalten, { $seconds } s
    }
interruption-paused =
    { $times ->
        [one] einmal Pause, { $seconds } s
       *[other] { $times }-mal Pause, { $seconds } s
    }
interruption-stopped =
    { $times ->
        [one] einmal von einer Person gestoppt, { $seconds } s
       *[other] { $times }-mal von einer Person gestoppt, { $seconds } s
    }
# Of the three above.
interruptions-several = { $before }; { $after }
interruptions-asked = von der Technik unterbrochen ({ $interruptions }), und noch niemand hat bestätigt, dass der Durchgang zählt
