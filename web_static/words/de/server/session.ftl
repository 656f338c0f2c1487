### A visit of a patient: the open session, its equipment, its calibration, its trials and drives, and the adaptation of
### the calibration.

## The open session

visit-nobody = Es ist keine Sitzung offen. Wählen Sie zuerst auf der Seite „Patienten“ einen Patienten.
visit-not-calibrated = Noch ist nichts kalibriert. Kalibrieren Sie zuerst, und tippen Sie auf „Diese Kalibrierung verwenden“.
visit-shirt-silent = Das Shirt sendet keine Signale. Die Seite „Shirt“ zeigt, was von ihm ankommt.
visit-calibrated-unworn = Die Kalibrierung des Patienten stammt von einem Shirt, das niemand trug. Kalibrieren Sie zuerst mit dem getragenen Shirt.
visit-calibrated-in-another = Der Patient wurde mit einem anderen Shirt kalibriert. Kalibrieren Sie zuerst mit diesem.
visit-calibrated-at-another-rate = Das Shirt sendet mit einer anderen Abtastrate als bei der Kalibrierung. Kalibrieren Sie zuerst neu.
visit-code-wrong = Dieser Code ist falsch, wurde schon verwendet oder ist älter als { $minutes } Minuten. Bitten Sie um einen neuen, er steht auf der Seite der Fachkraft.

# $now and $page are whole sentences: which session is open now, and what the page shows.
visit-another-session = { $now } { $page }
visit-session-ended = Die Sitzung wurde auf einem anderen Bildschirm beendet. Jetzt ist keine Sitzung offen.
# $code is the code of a patient, $time a time of day.
visit-session-opened = Patient { $code } wurde um { $time } auf einem anderen Bildschirm geöffnet.
visit-session-opened-by = Patient { $code } wurde um { $time } von { $person } auf einem anderen Bildschirm geöffnet.
visit-page-of-no-session = Was diese Seite zeigt, gehört zu keiner Sitzung und lässt sich nicht mehr senden. Laden Sie die Seite neu.
# $code is the code of a patient.
visit-page-of-session = Was diese Seite zeigt, gehört zu { $code } und lässt sich nicht mehr senden. Laden Sie die Seite neu.

## What must end first

visit-busy =
    { $running ->
        [trial] Ein Durchgang läuft. Beenden Sie ihn zuerst, und versuchen Sie es dann noch einmal.
        [drive] Der echte Rollstuhl ist freigegeben. Beenden Sie zuerst die Fahrt, und versuchen Sie es dann noch einmal.
        [step] Ein Schritt der Kalibrierung läuft. Warten Sie, bis er fertig ist, oder brechen Sie ihn ab, und versuchen Sie es dann noch einmal.
       *[test] Der Zwei-Minuten-Test läuft. Beenden Sie ihn zuerst, und versuchen Sie es dann noch einmal.
    }
visit-already-recorded =
    { $start ->
        [trial] Es wird schon etwas aufgezeichnet. Beenden Sie das zuerst, und starten Sie dann einen Durchgang.
        [drive] Es wird schon etwas aufgezeichnet. Beenden Sie das zuerst, und geben Sie dann den Rollstuhl frei.
       *[test] Es wird schon etwas aufgezeichnet. Beenden Sie das zuerst, und starten Sie dann den Zwei-Minuten-Test.
    }
visit-recording = Es wird schon etwas aufgezeichnet. Warten Sie, bis das fertig ist, oder beenden Sie es zuerst.
visit-no-trial = Es läuft kein Durchgang. Starten Sie zuerst einen.
visit-trial-still-measured = Der Durchgang wird noch ausgewertet. Sehen Sie ihn gleich noch einmal an.
visit-no-drive = Der Rollstuhl wird gerade nicht gefahren. Geben Sie ihn zuerst frei.
visit-drive-still-closing = Die Aufzeichnung wird noch abgeschlossen. Sehen Sie die Fahrt gleich noch einmal an.
visit-no-test = Es läuft kein Zwei-Minuten-Test. Starten Sie zuerst einen.
visit-test-still-measured = Der Zwei-Minuten-Test wird noch ausgewertet. Sehen Sie ihn gleich noch einmal an.

## Recordings

