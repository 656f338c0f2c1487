### Calibration: its steps, what is wrong with a sensor or a recording, why a joint has no map, and how maps are proposed
### and changed.

## Steps.

calibration-rest = Ausruhen
calibration-rest-instruction = Sitzen Sie bequem, und lassen Sie die Arme hängen. Bewegen Sie sich drei Sekunden lang nicht.
calibration-free = Frei bewegen
calibration-free-instruction = Bewegen Sie Arme und Schultern zehn Sekunden lang, wie Sie möchten, so weit es angenehm ist.
calibration-free-short-instruction = Drehen Sie zehn Sekunden lang den Kopf zu einer Seite, neigen Sie den Oberkörper zu einer Seite und schieben Sie jede Schulter vor, immer wieder, in beliebiger Reihenfolge, so weit es angenehm ist.
# Below an instruction to move one joint.
calibration-prompt-instruction = Folgen Sie { $count }-mal dem Takt: Bewegen Sie sich, wenn die Vorgabe es zeigt. Bewegen Sie sich dann langsam zurück, und ruhen Sie sich aus.
calibration-move-elbow =
    { $side ->
        [left] Beugen Sie den linken Ellbogen
       *[right] Beugen Sie den rechten Ellbogen
    }
calibration-move-shoulder =
    { $side ->
        [left] Schieben Sie die linke Schulter vor
       *[right] Schieben Sie die rechte Schulter vor
    }
calibration-move-wrist =
    { $side ->
        [left] Beugen Sie das linke Handgelenk
       *[right] Beugen Sie das rechte Handgelenk
    }
calibration-move-head = Drehen Sie den Kopf zu einer Seite
calibration-move-trunk = Neigen Sie den Oberkörper zu einer Seite
calibration-move = Bewegen: { $joint }

## What is wrong with a sensor. The name of the sensor stands before it, as in "Channel e3 is left out: gives no numbers."

calibration-channel-no-numbers = liefert keine Zahlen
calibration-channel-nan =
    { $count ->
        [one] { $count } von { $samples } Abtastwerten ist keine Zahl
       *[other] { $count } von { $samples } Abtastwerten sind keine Zahlen
    }
calibration-channel-railed = erreicht { $percent } % seines Bereichs
calibration-channel-near = kommt dem Ende seines Bereichs nahe ({ $percent } %)
calibration-channel-clipped =
    { $end ->
        [upper] ist während { $percent } % der Zeit am oberen Ende seines Bereichs
       *[lower] ist während { $percent } % der Zeit am unteren Ende seines Bereichs
    }
calibration-channel-dead = ändert sich nie, ist also defekt oder nicht angeschlossen
calibration-channel-still = steht während { $percent } % der Zeit still, in der sich seine Nachbarn bewegen
calibration-channel-noisy = ist größtenteils Rauschen ({ $percent } % seiner Bewegung)
calibration-channel-gap = fehlt { $seconds } s am Stück, und höchstens { $most } s werden überbrückt
calibration-channel-missing = { $percent } % der Abtastwerte fehlen, und höchstens { $most } % werden überbrückt
calibration-channel-unused = wird auf Wunsch nicht verwendet

## Recordings that cannot be used. The name of a file may stand before the sentence.

# $what is the name of a joint where it is neither free movement nor rest.
calibration-recording-channels =
    { $what ->
        [free] die Aufzeichnung der freien Bewegung hat nicht die { $count } Kanäle von „{ $layout }“
        [rest] die Aufzeichnung der Ruhe hat nicht die { $count } Kanäle von „{ $layout }“
       *[other] die Aufzeichnung von „{ $what }“ hat nicht die { $count } Kanäle von „{ $layout }“
    }
calibration-recording-short =
    { $what ->
        [free] die freie Bewegung dauert { $lasts } s, das ist für eine Kalibrierung zu kurz; zeichnen Sie mindestens { $least } s auf (üblich sind 10 s freie Bewegung und 3 s Ruhe)
       *[rest] die Ruhe dauert { $lasts } s, das ist für eine Kalibrierung zu kurz; zeichnen Sie mindestens { $least } s auf (üblich sind 10 s freie Bewegung und 3 s Ruhe)
    }
