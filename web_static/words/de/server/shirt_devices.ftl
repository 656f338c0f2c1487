### The kinds of shirts on the Shirt page; what shirts say of themselves, and why one cannot be used.

## The form of each kind of shirt: its title, what it is, how it is named when it is in use, its fields.

# Whether a kind of shirt may drive a real chair, where shirts are chosen.
shirtdev-chair-wired = Darf einen echten Rollstuhl fahren, wenn sein Kabel an diesem Rechner steckt: Darauf kann nur das Shirt senden.
shirtdev-chair-with-key = Darf einen echten Rollstuhl nur mit Schlüssel fahren, denn sonst könnte jedes Gerät im Netz senden.
shirtdev-chair-nobody-wears = Fährt nie einen echten Rollstuhl, denn niemand trägt es.
shirtdev-chair-nobody-proves = Fährt nie einen echten Rollstuhl, denn nichts belegt, wessen Bewegungen es sind.
# What a kind -needs and -costs, and how long it -takes, stands in source-needs, source-costs, source-takes of shirt.ftl.
shirtdev-rate = Datenpakete pro Sekunde
shirtdev-file = Datei
shirtdev-key = Schlüssel
# In “ ” stands a command, which is not translated.
shirtdev-key-hint = Über das Netz darf nur ein Shirt mit Schlüssel einen echten Rollstuhl fahren. „bodydrive shirt pair“ auf diesem Rechner erstellt einen.
# The document that names the shirt's sensors.
shirtdev-layout = Layout aus einer Datei
shirtdev-layout-hint = Eine JSON-Datei, die die Sensoren benennt. Ohne Datei bleibt das jetzige Layout.
shirtdev-simulator-title = Simuliertes Shirt
shirtdev-simulator-about = Ein Stoff mit 52 Sensoren, berechnet aus dem Körper darin.
shirtdev-simulator-in-use = Simuliertes Shirt, { $rate } Datenpakete pro Sekunde
shirtdev-simulator-needs = nichts weiter
shirtdev-simulator-costs = nichts
shirtdev-simulator-takes = keinen Augenblick: Es bewegt sich sofort
# A number from 1 to 999; each is a shirt with other sensors.
shirtdev-simulator-seed = Welches simulierte Shirt
shirtdev-simulator-sensors = Seine Sensoren
shirtdev-simulator-all-work = Alle funktionieren
shirtdev-simulator-two-dead = Zwei sind defekt
shirtdev-replay-title = Wiedergabe einer Datei
shirtdev-replay-about = Früher aufgezeichnete Signale, abgespielt, als kämen sie jetzt.
shirtdev-replay-in-use = Wiedergabe von { $file }
shirtdev-replay-needs = eine Aufzeichnung dieses Programms oder eine Datei mit Signalen (CSV oder Parquet)
shirtdev-replay-costs = nichts
shirtdev-replay-takes = eine Minute
shirtdev-replay-loop = Am Ende von vorn beginnen
shirtdev-replay-layout-hint = Eine JSON-Datei, die die Spalten benennt, nach ihren Namen oder in ihrer Reihenfolge. Ohne Datei sagen die Spalten ihr Gelenk, etwa right_elbow_1.
shirtdev-serial-title = Ein Shirt am Kabel
shirtdev-serial-about = Eine Platine, etwa ein Arduino, die ihre Sensoren über USB oder eine andere serielle Schnittstelle sendet.
shirtdev-serial-in-use = Shirt am Kabel an { $device }
shirtdev-serial-needs = ein Shirt mit Dehnungssensoren, eine Platine, etwa ein Arduino, und ein USB-Kabel
shirtdev-serial-costs = etwa 100 bis 150 €
shirtdev-serial-takes = einen Nachmittag für den Bau, dann eine Minute, dann die Kalibrierung
shirtdev-serial-device = Serielle Schnittstelle
shirtdev-serial-device-hint = So, wie das System sie nennt. Ein Name unter /dev/serial/by-id/ bleibt gleich, wenn das Kabel neu eingesteckt wird.
shirtdev-serial-baud = Baudrate
shirtdev-serial-format = Format
shirtdev-serial-format-hint = Datenpakete haben eine Prüfsumme; ein beschädigtes wird ausgelassen. In einer Zeile verändert eine verlorene Ziffer eine Zahl.
shirtdev-serial-format-frames = Datenpakete mit Prüfsumme
shirtdev-serial-format-lines = Einfache Zeilen mit Zahlen
shirtdev-udp-title = Ein Shirt über das Netz
shirtdev-udp-about = Datenpakete, die über UDP auf diesem Rechner ankommen.
shirtdev-udp-in-use = Shirt über das Netz auf Port { $port }
shirtdev-udp-needs = ein Shirt, das Datenpakete über UDP sendet, im Netz dieses Rechners
shirtdev-udp-costs = so viel wie das Shirt
shirtdev-udp-takes = eine Minute und eine weitere für das Koppeln des Schlüssels, dann die Kalibrierung
# An address of this machine.
shirtdev-udp-host = Empfangen auf
shirtdev-udp-port = Port
# Trackers: small sensors of orientation, each worn on one part of the body. SlimeVR and owoTrack are names.
shirtdev-slimevr-title = Tracker (SlimeVR)
shirtdev-slimevr-about = Kleine Lagesensoren an Körperteilen, über das Funknetz; auch Telefone mit owoTrack.
shirtdev-slimevr-in-use = Tracker auf Port { $port }
shirtdev-slimevr-needs = zwei oder mehr Tracker, Gurte und das Funknetz dieses Rechners
shirtdev-slimevr-costs = etwa 30 bis 60 € je Tracker
shirtdev-slimevr-takes = eine Minute, sobald die Tracker im Netz sind, dann die Kalibrierung
shirtdev-slimevr-host-hint = 0.0.0.0 steht für alle Netze dieses Rechners: Dort suchen ihn die Tracker.
shirtdev-trunk-hint = Sensoren, die senden, stehen zur Wahl. Kopf, Oberarme und Oberschenkel werden von diesem aus gemessen.
shirtdev-chair-hint = Ohne Sensor am Rumpf tritt dieser an dessen Stelle.
# A limb: an arm or a leg. Its neighbour is the next part towards the trunk, such as the upper arm for the forearm.
shirtdev-from-neighbour = Jedes Körperteil von seinem Nachbarn aus messen
# Parts of the body that wear a tracker: the label of a field, and in lists.
shirtdev-part-trunk = Rumpf
shirtdev-part-chair = Rollstuhl
shirtdev-part-head = Kopf
shirtdev-part-left-upper-arm = Linker Oberarm
shirtdev-part-right-upper-arm = Rechter Oberarm
shirtdev-part-left-forearm = Linker Unterarm
shirtdev-part-right-forearm = Rechter Unterarm
shirtdev-part-left-hand = Linke Hand
shirtdev-part-right-hand = Rechte Hand
shirtdev-part-left-fingers = Linke Finger
shirtdev-part-right-fingers = Rechte Finger
shirtdev-part-left-thigh = Linker Oberschenkel
shirtdev-part-right-thigh = Rechter Oberschenkel
shirtdev-part-left-lower-leg = Linker Unterschenkel
shirtdev-part-right-lower-leg = Rechter Unterschenkel
shirtdev-part-left-foot = Linker Fuß
shirtdev-part-right-foot = Rechter Fuß
shirtdev-bluetooth-title = Sensoren über Bluetooth (WitMotion)
shirtdev-bluetooth-about = Kleine Lagesensoren an Körperteilen, etwa der WT901BLE.
shirtdev-bluetooth-in-use = Bluetooth-Sensoren, { $rate } Datenpakete pro Sekunde
shirtdev-bluetooth-needs = zwei oder mehr Sensoren, Gurte und einen Bluetooth-Adapter mit Low Energy (4.0 oder neuer)
shirtdev-bluetooth-costs = etwa 35 bis 50 € je Sensor; ein Adapter etwa 10 €
shirtdev-bluetooth-takes = eine Minute, dann die Kalibrierung
# BrainFlow and OpenBCI are names. A board measures with electrodes or other sensors, and sends what it measures.
shirtdev-brainflow-title = Eine Platine (BrainFlow)
shirtdev-brainflow-about = Platinen von OpenBCI und anderen Herstellern, mit Elektroden oder Bewegungssensoren.
shirtdev-brainflow-in-use = Platine { $board }
shirtdev-brainflow-needs = eine Platine aus BrainFlows Liste, etwa eine von OpenBCI
shirtdev-brainflow-costs = etwa 150 € für einen Muskelsensor bis über 1000 € für einen Verstärker
shirtdev-brainflow-takes = einige Minuten, dann die Kalibrierung
shirtdev-brainflow-board = Platine
shirtdev-brainflow-board-hint = So, wie BrainFlows Liste der Platinen (boards) sie nennt, etwa CYTON_BOARD, oder ihre Nummer dort.
# What of the board's data is used. accel, gyro and so on are names that are typed, and are not translated.
shirtdev-brainflow-data = Daten
shirtdev-brainflow-data-hint = Namen mit Kommas dazwischen: accel (Beschleunigung), gyro (Drehrate), analog, resistance (Widerstand), exg (alle Elektroden), emg, oder was die Platine sonst hat.
# A board can send up to three streams, each at a rate of its own.
shirtdev-brainflow-preset = Datenstrom
shirtdev-brainflow-preset-hint = Manche Platinen senden die Beschleunigung in ihrem zweiten Datenstrom.
shirtdev-brainflow-preset-default = Hauptstrom
shirtdev-brainflow-preset-auxiliary = Zweiter Datenstrom (auxiliary)
shirtdev-brainflow-preset-ancillary = Dritter Datenstrom (ancillary)
shirtdev-brainflow-needs-hint = Füllen Sie aus, was BrainFlows Liste für diese Platine verlangt, und lassen Sie den Rest leer.
# Of a Bluetooth device.
shirtdev-brainflow-mac = MAC-Adresse
shirtdev-brainflow-ip = IP-Adresse
shirtdev-brainflow-port-hint = 0, wenn die Platine keinen braucht.
shirtdev-brainflow-number = Seriennummer
# What else BrainFlow's list asks for with some boards.
shirtdev-brainflow-other = Weitere Angaben
shirtdev-brainflow-layout-hint = Eine JSON-Datei, die die Sensoren benennt. Ohne Datei ist jede Art von Daten ein Gelenk.
shirtdev-phones-title = Telefone als Sensoren
shirtdev-phones-about = Bis zu sechs Telefone oder Tablets, an Körperteile gebunden, zeigen, wie sich diese drehen. Jedes öffnet eine Seite und sendet; installiert wird nichts.
shirtdev-phones-in-use = Telefone, { $rate } Datenpakete pro Sekunde
shirtdev-phones-needs = ein bis sechs Telefone oder Tablets mit einem aktuellen Browser und etwas, das sie festhält; Seiten über https
shirtdev-phones-costs = nichts, wo es solche Geräte gibt; ein Armband etwa 10 €
shirtdev-phones-takes = eine Minute je Telefon, dann die Kalibrierung
shirtdev-camera-title = Eine Kamera
shirtdev-camera-about = Die Kamera eines Tablets, Laptops oder Telefons folgt dem Oberkörper; niemand trägt etwas. Ihr Bild bleibt im Browser.
shirtdev-camera-in-use = Kamera, { $rate } Datenpakete pro Sekunde
shirtdev-camera-needs = ein Gerät mit Kamera und einem aktuellen Browser und Licht von vorn; eine Seite über https oder auf diesem Rechner selbst
shirtdev-camera-costs = nichts, wo es ein solches Gerät gibt
shirtdev-camera-takes = ein bis zwei Minuten, dann die Kalibrierung
shirtdev-camera-rate-hint = Wählen Sie weniger, wenn das Gerät nicht mitkommt.
# LSL is the Lab Streaming Layer, a network protocol of laboratories.
shirtdev-lsl-title = Datenströme des Lab Streaming Layer
shirtdev-lsl-about = LSL: Verstärker, Bewegungserfassung und andere Geräte eines Labors.
shirtdev-lsl-in-use = LSL-Datenströme
shirtdev-lsl-needs = ein Gerät oder Programm, das Zahlen über LSL sendet, im Netz dieses Rechners
shirtdev-lsl-costs = nichts, wo es ein solches Gerät gibt
shirtdev-lsl-takes = eine Minute, dann die Kalibrierung
shirtdev-lsl-name = Name des Datenstroms
shirtdev-lsl-name-hint = Lassen Sie leer, was keine Rolle spielt. Mehrere Werte, durch Kommas getrennt, verbinden ebenso viele Datenströme.
# What names the device that sends the stream.
shirtdev-lsl-source = Quellen-ID
# The kind of what the stream contains, such as EEG or MoCap.
shirtdev-lsl-type = Typ
# The computer that sends the stream.
shirtdev-lsl-host = Rechner
shirtdev-lsl-rate-hint = Gilt nur für Datenströme ohne eigene Rate.
shirtdev-lsl-layout-hint = Eine JSON-Datei, die die Sensoren benennt. Ohne Datei gelten die Namen der Datenströme.

