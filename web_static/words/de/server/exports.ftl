### Texts of exports: refusals, and what stands in the exported files for those who read them.

exports-nothing = Es gibt nichts zu exportieren: Es wurde nichts aufgezeichnet.
exports-no-session = Dieser Patient hat keine Sitzung { $session }. Wählen Sie eine, die begonnen wurde.
exports-recording-missing = Diese Aufzeichnung fehlt.
# Name of a data set of the Brain Imaging Data Structure (BIDS); $patient is a code.
exports-bids-name = bodydrive-Aufzeichnungen von { $patient }
# File README of such a data set. tracksys-shirt, tracksys-wheelchair, LATENCY and BodydriveSource are names in its files.
exports-bids-readme =
    Signale eines Shirts mit Dehnungssensoren oder der Sensoren an seiner Stelle und der Rollstuhl, der damit gefahren wurde, von bodydrive.

    tracksys-shirt: die Kanäle des Shirts, eine Zeile für jedes Datenpaket, das ankam.
    tracksys-wheelchair: Lage (Ort und Richtung) und Fahrbefehle, eine Zeile für jeden Takt der Regelschleife.
    Jede Bewegungsdatei beginnt mit der Spalte LATENCY: Sekunden seit dem Beginn der Aufzeichnung.
    Die Begleitdatei jeder Datei gibt an, woher die Signale kommen und ob sie simuliert sind (BodydriveSource).
exports-method-test = Zwei-Minuten-Test: Ziele auf einem Kreuz, mit einem Punkt erreicht, während sich kein Rollstuhl bewegt
# How a measure was taken: the title of the floor plan, and the name of the path on it.
exports-method-trial = { $plan }, Strecke { $path }
exports-note-trial = { $source }. Sitzung { $session }, Durchgang { $number }. Version der Kalibrierung { $version }, Fingerabdruck der Steuerung { $hash }.
exports-note-test = { $source }. Sitzung { $session }, Zwei-Minuten-Test { $number }. Version der Kalibrierung { $version }, Fingerabdruck der Steuerung { $hash }.
