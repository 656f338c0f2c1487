### Texte der Seite „Shirt“: Quelle, Körper, Sensoren.

shirt-title = Das Shirt
shirt-words-count = { $good } von { $all } Sensoren sind gut.
shirt-lost =
    { $count ->
        [one] { $count } Datenpaket ging verloren.
       *[other] { $count } Datenpakete gingen verloren.
    }
shirt-none = Es gibt noch kein Shirt. Wählen Sie, woher die Bewegungen kommen.
# Stands beside the sensors; the lamps are those of the joint that moves.
shirt-wiggle = Bewegen Sie ein Gelenk: Seine Lampen leuchten auf.
shirt-moves = Jetzt in Bewegung: { $joint }.
source-none = Noch kein Shirt. Wählen Sie eines.
source-worn = Eigene Bewegungen einer Person
source-practice = Nur zum Üben (simuliert)
shirt-calibrate = Kalibrieren
shirt-drive = Weiter zum Fahren
shirt-front = Vorne
shirt-back = Hinten
shirt-sensors = Sensoren
shirt-sensors-hint = Tippen Sie auf eine Lampe, um ihr Signal zu sehen.
shirt-sensors-label = Sensoren am Körper. Pfeiltasten gehen von einem zum nächsten.
shirt-right = rechts
shirt-left = links
shirt-legend = Was die Lampen bedeuten
sensor-joint = Gelenk: { $joint }
sensor-unused = Diesen Sensor nicht verwenden
sensor-unused-hint = Die nächste Kalibrierung lässt ihn aus.
sensor-noise = Rauschen { $noise }
sensor-now = jetzt { $value }
sensor-trace = Signal von { $name }, die letzten 10 Sekunden
quality-good = Gut
quality-near = Fast am Anschlag
quality-railed = Am Anschlag
quality-flat = Konstant
quality-noisy = Verrauscht
quality-nan = Unmögliche Werte
quality-estimated = Geschätzt
quality-unused = Ausgelassen
quality-silent = Stumm
quality-good-words = Er folgt dem Körper.
quality-near-words = Er kommt dem Ende seines Messbereichs nahe. Prüfen Sie, ob das Shirt dort zu eng sitzt.
quality-railed-words = Er bleibt am Ende seines Messbereichs. Lockern Sie das Shirt dort, oder lassen Sie diesen Sensor aus.
quality-flat-words = Er ändert sich gar nicht. Prüfen Sie den Stecker, oder lassen Sie ihn aus.
quality-noisy-words = Er schwankt stärker als seine Nachbarn. Prüfen Sie den Stecker.
quality-nan-words = Er liefert unmögliche Werte. Prüfen Sie das Kabel, oder lassen Sie ihn aus.
quality-estimated-words = Er ist defekt. Sein Wert wird aus seinen Nachbarn geschätzt, damit die Bewegungen weiter funktionieren. Prüfen Sie das Kabel.
quality-unused-words = Sie haben ihn ausgelassen. Die nächste Kalibrierung kommt ohne ihn aus.
quality-silent-words = Von ihm kommt nichts. Prüfen Sie, ob das Shirt eingeschaltet und verbunden ist.
traces-title = Live-Signale nach Gelenk
traces-label =
    { $count ->
        [one] { $joint }, { $count } Sensor
       *[other] { $joint }, { $count } Sensoren
    }