## Why a shirt may not drive a real chair.

shirtdev-nobody-wears = Mit einem simulierten oder abgespielten Shirt lässt sich kein echter Rollstuhl freigeben, denn niemand trägt es. Wählen Sie auf der Seite „Shirt“ das Shirt, das der Patient trägt.
shirtdev-nobody-proves = Mit dieser Quelle lässt sich kein echter Rollstuhl freigeben, denn nichts belegt, wessen Bewegungen sie zeigt. Wählen Sie auf der Seite „Shirt“ das Shirt, das der Patient trägt.
shirtdev-no-key = Mit einem Shirt ohne Schlüssel lässt sich kein echter Rollstuhl freigeben, denn jedes Gerät im Netz könnte Datenpakete an seiner Stelle senden. Koppeln Sie das Shirt (bodydrive shirt pair), und wählen Sie dann auf der Seite „Shirt“ seinen Schlüssel.
shirtdev-no-cable = Mit diesem Shirt lässt sich kein echter Rollstuhl freigeben, denn seine serielle Schnittstelle gehört zu keinem Gerät an diesem Rechner, und jedes Programm könnte darüber senden. Wählen Sie auf der Seite „Shirt“ die Schnittstelle, an der das Kabel des Shirts steckt.

## What shirts say of themselves, and why one cannot be opened.