calibration-unknown-name =
    { $what ->
        [joint] in „{ $layout }“ gibt es kein Gelenk „{ $name }“; verwenden Sie eines von diesen: { $names }
       *[channel] in „{ $layout }“ gibt es keinen Kanal „{ $name }“; verwenden Sie einen von diesen: { $names }
    }
calibration-no-joint = kein Gelenk von „{ $layout }“ hat einen brauchbaren Sensor; prüfen Sie, ob das Shirt verbunden ist und sich jemand darin bewegt hat
calibration-no-sensor = Keiner der Sensoren dieses Gelenks ist brauchbar. Prüfen Sie die Sensoren auf der Seite „{ rail-shirt }“, und wiederholen Sie dann die Kalibrierung.

## Where a map comes from.

calibration-source-both = von anderen Personen und eigener Bewegung
calibration-source-people = von anderen Personen
calibration-source-prompts = aus eigenen Vorgaben
calibration-source-standard = Standard

## Why there is no map learnt from the cues.

calibration-guided-unprompted = Aus Vorgaben wird nichts gelernt, weil die Bewegung dieses Gelenks nie vorgegeben wurde. Geben Sie sie mindestens { $least }-mal vor.
calibration-guided-few =
    { $count ->
        [one] Aus { $count } vorgegebenen Wiederholung wird nichts gelernt. Geben Sie mindestens { $least } vor: Eine davon wird zum Prüfen zurückgehalten.
       *[other] Aus { $count } vorgegebenen Wiederholungen wird nichts gelernt. Geben Sie mindestens { $least } vor: Eine davon wird zum Prüfen zurückgehalten.
    }
calibration-guided-no-rest = Aus Vorgaben wird nichts gelernt, weil dieses Gelenk zusammen keine { $seconds } s lang in Ruhe ist. Zeichnen Sie eine Ruhe auf, oder lassen Sie Pausen zwischen den vorgegebenen Bewegungen.
calibration-guided-small = Aus Vorgaben wird nichts gelernt, weil die Signale zu klein sind. Geben Sie sie in einer kleineren Einheit an.
calibration-guided-unlike = Aus Vorgaben wird nichts gelernt, weil die Wiederholungen nichts gemeinsam haben. Wiederholen Sie die Vorgaben.

## Maps from other people (a prior).

calibration-prior-few =
    { $count ->
        [one] Die Bewegungen anderer Personen sagen noch nichts: Für dieses Gelenk ist { $count } Person bekannt, { $needed } sind nötig.
       *[other] Die Bewegungen anderer Personen sagen noch nichts: Für dieses Gelenk sind { $count } Personen bekannt, { $needed } sind nötig.
    }
calibration-prior-unlike = Die Bewegungen anderer Personen haben nichts miteinander gemeinsam. Fügen Sie weitere Personen hinzu.
calibration-prior-small = Die Signale sind zu klein. Geben Sie sie in einer kleineren Einheit an.
calibration-prior-still = Von den Sensoren, die von anderen Personen bekannt sind, bewegt sich bei dieser Person keiner. Bewegen Sie sich zehn Sekunden lang frei.
calibration-not-confirmed = Von anderen Personen gelernt und von der eigenen Bewegung noch nicht bestätigt: { $joints }. Wiederholen Sie jede dieser Bewegungen einmal auf der Seite „{ rail-calibrate }“, und üben Sie dann noch einmal.
# Why a prior may not leave the clinic: this one and the next.
calibration-prior-few-new =
    { $count ->
        [one] insgesamt ist es { $count } Person, und weniger als { $least } sind noch in keiner Fassung zur Weitergabe; verwenden Sie die frühere Fassung, und erstellen Sie eine neue, wenn mindestens { $least } Personen hinzugekommen sind, damit sich niemand durch Abziehen der einen von der anderen finden lässt
       *[other] insgesamt sind es { $count } Personen, und weniger als { $least } davon sind noch in keiner Fassung zur Weitergabe; verwenden Sie die frühere Fassung, und erstellen Sie eine neue, wenn mindestens { $least } Personen hinzugekommen sind, damit sich niemand durch Abziehen der einen von der anderen finden lässt
    }
