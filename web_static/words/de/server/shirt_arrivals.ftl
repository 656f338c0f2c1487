### Was bei einem Shirt ankommt, wie die Seite „Shirt“ es von selbst sagt, und was zu tun ist, wenn nichts kommt.

arrivals-good = Signale kommen an.
arrivals-waiting = Es wird auf Signale gewartet.
# Packets are those of a network (UDP). $place is an address with a port. machine: no other machine can reach that address.
arrivals-udp-nothing =
    { $reach ->
        [machine] Auf { $place } kommt gar nichts an. Nur Programme auf diesem Rechner erreichen diese Adresse. Für ein Shirt anderswo empfangen Sie auf einer anderen Adresse dieses Rechners oder auf 0.0.0.0, das sind alle.
       *[network] Auf { $place } kommt gar nichts an: Nichts wird dorthin gesendet, oder eine Firewall hält es ab. Lassen Sie das Shirt an eine Adresse dieses Rechners und Port { $port } senden, und öffnen Sie in seiner Firewall den UDP-Port { $port }.
    }
arrivals-slimevr-nothing =
    { $reach ->
        [machine] Auf { $place } kommt gar nichts an. Nur Programme auf diesem Rechner erreichen diese Adresse. Empfangen Sie auf 0.0.0.0, das sind alle Netze dieses Rechners, damit die Tracker ihn finden.
       *[network] Auf { $place } kommt gar nichts an: Die Tracker sind in einem anderen Netz, oder eine Firewall hält ihre Pakete ab. Bringen Sie sie in das Netz dieses Rechners, und öffnen Sie in seiner Firewall den UDP-Port { $port }.
    }
arrivals-slimevr-idle = Ein Tracker antwortet, sendet aber keine Bewegung. Bewegen Sie ihn: Manche senden nichts, solange sie ganz still liegen. Bleibt es so, schalten Sie ihn aus und ein, und prüfen Sie, ob eine Firewall abhält, was dieser Rechner ihm sendet.
# $source is a kind of shirt, $parts a list of parts of the body.
arrivals-partial =
    { $source ->
        [slimevr] Signale kommen an, aber keine von: { $parts }. Schalten Sie den Tracker dort ein. Einer, der nur sendet, was sich geändert hat, gilt als stumm, solange er ganz still liegt: Verwenden Sie eine Firmware, die auch dann sendet (OPTIMIZE_UPDATES aus).
       *[other] Signale kommen an, aber keine von: { $parts }. Schalten Sie den Sensor dort ein.
    }
# $why is a message shirtdev-frame-... or arrivals-no-tracker; $sender is an address.
arrivals-foreign =
    { $count ->
        [one] { $count } Paket kam an, das kein Datenpaket dieses Shirts ist. Es hat { $size } Byte und kommt von { $sender } ({ $why }).
       *[other] { $count } Pakete kamen an, die keine Datenpakete dieses Shirts sind. Das neueste hat { $size } Byte und kommt von { $sender } ({ $why }).
    }
# Stands in brackets, behind what is left out.
arrivals-no-tracker = es stammt nicht von einem Tracker; lassen Sie nichts anderes an diesen Port senden
# $why is a message shirtdev-frame-late, shirtdev-newest-not-stored or arrivals-repeated.
arrivals-none-counts = Datenpakete kommen an, aber keines zählt ({ $why }).
arrivals-repeated = jedes wurde schon verwendet; starten Sie das Shirt neu
# $stranger and $sender are addresses.
arrivals-senders = Von { $stranger } kommen Datenpakete. Sie werden ausgelassen, weil der Sender { $sender } das Shirt ist.
arrivals-rate = { $measured } Datenpakete pro Sekunde kommen an, eingestellt sind { $expected }. Wählen Sie bei „{ shirtdev-rate }“ { $measured }, oder lassen Sie das Gerät { $expected } senden.
arrivals-serial-foreign = An { $device } kamen bisher { $bytes } Byte an, aber was kommt, ist kein Datenpaket dieses Shirts ({ $why }).
# $lines is a list of serial lines.
arrivals-serial-gone =
    Das Shirt an { $device } ist nicht mehr da. Stecken Sie sein Kabel wieder ein; die Signale kommen dann von selbst zurück.{ $lines ->
        [none] {""}
       *[other] {" "}Heißt die Schnittstelle danach anders, wählen Sie diese: Dieser Rechner hat { $lines }.
    }