shirtdev-no-standard = { $file }: das Standard-Shirt lässt sich nicht lesen ({ $why }); installieren Sie das Programm neu
shirtdev-no-channel = das Shirt „{ $shirt }“ hat keinen Kanal „{ $channel }“, der defekt sein könnte; korrigieren Sie den Namen

shirtdev-simulator-closed = Das simulierte Shirt ist geschlossen.
# $rate is the count of frames a second.
shirtdev-simulator-empty = Simuliertes Shirt, { $sensors } Sensoren mit { $rate } Hz, ohne Körper darin.
shirtdev-simulator = Simuliertes Shirt, { $sensors } Sensoren mit { $rate } Hz, mit einem simulierten Körper darin.

shirtdev-replay-closed = Die Wiedergabe ist geschlossen.
shirtdev-replay-ended = Die Wiedergabe von { $file } ist zu Ende. Starten Sie sie noch einmal, oder wählen Sie „{ shirtdev-replay-loop }“.
# $note is a further sentence: what was mended, or is missing, in the times of the file.
shirtdev-replay =
    Wiedergabe von { $file }, { $sensors } Sensoren mit { $rate } Hz, { $played } s von { $length } s.{ $note ->
        [none] {""}
       *[other] {" "}{ $note }
    }
shirtdev-replay-failed = { $file }: das lässt sich nicht lesen ({ $why }); prüfen Sie es
# $layout is the name of a file.
shirtdev-file-no-joint = { $file }: nirgends steht, zu welchem Gelenk die Spalte „{ $column }“ gehört; legen Sie das Layout des Shirts als { $layout } neben die Datei, oder benennen Sie die Spalten wie right_elbow_1
shirtdev-recording-short =
    { $folder }: diese Aufzeichnung enthält nur { $frames ->
        [one] { $frames } Datenpaket
       *[other] { $frames } Datenpakete
    } eines Shirts; nennen Sie eine längere
