### Texts about 3D objects (GLB files) and about the 3D view of a drive.

## An object that is refused. Most messages are the second half of object-unusable, without a full stop.

# reason: what the operating system says of it, in its own language.
object-file-unreadable = { $file }: diese Datei lässt sich nicht lesen ({ $reason }); prüfen Sie sie
object-unusable = { $file }: dieses Objekt lässt sich nicht verwenden, denn { $problem }
object-not-scaled = { $file }: die Größe dieses Objekts lässt sich nicht sicher ändern; exportieren Sie es in Metern
object-improbable = { $file }: nach eigener Angabe ist dieses Objekt { NUMBER($length, useGrouping: 1) } × { NUMBER($width, useGrouping: 1) } × { NUMBER($height, useGrouping: 1) } m groß, was unwahrscheinlich ist; wählen Sie seine Größe, oder exportieren Sie es in Metern.
object-no-glb = es ist keine GLB-Datei; exportieren Sie das Objekt als glTF binär (.glb)
object-version = es hat die glTF-Version { $version }; exportieren Sie es als Version 2
object-cut-off = es ist abgeschnitten oder beschädigt; exportieren Sie es noch einmal
object-damaged = es ist beschädigt; exportieren Sie es noch einmal
object-no-description = seine Beschreibung ist nicht lesbar; exportieren Sie es noch einmal
object-parts-missing = es verweist auf Teile, die nicht darin enthalten sind; exportieren Sie es noch einmal
object-lists-end = seine Listen reichen über seine Daten hinaus; exportieren Sie es noch einmal
object-no-tree = seine Teile bilden keinen Baum; exportieren Sie es noch einmal
object-nested = seine Teile sind mehr als { $most }-fach verschachtelt; exportieren Sie es noch einmal
object-far = einige seiner Punkte liegen im Unendlichen oder zu weit weg; exportieren Sie es noch einmal
object-size-unknown = seine Größe lässt sich nicht sicher ermitteln; exportieren Sie es noch einmal, ohne Animation und Komprimierung
object-large = es ist größer als { $most } MB; vereinfachen Sie das Objekt
object-memory = es braucht zu viel Arbeitsspeicher; vereinfachen Sie das Objekt
object-faces = es hat { NUMBER($count, useGrouping: 1) } Flächen, und höchstens { NUMBER($most, useGrouping: 1) } werden gezeichnet; vereinfachen Sie das Objekt
object-points = es hat { NUMBER($count, useGrouping: 1) } Punkte, und höchstens { NUMBER($most, useGrouping: 1) } werden gelesen; vereinfachen Sie das Objekt
object-nodes = es hat mehr als { NUMBER($most, useGrouping: 1) } Knoten; verbinden Sie sie vor dem Export
object-long-list = es hat Listen mit mehr als { NUMBER($most, useGrouping: 1) } Zahlen; vereinfachen Sie das Objekt
object-numbers = seine Listen haben mehr als { NUMBER($most, useGrouping: 1) } Zahlen; vereinfachen Sie das Objekt
object-targets = es hat mehr als { $most } Morph-Ziele; exportieren Sie es in einer einzigen Form
object-without-faces = es enthält nichts, was Flächen hat; exportieren Sie einen festen Körper
# name: of an extension of glTF, not translated.
object-extension = es braucht „{ $name }“, und das wird hier nicht gelesen; exportieren Sie es ohne Komprimierung und Erweiterungen
object-instances = es braucht „{ $name }“, und das wird hier nicht gelesen; exportieren Sie es ohne Instanzen
object-compressed = es ist komprimiert; exportieren Sie es ohne Komprimierung
object-draco = es ist mit Draco komprimiert; exportieren Sie es ohne Komprimierung
object-other-files = es braucht andere Dateien; exportieren Sie alles in eine einzige GLB-Datei
# A buffer is a part of a GLB file.
object-picture-elsewhere = seine Bilder liegen in einem anderen Puffer; exportieren Sie es noch einmal
object-picture-size = ein Bild darauf ist { NUMBER($width, useGrouping: 1) } × { NUMBER($height, useGrouping: 1) } Pixel groß, und höchstens { NUMBER($most, useGrouping: 1) } Pixel werden gelesen; verkleinern Sie es
object-picture-pixels = ein Bild darauf hat mehr als { NUMBER($most, useGrouping: 1) } Pixel; verkleinern Sie es
object-pictures-in-all = seine Bilder haben zusammen mehr als { NUMBER($most, useGrouping: 1) } Pixel; verwenden Sie weniger Bilder
object-picture-damaged = ein Bild darauf ist beschädigt; exportieren Sie es noch einmal
object-picture-unreadable = ein Bild darauf ist weder PNG noch JPEG, oder es ist beschädigt; exportieren Sie es noch einmal

## The 3D view

# The heading of a small panel beside the view, and of its two diagrams; m: metres.
object-plots = Diagramme
object-plot-driven = Fahrspur über der Strecke, m
object-plot-error = Abstand zur Strecke in 30 s, m
object-port-closed = Dieser Port ist nur für das Programm selbst. Öffnen Sie seine eigenen Seiten.
# viser: the library that draws the view.
object-viser-port = viser hat einen Port geöffnet, den alle lesen können; installieren Sie viser 1.1.1
object-viser-page = { $file }: das ist nicht die Seite von viser 1.1.1; installieren Sie diese Version
