### Problems with the devices in general: their configurations, addresses, drivers, keys; the simulated body.

# $given is what a person wrote, in quotes.
device-no-host = { $given } ist keine Adresse; schreiben Sie einen Namen wie chair.local oder eine Adresse wie 192.168.1.20
device-no-line = { $given } ist keine serielle Schnittstelle; schreiben Sie einen Namen wie /dev/ttyUSB0 oder COM3
device-no-cable = { $given } ist eine Funkverbindung (Bluetooth), über die auch andere senden könnten; schließen Sie die Platine mit ihrem Kabel an

# $kind and $kinds are names in configurations, which are not translated: simulator, replay, serial, udp
device-unknown-kind =
    { $device ->
        [body] einen Körper der Art „{ $kind }“ gibt es nicht; verwenden Sie eine dieser Arten: { $kinds }
        [chair] einen Rollstuhl der Art „{ $kind }“ gibt es nicht; verwenden Sie eine dieser Arten: { $kinds }
        [head] einen Kopftracker der Art „{ $kind }“ gibt es nicht; verwenden Sie eine dieser Arten: { $kinds }
       *[shirt] ein Shirt der Art „{ $kind }“ gibt es nicht; verwenden Sie eine dieser Arten: { $kinds }
    }
device-needs-kind =
    { $device ->
        [body] in der Konfiguration eines Körpers fehlt „kind“; geben Sie eine dieser Arten an: { $kinds }
        [chair] in der Konfiguration eines Rollstuhls fehlt „kind“; geben Sie eine dieser Arten an: { $kinds }
        [head] in der Konfiguration eines Kopftrackers fehlt „kind“; geben Sie eine dieser Arten an: { $kinds }
       *[shirt] in der Konfiguration eines Shirts fehlt „kind“; geben Sie eine dieser Arten an: { $kinds }
    }
device-no-library =
    { $device ->
        [body] der Körper „{ $kind }“ braucht die Bibliothek „{ $library }“, die nicht installiert ist; installieren Sie sie
        [chair] der Rollstuhl „{ $kind }“ braucht die Bibliothek „{ $library }“, die nicht installiert ist; installieren Sie sie
        [head] der Kopftracker „{ $kind }“ braucht die Bibliothek „{ $library }“, die nicht installiert ist; installieren Sie sie
       *[shirt] das Shirt „{ $kind }“ braucht die Bibliothek „{ $library }“, die nicht installiert ist; installieren Sie sie
    }
# $driver is the name of a part of the program, such as app.hardware.head.opentrack.
device-no-driver =
    { $device ->
        [body] der Treiber { $driver } des Körpers „{ $kind }“ fehlt in dieser Installation; installieren Sie bodydrive neu
        [chair] der Treiber { $driver } des Rollstuhls „{ $kind }“ fehlt in dieser Installation; installieren Sie bodydrive neu
        [head] der Treiber { $driver } des Kopftrackers „{ $kind }“ fehlt in dieser Installation; installieren Sie bodydrive neu
       *[shirt] der Treiber { $driver } des Shirts „{ $kind }“ fehlt in dieser Installation; installieren Sie bodydrive neu
    }
device-no-class = der Treiber { $driver } hat keine Klasse { $name }; korrigieren Sie seine Tabelle in app/hardware

## The key that a shirt or a chair shares with this machine. Each also stands behind a colon.

device-key-unreadable = die Schlüsseldatei { $file } lässt sich nicht lesen ({ $why }); geben Sie die Datei an, die beim Koppeln erstellt wurde
device-key-no-text = die Schlüsseldatei { $file } lässt sich nicht lesen (sie ist kein Text); geben Sie die Datei an, die beim Koppeln erstellt wurde
# In ` ` stands a command, which is not translated.
device-key-not-private = die Schlüsseldatei { $file } ist für andere lesbar; führen Sie `chmod 600 { $file }` aus, oder koppeln Sie neu
device-key-no-key = die Schlüsseldatei { $file } enthält keinen Schlüssel; sie muss aus einer Zeile bestehen: eine Zahl bis 65535, ein Leerzeichen, 64 Hexadezimalziffern
device-key-changed = die Schlüsseldatei { $file } enthält einen anderen Schlüssel als vorher; wählen Sie sie neu

## The simulated body.

# $joint and $joints are names in configurations, which are not translated: right_elbow, left_wrist
bodydev-no-joint = dieser Körper hat kein Gelenk „{ $joint }“; möglich sind: { $joints }
bodydev-no-place = das Gelenk „{ $joint }“ kann die Stellung { $place } nicht einnehmen; geben Sie einen Wert zwischen 0 und 1 an
bodydev-file-no-joint = { $file }: in dieser Datei kommt kein Gelenk des simulierten Körpers vor; benennen Sie Spalten wie { $columns }
bodydev-file-times = { $file }: die Zeiten in der Spalte „t“ steigen nicht von Zeile zu Zeile; korrigieren Sie sie
# The movement is repeated in a loop.
bodydev-file-short = { $file }: { $length } s Bewegung sind zu kurz, um sie immer wieder abzuspielen; nehmen Sie mindestens { $least } s
bodydev-file-slow = { $file }: eine Bewegung braucht mindestens { $least } Zeilen pro Sekunde; zeichnen Sie sie neu auf
bodydev-file-uneven = { $file }: die Zeiten in der Spalte „t“ sind zu ungleichmäßig; zeichnen Sie die Bewegung ohne lange Lücken neu auf