shirtdev-recording-times = { $folder }: die Zeiten dieser Aufzeichnung steigen nicht; nennen Sie eine andere
shirtdev-recording-channels =
    { $folder }: diese Aufzeichnung hat { $channels ->
        [one] { $channels } Kanal
       *[other] { $channels } Kanäle
    } und ihr Layout { $named }; nennen Sie eine andere
shirtdev-recording-rate = { $folder }: in dieser Aufzeichnung steht nicht, mit welcher Abtastrate sie entstand; nennen Sie eine andere
# The place of a problem, in front of a colon or comma and the problem.
shirtdev-file-columns = { $file }: seine Spalten ergeben kein Layout
shirtdev-recording-layout = { $folder }: das Layout des Shirts in dieser Aufzeichnung

# $why is the reason that the system gives, $lines a list of serial lines that are there.
shirtdev-serial-failed =
    { $cause ->
        [missing] das Shirt an { $device } lässt sich nicht öffnen ({ $why }); stecken Sie sein Kabel ein{ $lines ->
            [none] {""}
           *[other] , oder wählen Sie den Namen, den die Schnittstelle jetzt hat: { $lines }
        }
        [forbidden] das Shirt an { $device } lässt sich nicht öffnen ({ $why }); erlauben Sie diesem Programm serielle Schnittstellen, auf den meisten Systemen durch die Gruppe dialout für sein Konto
        [busy] das Shirt an { $device } lässt sich nicht öffnen ({ $why }); beenden Sie das andere Programm, das es verwendet
       *[other] das Shirt an { $device } lässt sich nicht öffnen ({ $why }); prüfen Sie Kabel und Baudrate
    }