calibration-prior-few-released =
    { $count ->
        [one] insgesamt ist es { $count } Person, und nur Summen über mindestens { $least } Personen dürfen eine Klinik verlassen; fügen Sie weitere Personen hinzu
       *[other] insgesamt sind es { $count } Personen, und nur Summen über mindestens { $least } Personen dürfen eine Klinik verlassen; fügen Sie weitere Personen hinzu
    }

## The earlier calibration, fitted to how the shirt sits today. $joint is as in "left elbow".

calibration-fit-rate = Das Shirt sendet mit einer anderen Abtastrate als beim Kalibrieren. Kalibrieren Sie neu.
calibration-fit-mirrored = Gegenüber dieser Kalibrierung ist das Shirt auf links gedreht oder seitenverkehrt angezogen ({ $joint }). Ziehen Sie es an wie damals, und wiederholen Sie die freie Bewegung. Oder machen Sie mit den folgenden Bewegungen weiter: Sie ergeben eine neue Kalibrierung.
calibration-fit-turned = Gegenüber dieser Kalibrierung ist das Shirt um { $places } von { $sensors } Sensoren verdreht ({ $joint }). Drehen Sie es zurück, und wiederholen Sie die freie Bewegung. Oder machen Sie mit den folgenden Bewegungen weiter: Sie ergeben eine neue Kalibrierung.

## A change of the calibration that is proposed after trials. $applied and $refused are lists of joints.

calibration-proposal =
    { $trials ->
        [one] Was sich nach dem letzten Durchgang ändern würde: { $applied }.
       *[other] Was sich nach den letzten { $trials } Durchgängen ändern würde: { $applied }.
    }
calibration-proposal-some =
    { $trials ->
        [one] Was sich nach dem letzten Durchgang ändern würde: { $applied }. Abgelehnt: { $refused }.
       *[other] Was sich nach den letzten { $trials } Durchgängen ändern würde: { $applied }. Abgelehnt: { $refused }.
    }
calibration-proposal-refused =
    { $trials ->
        [one] Nach dem letzten Durchgang ändert sich nichts. Nötig wäre eine Änderung, die nicht erlaubt ist: { $refused }.
       *[other] Nach den letzten { $trials } Durchgängen ändert sich nichts. Nötig wäre eine Änderung, die nicht erlaubt ist: { $refused }.
    }
calibration-proposal-none =
    { $trials ->
        [one] Nach dem letzten Durchgang passt die Kalibrierung so gut wie vorher und bleibt, wie sie ist.
       *[other] Nach den letzten { $trials } Durchgängen passt die Kalibrierung so gut wie vorher und bleibt, wie sie ist.
    }
calibration-proposal-no-trial = Es wurde noch kein Durchgang gefahren.

## Why the calibration of one joint changes, and how; or why it does not. "It" is the joint.

