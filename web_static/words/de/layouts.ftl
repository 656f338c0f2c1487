### Texte der Seite der Layouts: welche Sensoren ein Shirt hat, wo sie sitzen, ihre Gelenke; der Editor.

rail-layouts = Layouts
layouts-lead = Ein Layout sagt, welche Sensoren ein Shirt hat, wo am Körper jeder sitzt und zu welchem Gelenk er gehört.
layouts-card = Layout
# $name: of the layout; $count: of its sensors.
layouts-card-now =
    { $count ->
        [one] { $name }, { $count } Sensor
       *[other] { $name }, { $count } Sensoren
    }
layouts-own = Eigene Layouts
layouts-none = Noch keine. Legen Sie ein neues an, oder duplizieren Sie eines von unten.
layouts-bundled = Mitgelieferte Layouts
# $channels: how many sensors; $joints: how many joints.
layouts-counts = Sensoren: { $channels } · Gelenke: { $joints }
layouts-channels =
    { $count ->
        [one] { $count } Sensor
       *[other] { $count } Sensoren
    }
# Marks a layout that the shirt has.
layouts-use-same = In Gebrauch
layouts-use-changed = In Gebrauch, wie es vor der letzten Änderung war
layouts-use = Verwenden
layouts-use-label = Verwenden: „{ $name }“
layouts-used = Das Shirt hat jetzt das Layout „{ $name }“.
layouts-use-no-shirt = Es wird kein Shirt verwendet. Wählen Sie eines auf der Seite „Shirt“.
layouts-use-own = Das verwendete Shirt hat ein eigenes Layout, das bleibt, wie es ist.
layouts-edit = Bearbeiten
layouts-edit-label = Bearbeiten: „{ $name }“
layouts-duplicate = Duplizieren
layouts-duplicate-label = Duplizieren: „{ $name }“
layouts-copy = Kopie von { $name }
layouts-export = Exportieren
layouts-export-label = Exportieren: „{ $name }“
layouts-delete-label = „{ $name }“ löschen
layouts-deleted = „{ $name }“ wurde gelöscht.
layouts-gone = Dieses Layout gibt es nicht. Es wurde gelöscht, oder die Adresse ist falsch.
layouts-new = Neues Layout
layouts-new-source = Woher die Sensoren kommen
layouts-from-stream = Das verwendete Shirt
layouts-from-stream-hint = Seine Sensoren, wie sie jetzt ankommen.
layouts-from-file = Eine Datei mit Signalen
layouts-from-file-hint = Ihre Spalten. Gelenke werden danach vorgeschlagen, was sich gemeinsam bewegt.
layouts-from-count = Eine Anzahl von Sensoren
layouts-from-count-hint = Für ein Shirt, das sendet und dessen Sensoren noch niemand benannt hat.
layouts-from-import = Eine Datei mit einem Layout
layouts-from-import-hint = Eine JSON-Datei, wie der Export sie schreibt.
layouts-no-file = Hier ist keine Datei mit Signalen. Wählen Sie auf der Seite „Shirt“ die „Wiedergabe einer Datei“, und fügen Sie eine hinzu.
layouts-count = Sensoren
layouts-import-file = Datei
layouts-import-wrong = { $file }: Das ist kein Layout. Wählen Sie eine JSON-Datei mit den Sensoren eines Shirts.
layouts-name = Name des Layouts
layouts-new-name-hint = Bleibt das Feld leer, erhält es von selbst einen Namen.
layouts-new-go = Anlegen
layouts-whole = Ganzer Körper
# The name of a joint until somebody names it; $number from 1.
layouts-group = Gruppe { $number }

## Der Editor