shirtdev-serial-closed = Für das Shirt ist keine serielle Schnittstelle geöffnet.
shirtdev-serial-lost = Das Shirt an { $device } ist nicht mehr da. Stecken Sie sein Kabel wieder ein; die Signale kommen dann von selbst zurück.
shirtdev-serial-silent = Vom Shirt an { $device } kommt nichts an. Prüfen Sie, ob seine Platine Strom hat und ihr Programm läuft.
# $trouble is a message shirtdev-serial-foreign or shirtdev-frame-...
shirtdev-serial-unreadable = Was an { $device } ankommt, ist kein Datenpaket dieses Shirts ({ $trouble }).
# Stands in brackets, behind what is left out.
shirtdev-serial-foreign = wählen Sie Format und Baudrate, die das Programm der Platine hat
# $refused counts what arrived and was no frame of this shirt; $delay are the seconds by which the newest frame came late.
shirtdev-serial =
    Shirt an { $device }, { $sensors } Sensoren{ $lost ->
        [0] {""}
        [one] , { $lost } Datenpaket verloren
       *[other] , { $lost } Datenpakete verloren
    }{ $refused ->
        [0] {""}
       *[other] , { $refused }-mal kam anderes an ({ $trouble })
    }{ $late ->
        [yes] , { $delay } s verspätet
       *[no] {""}
    }.

# $problem is a message device-key-...
shirtdev-not-opened = das Shirt lässt sich nicht verwenden: { $problem }
shirtdev-udp-no-address = das Shirt lässt sich auf { $host } nicht empfangen, das ist keine Adresse; korrigieren Sie sie
shirtdev-udp-failed =
    { $cause ->
        [taken] das Shirt lässt sich auf { $place } nicht empfangen ({ $why }); beenden Sie das andere Programm, das dort empfängt, oder verwenden Sie einen freien Port
        [forbidden] das Shirt lässt sich auf { $place } nicht empfangen ({ $why }); verwenden Sie einen Port ab 1024
        [elsewhere] das Shirt lässt sich auf { $place } nicht empfangen ({ $why }); verwenden Sie eine Adresse dieses Rechners oder 0.0.0.0 für alle
       *[other] das Shirt lässt sich auf { $place } nicht empfangen ({ $why }); verwenden Sie eine Adresse dieses Rechners und einen freien Port
    }
# $trouble is a message shirtdev-newest-not-stored or shirtdev-frame-...
shirtdev-udp-closed =
    Der Empfang des Shirts ist aus{ $trouble ->
        [none] {""}
       *[other] {" "}({ $trouble })
    }.
# $sender and $stranger are addresses. Left out are frames that do not count.
shirtdev-udp-silent =
    Keine Datenpakete von { $sender ->
        [unknown] einem Shirt
       *[other] { $sender }
    } auf { $place }{ $trouble ->
        [none] {""}
       *[other] {" "}({ $trouble })
    }{ $other ->
        [0] {""}
        [one] , { $other } Datenpaket eines anderen Senders ({ $stranger }) ausgelassen
       *[other] , { $other } Datenpakete eines anderen Senders ({ $stranger }) ausgelassen
    }{ $repeated ->
        [0] {""}
        [one] , { $repeated } wiederholtes Datenpaket ausgelassen
       *[other] , { $repeated } wiederholte Datenpakete ausgelassen
    }{ $late ->
        [0] {""}
        [one] , { $late } verspätetes Datenpaket ausgelassen
       *[other] , { $late } verspätete Datenpakete ausgelassen
    }.
# $refused counts datagrams (packets of the network) that hold no good frame of this shirt.
shirtdev-udp =
    Shirt auf { $place } von { $sender }, { $sensors } Sensoren{ $lost ->
        [0] {""}
        [one] , { $lost } Datenpaket verloren
       *[other] , { $lost } Datenpakete verloren
    }{ $refused ->
        [0] {""}
        [one] , { $refused } Datagramm abgelehnt{ $trouble ->
            [none] {""}
           *[other] {" "}({ $trouble })
        }
       *[other] , { $refused } Datagramme abgelehnt{ $trouble ->
            [none] {""}
           *[other] {" "}({ $trouble })
        }
    }{ $other ->
        [0] {""}
        [one] , { $other } Datenpaket eines anderen Senders ({ $stranger }) ausgelassen
       *[other] , { $other } Datenpakete eines anderen Senders ({ $stranger }) ausgelassen
    }{ $repeated ->
        [0] {""}
        [one] , { $repeated } wiederholtes Datenpaket ausgelassen
       *[other] , { $repeated } wiederholte Datenpakete ausgelassen
    }{ $late ->
        [0] {""}
        [one] , { $late } verspätetes Datenpaket ausgelassen
       *[other] , { $late } verspätete Datenpakete ausgelassen
    }.