# $streams is a list of streams.
arrivals-lsl-silent =
    { $ended ->
        [yes] Das Programm, das { $streams } sendet, ist beendet. Starten Sie es auf demselben Rechner neu; seine Werte kommen dann von selbst zurück.
       *[no] Von { $streams } kommen keine Werte. Lassen Sie das sendende Programm beginnen, und öffnen Sie zwischen beiden Rechnern die UDP- und TCP-Ports 16572 bis 16604.
    }
arrivals-camera-nothing = Keine Seite sendet als Kamera. Starten Sie sie hier oder auf dem Patientenbildschirm, und lassen Sie diese Seite sichtbar.
arrivals-camera-nobody = Die Kamera sendet, sieht aber niemanden. Setzen Sie sich so, dass Kopf, Schultern und Arme im Bild sind.
arrivals-camera-idle = Die Kamera liefert immer dasselbe Bild. Prüfen Sie, ob sie verdeckt oder ausgeschaltet ist, und starten Sie sie neu.
arrivals-camera-late = Bilder kommen { $delay } s zu spät an, und ein verspätetes zählt nicht. Schließen Sie andere Programme auf dem Gerät der Kamera, oder wählen Sie weniger Datenpakete pro Sekunde.
arrivals-camera-slow = Die Kamera liest { $pictures } Bilder pro Sekunde, zu wenige für { $expected } Datenpakete. Wählen Sie weniger Datenpakete pro Sekunde, oder verwenden Sie ein anderes Gerät.
arrivals-page-foreign =
    { $count ->
        [one] { $count } Nachricht kam an, die kein neuer Wert ist. Laden Sie die Seite neu, die sie sendet.
       *[other] { $count } Nachrichten kamen an, die keine neuen Werte sind. Laden Sie die Seite neu, die sie sendet.
    }
arrivals-phones-nothing = Kein Telefon sendet. Koppeln Sie eines, tippen Sie darauf auf „Beginnen“, und lassen Sie seine Seite sichtbar. Seine Seite sagt, was ihm fehlt.
arrivals-phones-late = Nachrichten der Telefone kommen { $delay } s zu spät an, und eine verspätete zählt nicht. Bringen Sie die Telefone näher an die Station des Funknetzes.
# $why is what this computer's Bluetooth says.
arrivals-bluetooth-nothing =
    { $why ->
        [none] Kein Sensor ist in Reichweite. Schalten Sie die Sensoren ein, bringen Sie sie näher an diesen Rechner, und beenden Sie die App ihres Herstellers, denn ein Sensor hat nur eine Verbindung.
       *[other] Über Bluetooth kommt nichts an ({ $why }). Prüfen Sie, ob der Adapter dieses Rechners eingesteckt und eingeschaltet ist, schalten Sie die Sensoren aus und ein, und beenden Sie die App ihres Herstellers, denn ein Sensor hat nur eine Verbindung.
    }
arrivals-bluetooth-idle = Ein Sensor ist verbunden, sendet aber keine Bewegung. Schalten Sie ihn aus und ein.
arrivals-bluetooth-foreign =
    { $count ->
        [one] { $count } Nachricht kam an, die ein solcher Sensor nicht sendet. Verwenden Sie Sensoren von WitMotion mit Bluetooth 5, etwa den WT901BLE.
       *[other] { $count } Nachrichten kamen an, die ein solcher Sensor nicht sendet. Verwenden Sie Sensoren von WitMotion mit Bluetooth 5, etwa den WT901BLE.
    }
arrivals-bluetooth-repeated = Ein Sensor sendet immer wieder dieselbe Messung, und jede zählt nur einmal. Schalten Sie ihn aus und ein.
# $part is a part of the body.
arrivals-bluetooth-rate = { $part }: Der Sensor dort sendet { $measured }-mal pro Sekunde, zu selten für { $expected } Datenpakete. Bringen Sie ihn näher an diesen Rechner, oder wählen Sie weniger Datenpakete pro Sekunde.
# $board is the name of a board, $expected the rate that BrainFlow knows of it.
arrivals-brainflow-rate = Von der Platine { $board } kommen { $measured } Werte pro Sekunde an, ihr Datenstrom hat aber { $expected }. Bringen Sie die Platine näher an ihren Empfänger, oder stellen Sie sie auf { $expected } ein, wie ihr Hersteller es angibt.