visit-ticks-lost =
    { $count ->
        [one] Beim Aufzeichnen ging { $count } Takt verloren. Schließen Sie andere Programme, und wiederholen Sie dann diesen Schritt.
       *[other] Beim Aufzeichnen gingen { $count } Takte verloren. Schließen Sie andere Programme, und wiederholen Sie dann diesen Schritt.
    }
visit-recording-without-plan = Die Aufzeichnung enthält den Grundriss ihres Durchgangs nicht. Deshalb lässt sie sich nicht noch einmal auswerten.
visit-recording-without-parameters = In der Aufzeichnung steht nicht, mit welchen Parametern gefahren wurde. Deshalb lässt sie sich nicht bewerten.

## Equipment

visit-no-shirt = Noch kein Shirt. Wählen Sie eines auf der Seite „Shirt“.
# $name is the name of a sensor.
visit-no-sensor = Dieses Shirt hat keinen Sensor „{ $name }“. Wählen Sie eine seiner Lampen.
visit-layout-unreadable = Das Layout des Shirts ist nicht lesbar. Wählen Sie ein anderes Shirt.
visit-no-file =
    { $kind ->
        [key] Eine Datei „{ $name }“ gibt es hier nicht. Koppeln Sie zuerst das Shirt (bodydrive shirt pair).
       *[file] Eine Datei „{ $name }“ gibt es hier nicht. Fügen Sie sie zuerst mit „Datei hinzufügen“ hinzu.
    }
visit-keys-used-up = Alle Nummern für Schlüssel von Shirts sind vergeben. Beginnen Sie mit einem neuen Ordner für die Klinik.
# Of the phones that are paired as sensors.
visit-no-phone = Ein Telefon { $number } gibt es nicht. Sehen Sie die Liste noch einmal an.
visit-phones-most = Alle { $most } Nummern für Telefone sind vergeben. Entkoppeln Sie zuerst eines.
visit-chair-virtual = Der virtuelle Rollstuhl: Nur das Bild bewegt sich.
visit-chair-not-open = Der Rollstuhl ist nicht geöffnet. Wählen Sie ihn neu.
# $name is the name of a chair.
visit-chair-not-open-named = „{ $name }“ ist nicht geöffnet. Wählen Sie diesen Rollstuhl neu.
visit-chair-silent = Der Rollstuhl antwortet nicht. Prüfen Sie den Strom des Rollstuhls und das Netz.
visit-chair-unknown-fault = Der Rollstuhl meldet eine Störung, die dieses Programm nicht kennt.

## Calibration