shirtdev-camera-closed = Die Kamera wird nicht verwendet.
# $late and $refused count what is left out; $delay is how late the newest one was.
shirtdev-camera-silent =
    Keine Kamera sendet: Starten Sie sie auf der Seite „Shirt“ oder auf dem Patientenbildschirm{ $late ->
        [0] {""}
       *[other] {" "}(ihre Bilder kamen { $delay } s zu spät, und ein verspätetes zählt nicht: Schließen Sie andere Programme auf diesem Gerät, oder wählen Sie weniger Datenpakete pro Sekunde)
    }{ $refused ->
        [0] {""}
        [one] , { $refused } Nachricht abgelehnt
       *[other] , { $refused } Nachrichten abgelehnt
    }.
shirtdev-camera-nobody =
    Die Kamera sieht niemanden, und ihre { $sensors } Sensoren fehlen: Setzen Sie sich so, dass Kopf, Schultern und Arme im Bild sind{ $lost ->
        [0] {""}
        [one] , { $lost } Datenpaket verloren
       *[other] , { $lost } Datenpakete verloren
    }{ $refused ->
        [0] {""}
        [one] , { $refused } Nachricht abgelehnt
       *[other] , { $refused } Nachrichten abgelehnt
    }{ $late ->
        [0] {""}
        [one] , { $late } verspätetes Bild ausgelassen
       *[other] , { $late } verspätete Bilder ausgelassen
    }.
# $pictures is the measured count a second, $delay the age of the newest picture in ms.
shirtdev-camera =
    Kamera, { $sensors } Sensoren, { $pictures } Bilder pro Sekunde, jedes bei der Ankunft { $delay } ms alt{ $lost ->
        [0] {""}
        [one] , { $lost } Datenpaket verloren
       *[other] , { $lost } Datenpakete verloren
    }{ $refused ->
        [0] {""}
        [one] , { $refused } Nachricht abgelehnt
       *[other] , { $refused } Nachrichten abgelehnt
    }{ $late ->
        [0] {""}
        [one] , { $late } verspätetes Bild ausgelassen
       *[other] , { $late } verspätete Bilder ausgelassen
    }.

shirtdev-lsl-no-library = LSL ist nicht vollständig installiert; installieren Sie die Pakete pylsl und liblsl, und versuchen Sie es noch einmal
# One stream, in a sentence that lists several. $type, $source (its source ID) and $host can be 'none'.
shirtdev-lsl-stream =
    { $name } ({ $source ->
        [none] {""}
       *[other] Quellen-ID { $source },{" "}
    }{ $type ->
        [none] {""}
       *[other] Typ { $type },{" "}
    }Rechner { $host })
shirtdev-lsl-nothing = in diesem Netz ist kein LSL-Datenstrom aus Zahlen; starten Sie das Programm, das ihn sendet, und erlauben Sie UDP und TCP von Port 16571 bis 16604
# $sought is a list of what was entered, $streams one of streams.
shirtdev-lsl-none = kein LSL-Datenstrom passt zu { $sought }, vorhanden: { $streams }; korrigieren Sie die Angaben, oder starten Sie das Programm, das ihn sendet
shirtdev-lsl-several = { $count } LSL-Datenströme passen, darunter { $streams }; geben Sie Quellen-ID oder Rechner von einem ein, oder mehrere Quellen-IDs mit Kommas dazwischen, um diese Datenströme zu verbinden
shirtdev-lsl-no-answer = der LSL-Datenstrom { $stream } antwortet nicht; erlauben Sie UDP und TCP von Port 16572 bis 16604 zwischen beiden Rechnern
shirtdev-lsl-channels = die LSL-Datenströme haben zusammen { $channels } Kanäle, höchstens { $most } lassen sich verwenden; wählen Sie weniger Datenströme
shirtdev-lsl-misfit =
    die LSL-Datenströme haben { $channels ->
        [one] { $channels } Kanal
       *[other] { $channels } Kanäle
    } und das Layout { $named }; wählen Sie ein anderes Layout oder keines
shirtdev-lsl-rate = der schnellste LSL-Datenstrom hat { $rate } Werte pro Sekunde, verwenden lassen sich { $low } bis { $high }; wählen Sie einen anderen
shirtdev-lsl-closed = Kein LSL-Datenstrom ist offen.
# $streams is a list of streams.
shirtdev-lsl-silent = Keine Werte von { $streams }.
# $age is how long ago the newest sample was measured, $gone a list of streams whose senders have ended.
shirtdev-lsl =
    LSL-Datenströme, { $sensors } Sensoren mit { $rate } Hz, { $age } ms alt{ $lost ->
        [0] {""}
        [one] , { $lost } Datenpaket verloren
       *[other] , { $lost } Datenpakete verloren
    }{ $gone ->
        [none] {""}
       *[other] ; nichts kommt mehr von { $gone }
    }.