calibration-loss-noise = Das Rauschen in Ruhe liegt nahe an dem Wert, ab dem das Gelenk zählt. So kann es von selbst auslösen.
calibration-loss-missed = { $percent } % der Zeit, in der sich das Gelenk bewegt, zählen nicht, obwohl sein Rauschen in Ruhe gering ist.
calibration-loss-weaker = Die Bewegungen sind seit den ersten Durchgängen um { $percent } % schwächer geworden.
calibration-loss-stronger = Die Bewegungen sind seit den ersten Durchgängen um { $percent } % stärker geworden.
calibration-loss-direction = { $percent } % der Bewegung gehen in eine andere Richtung als die, die steuert.
calibration-loss-silent = Ein Sensor lag während { $percent } % des letzten Durchgangs außerhalb seines Bereichs. In dieser Zeit zählte nichts.
calibration-change-no-trial = Seit der letzten Änderung der Kalibrierung wurde kein Durchgang gefahren.
calibration-change-none = Die Kalibrierung passt so gut wie vorher.
calibration-change-sensor = Sensor { $sensor } ist defekt oder am Ende seines Bereichs. Prüfen Sie das Shirt, und kalibrieren Sie dann neu.
calibration-change-felt = Der Patient würde eine Änderung von { $percent } % spüren, und ab { $limit } % wird sie abgelehnt. Kalibrieren Sie dieses Gelenk neu.
calibration-change-at-end = Die Kalibrierung kann nicht weiter folgen. Kalibrieren Sie dieses Gelenk neu.
calibration-change-unclear = Die Hauptbewegung ist nur zu { $percent } % klar, weniger als { $least } %.
calibration-change-away = Die Richtung wäre { $degrees } Grad von der Kalibrierung entfernt. Kalibrieren Sie dieses Gelenk neu.
calibration-change-cross-talk = Die Mitbewegung bei anderen Gelenken würde stärker (vorher { $before } %, nachher { $after } %).
calibration-change-range = Der Bereich, in dem die Sensoren als glaubwürdig gelten, folgt dem Shirt.
calibration-change-turned = Gedreht um { $degrees } Grad.
calibration-change-turned-part = Gedreht um { $degrees } von { $proposed } Grad, die die Bewegungen verlangen.
calibration-change-from = { tune-from } { $after } % / s statt { $before } % / s.
calibration-change-full = { tune-full } { $after } % / s statt { $before } % / s.
# A sentence that says why follows.
calibration-change-unturned = Die Richtung bleibt.

## The suggested movements to drive with.

calibration-suggested = Vorgeschlagen: { $gestures }.
# In the list above: a joint whose movement back is the gesture.
calibration-gesture-back = { $joint } (zurück)
calibration-suggested-one =
    Diese Bewegung hat { $signal ->
        [strong] ein starkes Signal
        [fair] ein mittleres Signal
       *[weak] ein schwaches Signal
    }.
calibration-suggested-unprompted =
    Die schwächste Bewegung hat { $signal ->
        [strong] ein starkes Signal
        [fair] ein mittleres Signal
       *[weak] ein schwaches Signal
    }; nichts wurde vorgegeben, deshalb ist die Mitbewegung nicht bekannt.
calibration-suggested-several =
    Die schwächste Bewegung hat { $signal ->
        [strong] ein starkes Signal
        [fair] ein mittleres Signal
       *[weak] ein schwaches Signal
    }; bei einer Bewegung zählt eine andere im Mittel mit { $percent } % ihrer Stärke mit.
calibration-suggested-without = Ausgelassen: { $joint }, wegen der Mitbewegung ({ $partner }). Bewegt sich eines der beiden Gelenke, zählt das andere mit bis zu { $percent } % seiner Stärke mit.
calibration-suggested-hits = Von 100 Bewegungen werden voraussichtlich mindestens { $hits } erkannt.
calibration-suggested-false = In Ruhe lösen alle zusammen voraussichtlich { $rate }-mal pro Minute aus. { $seconds } s Ruhe belegen nur, dass jede weniger als { $bound }-mal auslöst (95 %).
calibration-suggested-hardly-false = In Ruhe lösen alle zusammen voraussichtlich weniger als { $rate }-mal pro Minute aus. { $seconds } s Ruhe belegen nur, dass jede weniger als { $bound }-mal auslöst (95 %).
calibration-recordings-gone = Die Aufzeichnungen dieser Kalibrierung sind nicht hier. Deshalb stehen hier nur die Bewegungen hin, nicht die zurück, geordnet nach den Zahlen der Kalibrierung selbst. Kalibrieren Sie neu, um alle zu sehen.