layouts-edit-title = Layout: { $name }
layouts-lead-live = Bewegen Sie einen Sensor: Er leuchtet in der Liste und am Körper auf. Wählen Sie ihn, und tippen Sie dann auf seine Stelle.
# $arriving, $count: how many sensors.
layouts-lead-not-live = Hier leuchtet nichts auf: Jetzt kommen { $arriving } Sensoren an, und dieses Layout hat { $count }.
layouts-body = Am Körper
layouts-body-hint = Tippen, ziehen oder Pfeiltasten.
# The chosen sensor on the body, for a screen reader.
layouts-mark-label = Stelle von { $name }
layouts-list = Sensoren in der Reihenfolge, in der sie ankommen
# A row of the list: joint and place of a sensor.
layouts-row = { $joint } · { $place }
layouts-moves = bewegt sich gerade
layouts-channel-name = Name des Sensors
layouts-channel-name-hint = Buchstaben ohne Umlaute, Ziffern und _ . -
layouts-joint = Gelenk
layouts-joint-hint = Sensoren eines Gelenks werden gemeinsam kalibriert.
layouts-joints-here = In diesem Layout
layouts-joints-more = Andere
layouts-joint-other = Ein anderes …
# The name of a joint until somebody names it.
layouts-joint-new = Neues Gelenk
# $side: Front or Back; $part: of the body.
layouts-place = { $side }: { $part }
layouts-place-none = Noch nicht am Körper
layouts-place-take = Vom Körper nehmen
layouts-side = Seite des Körpers
layouts-part-head = Kopf
layouts-part-chest = Brust
layouts-part-belly = Bauch
layouts-part-upper-back = oberer Rücken
layouts-part-lower-back = unterer Rücken
layouts-part-right-shoulder = rechte Schulter
layouts-part-right-upper-arm = rechter Oberarm
layouts-part-right-elbow = rechter Ellbogen
layouts-part-right-forearm = rechter Unterarm
layouts-part-right-wrist = rechtes Handgelenk
layouts-part-right-hand = rechte Hand
layouts-part-left-shoulder = linke Schulter
layouts-part-left-upper-arm = linker Oberarm
layouts-part-left-elbow = linker Ellbogen
layouts-part-left-forearm = linker Unterarm
layouts-part-left-wrist = linkes Handgelenk
layouts-part-left-hand = linke Hand
layouts-ring = Einer von einem Ring um Arm oder Bein
layouts-ring-hint = Sensoren eines Gelenks, die um Arm oder Bein liegen. Sie zeigen, wenn ein Ärmel verdreht angezogen wurde.
layouts-ring-name = Name des Rings
layouts-ring-place = Der wievielte, um Arm oder Bein gezählt
# $ring: its name; $count: how many sensors it has.
layouts-ring-places =
    { $count ->
        [one] Der Sensor des Rings „{ $ring }“ ist der einzige darin: Er hat die Nummer 1 oder keine.
       *[other] Die Sensoren des Rings „{ $ring }“ werden von 1 bis { $count } gezählt, jede Nummer einmal, oder keiner von ihnen hat eine Nummer.
    }
layouts-joints = Gelenke
layouts-joint-row-label = Welches Gelenk ist „{ $joint }“
layouts-joint-name-label = Name von „{ $joint }“
layouts-propose = Gelenke vorschlagen
layouts-propose-hint = Jemand bewegt { $seconds } Sekunden lang frei alle Gelenke, eines nach dem anderen. Sensoren, die sich gemeinsam bewegen, kommen in eine Gruppe.
layouts-propose-move = Jetzt bewegen: alle Gelenke, eines nach dem anderen.
layouts-propose-not-live = Gelenke lassen sich vorschlagen, während ein Shirt mit gleich vielen Sensoren sendet.
# $names: of sensors.
layouts-propose-still = Nicht bewegt: { $names }.
layouts-propose-use = Diese Gruppen verwenden
layouts-unsaved = Es gibt Änderungen, die nicht gespeichert sind.
layouts-calibrations = Eine Kalibrierung behält das Layout, in dem sie gemacht wurde. Kalibrieren Sie neu, um andere Gelenke zu verwenden.
layouts-save = Speichern
layouts-saved = „{ $name }“ wurde gespeichert.
layouts-discard = Änderungen verwerfen
layouts-back = Alle Layouts