shirtdev-brainflow-no-library = Platinen brauchen die Bibliothek BrainFlow ({ $why }); installieren Sie sie mit pip install 'bodydrive[brainflow]', und wählen Sie die Platine dann noch einmal
# $boards is a list of names of boards.
shirtdev-brainflow-no-board = BrainFlow kennt keine Platine { $given }; schreiben Sie den Namen oder die Nummer einer vorhandenen, etwa { $boards }
shirtdev-brainflow-nobody-wears = { $board } spielt Signale ab oder erzeugt sie, und niemand trägt sie; wählen Sie eine echte Platine, das simulierte Shirt oder die Wiedergabe einer Datei
shirtdev-brainflow-no-stream = die Platine { $board } hat diesen Datenstrom nicht; wählen Sie einen anderen
# $kinds is a list of names such as accel.
shirtdev-brainflow-no-data = dieser Datenstrom der Platine { $board } hat { $kinds }; schreiben Sie eines davon als Daten, oder mehrere mit Kommas dazwischen
shirtdev-brainflow-channels = die Platine { $board } hat { $channels } Kanäle mit diesen Daten, höchstens { $most } lassen sich verwenden; schreiben Sie weniger Arten
shirtdev-brainflow-misfit =
    die Platine hat { $channels ->
        [one] { $channels } Kanal
       *[other] { $channels } Kanäle
    } mit diesen Daten und das Layout { $named }; wählen Sie ein anderes Layout oder keines
shirtdev-brainflow-rate = dieser Datenstrom der Platine { $board } hat { $rate } Werte pro Sekunde, verwenden lassen sich { $low } bis { $high }; wählen Sie einen anderen
shirtdev-brainflow-failed =
    { $cause ->
        [port] die Platine { $board } lässt sich nicht öffnen ({ $why }); prüfen Sie ihre serielle Schnittstelle, und beenden Sie das andere Programm, das sie verwendet
        [missing] die Platine { $board } lässt sich nicht öffnen ({ $why }); schalten Sie sie ein, und bringen Sie sie näher heran
        [fields] die Platine { $board } lässt sich nicht öffnen ({ $why }); füllen Sie aus, was BrainFlows Liste für sie verlangt
       *[other] die Platine { $board } lässt sich nicht öffnen ({ $why }); prüfen Sie, ob sie eingeschaltet ist, und die Angaben
    }
shirtdev-brainflow-closed = Keine Platine ist geöffnet.
shirtdev-brainflow-silent =
    Von der Platine { $board } kommt nichts an{ $why ->
        [none] {""}
       *[other] {" "}({ $why })
    }. Schalten Sie sie ein; ihre Signale kommen dann von selbst zurück.
# $age is how much longer the newest sample took than the quickest one.
shirtdev-brainflow =
    Platine { $board }, { $sensors } Sensoren mit { $rate } Hz, { $age } ms später als der schnellste Wert{ $lost ->
        [0] {""}
        [one] , { $lost } Datenpaket verloren
       *[other] , { $lost } Datenpakete verloren
    }.

# So that no old frame drives, the number of the newest one is stored in a file.
shirtdev-newest-unknown = { $file }: nirgends steht, welches Datenpaket dieses Shirts das neueste war, und ein altes darf nicht fahren; koppeln Sie das Shirt neu

# $sensor is the name of a sensor: the address of a tracker, perhaps with a number and flex.
shirtdev-slimevr-no-name = „{ $given }“ ist keine Adresse eines Trackers; schreiben Sie sie wie A1:B2:C3:D4:E5:F6, mit /1 für einen zweiten Sensor und /flex für einen Dehnungssensor
shirtdev-sensor-twice = der Sensor { $sensor } steht bei zwei Körperteilen; lassen Sie eines davon leer
shirtdev-slimevr-flex-chair = der Sensor { $sensor } misst keine Lage; wählen Sie für den Rollstuhl einen anderen, oder lassen Sie das Feld leer
shirtdev-slimevr-closed = Der Empfang der Tracker ist aus.
# $refused counts datagrams (packets of the network) that are none of a tracker.
shirtdev-slimevr =
    Tracker auf { $place }: { $sending } von { $placed } senden, { $sensors } Sensoren{ $refused ->
        [0] {""}
        [one] , { $refused } Datagramm abgelehnt
       *[other] , { $refused } Datagramme abgelehnt
    }.