visit-shirt-changed = Das Shirt ist ein anderes als zu Beginn dieser Kalibrierung. Beginnen Sie die Kalibrierung neu.
# $step is the name of a step in the program.
visit-no-step = Diese Kalibrierung hat keinen Schritt „{ $step }“. Wählen Sie einen aus der Liste.
visit-step-recorded = Ein Schritt wird aufgezeichnet. Warten Sie, bis er fertig ist, oder brechen Sie ihn zuerst ab.
visit-step-not-recorded = Dieser Schritt wird nicht oder nicht mehr aufgezeichnet. Starten Sie ihn, oder wählen Sie einen anderen.
visit-no-short-calibration = Nur eine Kamera, die Kopf, Rumpf und Schultern sieht, hat eine kurze Kalibrierung. Beginnen Sie die ganze.
visit-step-needed = „Ausruhen“ und „Frei bewegen“ lassen sich nicht überspringen: Aus ihnen entsteht die Kalibrierung.
visit-step-interrupted = Während dieses Schritts wurde das Programm beendet. Wiederholen Sie ihn.
visit-step-process-ended = Während dieses Schritts wurde der Steuerungsprozess beendet. Wiederholen Sie den Schritt.
visit-step-nothing-recorded = Drei Sekunden lang wurde nichts aufgezeichnet. Sehen Sie auf der Seite „Shirt“ nach, und wiederholen Sie dann diesen Schritt.
visit-step-lossy = Nur { $share } % der Signale des Shirts kamen an. Prüfen Sie seinen Akku und seinen Sender, und wiederholen Sie dann diesen Schritt.
visit-step-silent = Das Shirt hat { $seconds } Sekunden lang nichts gesendet. Prüfen Sie seinen Sender, und wiederholen Sie dann diesen Schritt.
# $joint is the name of a joint, $reason one or more whole sentences on its movement.
visit-no-joint-moves = Kein Gelenk bewegt sich klar genug. { $joint }: { $reason }
visit-drive-now-too-early = Machen Sie zuerst „Ausruhen“ und „Frei bewegen“. Um gleich zu fahren, müssen vier andere Personen in diesem Shirt bekannt sein.
visit-fit-too-early = Machen Sie zuerst „Ausruhen“ und „Frei bewegen“. Zum Anpassen ist eine frühere Kalibrierung dieses Patienten in diesem Shirt nötig.
visit-fitting = Die Bewegungen werden ausgewertet.
visit-fit-interrupted = Die Berechnung der Kalibrierung wurde unterbrochen. Wiederholen Sie einen beliebigen Schritt, dann beginnt sie von vorn.
visit-controls-changed = Die Steuerung wurde inzwischen geändert. Versuchen Sie es noch einmal.
visit-calibration-without-shirt = Es gibt kein Shirt. Wählen Sie eines auf der Seite „Shirt“, und beginnen Sie die Kalibrierung dann neu.
visit-no-result = Es gibt noch kein Ergebnis. Machen Sie zuerst alle Schritte.
# $joint and $joints are names of joints in the program.
visit-no-map = Für das Gelenk „{ $joint }“ gibt es keine Kalibrierung. Wählen Sie eines von diesen: { $joints }.
visit-guided-not-better = Die aus den Vorgaben gelernte Kalibrierung ist für dieses Gelenk nicht besser. Behalten Sie die Standardkalibrierung.
visit-prior-not-better = Von anderen Personen gibt es für dieses Gelenk keine bessere Kalibrierung. Behalten Sie die jetzige.
visit-ring-not-turned = An diesem Gelenk sitzt das Shirt wie bei anderen Personen. Es gibt nichts zu wählen.

## Adaptation of the calibration

visit-adapt-off = Die Kalibrierung dieses Patienten bleibt, wie sie ist. Tippen Sie auf „Jetzt prüfen“, oder wählen Sie „Vorschlagen“.
visit-adapt-suggest = Wenn ein Durchgang mit dem virtuellen Rollstuhl zeigt, dass die Kalibrierung schlechter passt, zeigt diese Seite, was sich ändern würde.
visit-adapt-auto = Wenn ein Durchgang mit dem virtuellen Rollstuhl zeigt, dass die Kalibrierung schlechter passt, zeigt diese Seite, was sich ändert.
visit-adapt-not-now = Sie haben die Kalibrierung gelassen, wie sie war. Nach dem nächsten Durchgang wird sie wieder geprüft.
visit-adapt-no-trials = Mit dieser Kalibrierung wurde noch nicht gefahren. Fahren Sie einen Durchgang mit dem virtuellen Rollstuhl, und prüfen Sie dann noch einmal.
visit-adapt-left-off = Gerade fährt jemand. Nach dem Durchgang wird wieder geprüft.
visit-adapt-switched = Die Kalibrierung wird nicht mehr automatisch angepasst. Sehen Sie sich den Vorschlag an, und entscheiden Sie dann.
visit-adapt-stale = Seit diesem Vorschlag wurden die Steuerung oder die Durchgänge geändert. Prüfen Sie noch einmal, und entscheiden Sie dann.
visit-adapt-gone = Diesen Vorschlag gibt es nicht mehr. Prüfen Sie noch einmal, und entscheiden Sie dann.
visit-adapt-real-chair = Ein echter Rollstuhl ist gewählt, und mit ihm wird nichts angepasst. Wählen Sie zuerst den virtuellen.
visit-adapt-not-still = Der Rollstuhl ist freigegeben oder bewegt sich. Beenden Sie den Durchgang oder die Fahrt, und übernehmen Sie die Änderung dann.
visit-adapt-large = Der Patient würde die Änderung spüren (5 % oder mehr). Deshalb wartet sie, bis jemand sie ansieht und übernimmt.
visit-adapt-restarting = Der Steuerungsprozess wird neu gestartet. Warten Sie einen Moment, und versuchen Sie es dann noch einmal.
visit-adapt-stopped = Ein Stopp besteht noch. Heben Sie ihn zuerst auf, und übernehmen Sie die Änderung dann.
