### What the head trackers say of themselves, and why one cannot be used.

headdev-simulated-rests = Der simulierte Kopf ist in Ruhe.
headdev-simulated-looks = Der simulierte Kopf sieht sich um.
headdev-tablet-unused = Die Richtung des Tablets wird nicht verwendet.
headdev-tablet-silent = Kein Tablet meldet seine Richtung. Öffnen Sie dort die Seite, und erlauben Sie ihr den Sensor.
headdev-tablet = Das Tablet meldet seine Richtung.
headdev-recorded-rests = Der aufgezeichnete Kopf { $file } wird nicht abgespielt.
headdev-recorded-plays = Der aufgezeichnete Kopf { $file } wird abgespielt.
headdev-recorded-short = { $file }: ein aufgezeichneter Kopf braucht mindestens { $least } s und steigende Zeiten; zeichnen Sie ihn neu auf

# $tracker is opentrack or FreePIE, $place the address HOST:PORT on this machine.
headdev-udp-failed =
    der Kopftracker { $tracker } lässt sich auf { $place } nicht empfangen ({ $why ->
        [no-address] es gibt diese Adresse nicht
       *[other] { $why }
    }); verwenden Sie eine Adresse dieses Rechners und einen freien Port
headdev-udp-closed = Der Empfang des Kopftrackers { $tracker } ist aus.
# $refused counts datagrams (packets of the network) that hold no pose of a head.
headdev-udp-silent =
    Keine Kopfhaltungen von { $tracker } auf { $place }{ $refused ->
        [0] {""}
        [one] , { $refused } Datagramm abgelehnt
       *[other] , { $refused } Datagramme abgelehnt
    }.
headdev-udp =
    Kopftracker { $tracker } auf { $place }{ $refused ->
        [0] {""}
        [one] , { $refused } Datagramm abgelehnt
       *[other] , { $refused } Datagramme abgelehnt
    }.

# The Flock of Birds is a tracker of the company Ascension; FLY is a position of its switch.
headdev-flock-failed = Flock of Birds an { $device } lässt sich nicht öffnen ({ $why }); prüfen Sie Kabel, Strom und den Namen des Geräts
headdev-flock-lost =
    Die Verbindung zu Flock of Birds an { $device } ging verloren ({ $why ->
        [unknown] das Gerät ist nicht mehr da
       *[other] { $why }
    }). Prüfen Sie das Kabel, und wählen Sie das Gerät dann neu.
headdev-flock-closed = Flock of Birds an { $device } ist nicht geöffnet.
headdev-flock-silent = Flock of Birds an { $device } sendet nichts. Schalten Sie das Gerät auf FLY, und prüfen Sie seine Baudrate.
headdev-flock = Flock of Birds an { $device }.