# $sensors is a list of addresses.
shirtdev-slimevr-found = An keinem Körperteil: { $sensors }. Wählen Sie jeden bei dem Körperteil, an dem er sitzt.
shirtdev-phones-no-number = „{ $given }“ ist die Nummer keines Telefons; schreiben Sie eine von 1 bis { $most }
shirtdev-phones-closed = Die Telefone sind nicht in Gebrauch.
# $late and $refused count what is left out; $delay is how late the newest one was.
shirtdev-phones =
    Telefone: { $sending } von { $placed } senden, { $sensors } Sensoren{ $refused ->
        [0] {""}
        [one] , { $refused } Nachricht abgelehnt
       *[other] , { $refused } Nachrichten abgelehnt
    }{ $late ->
        [0] {""}
        [one] , { $late } verspätete Nachricht ausgelassen (die neueste brauchte { $delay } s länger als die schnellste)
       *[other] , { $late } verspätete Nachrichten ausgelassen (die neueste brauchte { $delay } s länger als die schnellste)
    }.
# $phones is a list of numbers.
shirtdev-phones-found = An keinem Körperteil: Telefon { $phones }. Wählen Sie jedes bei dem Körperteil, an dem es sitzt.
shirtdev-bluetooth-no-address = „{ $given }“ ist keine Adresse eines Bluetooth-Sensors; schreiben Sie sie wie A1:B2:C3:D4:E5:F6
# $why, here and below, is what a library or the system says.
shirtdev-bluetooth-no-library = Bluetooth-Sensoren brauchen die Bibliothek bleak ({ $why }); installieren Sie sie mit pip install 'bodydrive[bluetooth]', und wählen Sie die Sensoren dann noch einmal
shirtdev-bluetooth-failed =
    das Bluetooth dieses Rechners lässt sich nicht verwenden{ $why ->
        [none] {""}
       *[other] {" "}({ $why })
    }; prüfen Sie, ob er einen Bluetooth-Adapter hat, schalten Sie ihn ein, und erlauben Sie ihn dem Konto dieses Programms
shirtdev-bluetooth-closed = Die Bluetooth-Sensoren sind nicht in Gebrauch.
# $refused counts messages that are none of such a sensor, $repeated those with nothing new in them; $trouble is what
# the system's Bluetooth says.
shirtdev-bluetooth =
    Bluetooth: { $sending } von { $placed } senden, { $sensors } Sensoren{ $refused ->
        [0] {""}
        [one] , { $refused } Nachricht abgelehnt
       *[other] , { $refused } Nachrichten abgelehnt
    }{ $repeated ->
        [0] {""}
        [one] , { $repeated } Nachricht wiederholt
       *[other] , { $repeated } Nachrichten wiederholt
    }{ $trouble ->
        [none] {""}
       *[other] {" "}({ $trouble })
    }.
# In the next four, $parts is a list of parts of the body.
shirtdev-sensors-silent = Sendet nicht: { $parts }. Schalten Sie die Sensoren dort ein, und prüfen Sie ihr Netz.
shirtdev-sensors-moving = Noch nicht in Ruhe: { $parts }. Eine Sekunde stillhalten, Arme hängen lassen.
shirtdev-sensors-drift = Driftet um mehr als 2° pro Sekunde: { $parts }. Legen Sie den Sensor eine Minute lang hin, oder kalibrieren Sie ihn, wie sein Hersteller es angibt.
shirtdev-sensors-battery = Akku fast leer: { $parts }. Laden Sie ihn.

## Why frames are not used: each stands in brackets, behind what is left out.

shirtdev-newest-not-stored = die Nummer des neuesten Datenpakets lässt sich nicht speichern ({ $why }); schaffen Sie Speicherplatz
shirtdev-frame-late = seine Datenpakete kommen { $delay } s zu spät an, und ein verspätetes zählt nicht; bringen Sie das Shirt näher an seinen Empfänger, und prüfen Sie, was das Netz sonst noch nutzt
shirtdev-frame-short = ein Datagramm von { $size } Byte ist zu kurz für ein Datenpaket
shirtdev-frame-foreign = was ankommt, stammt nicht von einem Shirt
shirtdev-frame-version = das Shirt sendet Version { $version } des Formats, verstanden wird Version { $understood }
shirtdev-frame-flags = das Shirt verwendet Flags, die nicht verstanden werden ({ $flags })
shirtdev-frame-sensors = das Shirt sendet { $sent } Sensoren, sein Layout hat { $expected }; verwenden Sie das Layout dieses Shirts
shirtdev-frame-needs-key = das Shirt signiert seine Datenpakete; wählen Sie seinen Schlüssel
shirtdev-frame-not-signed = ein Datenpaket war nicht mit dem Schlüssel dieses Shirts signiert oder kam beschädigt an
shirtdev-frame-damaged = ein Datenpaket kam beschädigt an
