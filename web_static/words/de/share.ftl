### Texte der Seite, die ein geteilter Link öffnet.

share-heading = Geteilte Dokumentation
share-title = Dokumentation zu { $code }
share-pin = PIN dieses Links
share-pin-words = Die Klinik hat sie Ihnen getrennt mitgeteilt.
share-open = Öffnen
share-until = Dieser Link lässt sich bis { $day } öffnen. Der Inhalt ist vertraulich.
share-no-link = Diese Adresse ist unvollständig. Öffnen Sie den ganzen Link, den die Klinik gesendet hat.
share-failed = Der Rechner der Klinik antwortet nicht. Versuchen Sie es später noch einmal.
share-session = Sitzung { $number }
share-goal = Ziel
share-signed = Abgezeichnet
share-unsigned = Nicht abgezeichnet
# What a trial was driven with.
share-source-simulated = simuliert
share-source-camera = Kamera
share-source-phones = Telefone
share-source-slimevr = Tracker
share-source-bluetooth = Bluetooth-Sensoren
share-source-brainflow = Platine
share-source-lsl = LSL
share-task = { $plan }: { $path }
share-trajectories =
    { $count ->
        [one] Vorgegebene Strecke (gestrichelt) und { $count } Fahrspur
       *[other] Vorgegebene Strecke (gestrichelt) und { $count } Fahrspuren
    }
share-curve = Fläche neben der Strecke (m²), Durchgang für Durchgang
share-values = { $first } im ersten Durchgang, { $newest } im neuesten.
share-verdicts = Neueste Sitzung gegen die vorherige
share-no-area = Kein Durchgang erreichte das Ziel. Deshalb gibt es keine Fläche neben der Strecke: Sie lässt sich nur für die ganze Strecke vergleichen.
share-no-verdict = Zu wenige Durchgänge für eine Bewertung.
share-event-begin = Sitzung begonnen
share-event-calibration =
    { $count ->
        [one] Kalibrierung: { $count } Aufzeichnung
       *[other] Kalibrierung: { $count } Aufzeichnungen
    }
share-event-map = Kalibrierung, Version { $version }
share-event-parameters = Steuerung gespeichert: { $text }
share-event-trial = Durchgang { $number }, { $text }: { $end }
share-event-test = Zwei-Minuten-Test { $number }
share-event-stop = Stopp
share-event-drive = Fahrt mit dem Rollstuhl
share-event-note = Notiz
share-event-comment = Kommentar zu Durchgang { $number } bei { $t } s
share-event-sign-off = Abgezeichnet
share-event-unlock = Entsperrt
share-event-end = Sitzung beendet