head-title = Kopftracker
head-none = Keiner
head-none-hint = Der Blick geht geradeaus.
head-none-now = Keiner: Der Blick geht geradeaus.
head-opentrack = opentrack
head-opentrack-hint = Seine Ausgabe „UDP over network“, an diesen Rechner gesendet.
head-opentrack-now = opentrack auf Port { $port }.
head-freepie = FreePIE
head-freepie-hint = Oder ein Telefon, das genauso sendet, über UDP.
head-freepie-now = FreePIE auf Port { $port }.
head-flock-of-birds = Flock of Birds
head-flock-of-birds-hint = Magnettracker von Ascension an einer seriellen Schnittstelle.
head-flock-of-birds-now = Flock of Birds an { $device }.
head-tablet = Sensor eines Tablets
head-tablet-hint = Vor den Augen gehalten oder befestigt. Die Seite auf dem Tablet muss offen sein.
head-tablet-now = Sensor eines Tablets.
head-tablet-start = Dieses Tablet verwenden
head-tablet-waiting = Warten auf den Sensor …
head-tablet-tells = Dieses Tablet meldet jetzt seine Richtung.
head-tablet-none = Dieses Gerät hat keinen solchen Sensor. Öffnen Sie diese Seite auf einem Tablet oder Telefon.
head-tablet-denied = Der Browser erlaubt den Sensor nicht. Erlauben Sie in seinen Einstellungen dieser Seite die Bewegungssensoren.
head-tablet-insecure = Browser geben den Sensor nur für Seiten über https frei. Öffnen Sie diese Seite über https oder auf diesem Rechner selbst.
head-recorded = Aufgezeichneter Kopf
head-recorded-hint = Eine Datei mit t, yaw_deg, pitch_deg und roll_deg.
head-recorded-now = Aufgezeichneter Kopf { $file }.
head-simulator = Simulierter Kopf
head-simulator-hint = Er sieht sich von selbst um.
head-simulator-now = Simulierter Kopf.
head-device = Serielle Schnittstelle
head-baud = Baud
head-address = Adresse
head-address-hint = Nur bei einer Gruppe von Geräten. Bei einem einzelnen leer lassen.
head-ahead = Als geradeaus festlegen
head-ahead-done = Die jetzige Richtung des Kopfes gilt nun als geradeaus.
source-title = Woher kommen die Bewegungen?
# $what begins with a small letter where the language permits it: “a USB cable”.
source-needs = Braucht { $what }.
source-costs = Kostet { $what }.
source-takes = Dauert { $what }.
# Above the reason that is found, and what to do about it.
source-nothing = Es kommt nichts an?
source-heed = Etwas stimmt nicht
source-change = Ändern
source-use = Verwenden
source-unit = { $value } { $unit }
source-file = Datei
source-no-file = Eine Datei dieser Art gibt es hier noch nicht. Fügen Sie unten eine hinzu.
source-host = Empfangen auf
source-port = Port
source-layout-wrong = { $file }: Dies ist kein JSON-Dokument. Wählen Sie ein Shirt-Layout.
source-layout-saved = Gespeichertes Layout
source-layout-kept = Wie jetzt
source-key-none = Keiner
# No sensor.
source-sensor-none = Keiner
sender-now = Die Datenpakete kommen von { $shirt }.
sender-other = Auch von { $other } kommen Datenpakete. Sie werden nicht verwendet, weil der Sender { $shirt } das Shirt ist. Nehmen Sie den neuen Sender nur, wenn das Shirt des Patienten gewechselt oder neu gestartet wurde.
sender-use = Neuen Sender nehmen
sender-used = Das Shirt ist jetzt der Sender { $sender }.
source-add = Datei hinzufügen
source-add-hint = CSV oder Parquet, höchstens 64 MB.
source-import = Aufzeichnung importieren
source-import-hint = Von einem anderen Programm: Die Seite sagt, was die Datei enthält, bevor sie verwendet wird.
source-added = { $file } wurde hinzugefügt.
source-adding = { $file } wird hinzugefügt …
source-file-option = { $name } ({ $size })
body-title = Simulierter Körper
body-person-practised = Simulierte Person, geübt
body-person-practised-hint = Fährt allein und gut.
body-person-novice = Simulierte Person, ungeübt
body-person-novice-hint = Fährt allein und macht Anfängerfehler.
body-visitor = Sie
body-visitor-hint = Tasten, die Tastfelder auf dem Bildschirm oder ein Gamepad bewegen Ellbogen und Schultern im Shirt.
body-recorded = Aufgezeichneter Körper
body-recorded-hint = Gelenkdrehungen einer echten Person, aus einer Datei.
body-recorded-now = Aufgezeichneter Körper: { $file }
body-yours = Sie bewegen diesen Körper
pads-right-elbow = Rechter Ellbogen
pads-left-elbow = Linker Ellbogen
pads-right-shoulder = Rechte Schulter
pads-left-shoulder = Linke Schulter
pads-bend = beugen
pads-forward = nach vorn
pads-keys-right-elbow = W  ↑
pads-keys-left-elbow = S  ↓
pads-keys-right-shoulder = A  ←
pads-keys-left-shoulder = D  →
pads-note = Gedrückt halten bewegt, Loslassen führt zurück. Beide Ellbogen gleichzeitig sind die Stopp-Geste.
pads-gamepad = Gamepad: Schultertasten beugen die Ellbogen, Sticks schieben die Schultern nach vorn.
pads-group = Tastfelder, die den Körper im Shirt bewegen
