### The program itself: its processes, its machine, and what is read from files in a process of their own.

## The processes

realtime-granted = Die Regelschleife läuft mit Echtzeit-Priorität.
realtime-refused = Die Echtzeit-Priorität wurde nicht gewährt. Schließen Sie beim Fahren andere Programme.
realtime-memory-refused = Der Arbeitsspeicher ist nicht gegen Auslagern gesichert. Wenn er auf diesem Rechner knapp wird, kann sich die Regelschleife verspäten.
realtime-memory-locked = Der Arbeitsspeicher der Regelschleife ist gegen Auslagern gesichert.
computing-ended = Der Prozess, der Werte berechnet, wurde beendet. Versuchen Sie es noch einmal.
computing-too-long = Diese Berechnung dauerte länger als { $limit } s. Schließen Sie andere Programme, und versuchen Sie es dann noch einmal.
python-faulty = Python { $version } hat bekannte Fehler beim Lesen von zip- und tar-Dateien. Importieren Sie kein Archiv unbekannter Herkunft, stellen Sie kein solches Backup wieder her, und installieren Sie Python { $least } oder neuer.
network-page-first = Ein Gerät, das vor dem Zertifikat warnt, öffnet zuerst { $page }. Die Seite dort erklärt, was zu tun ist.

## What is wrong with a file: the end of a sentence that begins with the file's name.

reading-failed = diese Datei ist nicht lesbar, oder das Lesen dauert zu lange; speichern Sie sie neu, oder verkleinern Sie sie
reading-too-long = das Lesen dieser Datei dauert zu lange; verkleinern Sie sie, und fügen Sie sie dann noch einmal hinzu
reading-memory = das braucht zu viel Arbeitsspeicher; verkleinern Sie die Datei

## Names

names-two-scripts = In „{ $word }“ stehen Buchstaben aus zwei Schriften beieinander. Schreiben Sie alles in einer Schrift.
names-code-taken = Es gibt schon einen Patienten mit dem Code „{ $other }“, und „{ $name }“ sieht genauso aus. Wählen Sie einen anderen Code.
names-file-taken = Es gibt schon eine Datei oder einen Grundriss „{ $other }“, und „{ $name }“ sieht genauso aus. Wählen Sie einen anderen Namen.
names-person-taken = Es gibt schon eine Person mit dem Namen „{ $other }“, und „{ $name }“ sieht genauso aus. Wählen Sie einen anderen Namen.

## The source of a recording: "Simulated shirt (simulated person), virtual chair: practice only"

source-shirt-simulator = Simuliertes Shirt
source-shirt-replay = Aufgezeichnete Signale
source-shirt-serial = Getragenes Shirt am Kabel
source-shirt-udp = Getragenes Shirt
source-shirt-slimevr = Getragene Tracker
source-shirt-camera = Kamera
source-shirt-phones = Getragene Telefone
source-shirt-bluetooth = Getragene Bluetooth-Sensoren
source-shirt-brainflow = Getragene Platine (BrainFlow)
source-shirt-lsl = Signale über LSL
source-shirt-unknown = Shirt nicht erfasst
source-other-shirt = Shirt der Art „{ $kind }“
source-body-person = simulierte Person
source-body-visitor = auf dem Bildschirm bewegt
source-body-recorded = aufgezeichneter Körper
source-chair-virtual = virtueller Rollstuhl
source-chair-udp = echter Rollstuhl
source-chair-unknown = Rollstuhl nicht erfasst
source-other-chair = Rollstuhl der Art „{ $kind }“
source-with-body = { $shirt } ({ $body })
source-signals = { $shirt }, { $chair }
source-practice-only = { $source }: nur zum Üben

## The layout of a shirt: the end of a sentence that begins with the file or form.

layout-channel-twice = der Kanal „{ $name }“ kommt zweimal vor; geben Sie jedem einen eigenen Namen
layout-joint-twice = das Gelenk „{ $name }“ kommt zweimal vor; geben Sie jedem einen eigenen Namen
layout-no-joint = der Kanal „{ $channel }“ nennt das Gelenk „{ $joint }“, das nicht unter den Gelenken steht; ergänzen Sie es, oder verwenden Sie eines von diesen: { $joints }
layout-no-channel = das Gelenk „{ $joint }“ hat keinen Kanal; geben Sie ihm einen, oder lassen Sie es weg
layout-no-ring = der Kanal „{ $channel }“ hat einen Platz, aber keinen Ring; nennen Sie seinen Ring, oder lassen Sie den Platz weg
layout-ring-of-several = der Ring „{ $ring }“ führt um mehrere Gelenke; geben Sie jedem Gelenk einen eigenen Ring
layout-ring-places =
    { $count ->
        [one] der Ring „{ $ring }“ hat { $count } Sensor, deshalb muss dessen Platz { $last } sein oder fehlen
       *[other] der Ring „{ $ring }“ hat { $count } Sensoren, deshalb müssen ihre Plätze von 0 bis { $last } gehen, jeder einmal, oder bei allen fehlen
    }
