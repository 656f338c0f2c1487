### Texts about floor plans, scenes and their tasks, and about the import of floor plans from maps, drawings and
### pictures. Many begin with the name of a file; many stand after the name of a file and a colon, without a full stop.

## Files

plan-file-missing = { $file }: diese Datei gibt es nicht; prüfen Sie ihren Namen
# reason: what the operating system says of it, in its own language.
plan-file-unreadable = { $file }: diese Datei lässt sich nicht lesen ({ $reason }); prüfen Sie sie
plan-file-large = { $file }: das ist größer als { $most } MB und kein Grundriss; nennen Sie eine andere Datei
plan-file-memory = { $file }: das braucht zu viel Arbeitsspeicher; verkleinern Sie die Datei
# kinds: endings of file names.
plan-file-of-no-kind = { $file }: diese Art von Datei lässt sich nicht importieren; nennen Sie eine mit einer dieser Endungen: { $kinds }
# The place of a problem, in front of a comma or a colon and the problem.
plan-the-import = Import

## Floor plans

plan-path-not-finite = ein Punkt der Linie ist keine endliche Zahl; korrigieren Sie ihn
plan-path-too-short = eine Linie braucht mindestens zwei verschiedene Punkte; ergänzen Sie einen
plan-path-twice = die Strecke „{ $path }“ kommt zweimal vor; geben Sie jeder einen eigenen Namen
plan-path-unknown = der Grundriss „{ $plan }“ hat keine Strecke „{ $path }“; verwenden Sie eine von diesen: { $names }
plan-mover-twice = das bewegte Objekt „{ $mover }“ kommt zweimal vor; geben Sie jedem einen eigenen Namen
# A mover is a person, a chair or a ball that moves along a line. Its pace is a list of times and speeds.
plan-mover-pace = bewegtes Objekt „{ $mover }“: die Zeiten seines Tempos müssen mit 0 beginnen und steigen; korrigieren Sie sie
plan-walls-too-many =
    die Wände bestehen aus { NUMBER($count, useGrouping: 1) } Stücken, höchstens { NUMBER($most, useGrouping: 1) } sind möglich; zeichnen Sie weniger davon
plan-points-too-many =
    die Strecken und bewegten Objekte haben zu viele Punkte ({ NUMBER($count, useGrouping: 1) }, höchstens { NUMBER($most, useGrouping: 1) } sind möglich); zeichnen Sie sie mit weniger Punkten
# movers: a field of the document, not translated.
plan-leader-without-movers = Strecke „{ $path }“: es gibt kein bewegtes Objekt „{ $leader }“, dem der Rollstuhl folgen könnte; ergänzen Sie es in movers
plan-leader-unknown = Strecke „{ $path }“: es gibt kein bewegtes Objekt „{ $leader }“, dem der Rollstuhl folgen könnte; verwenden Sie eines von diesen: { $names }
# A line on the floor, at the beginning of the sentences below.
plan-line-path = Strecke „{ $path }“
plan-line-stage = Strecke „{ $path }“, „{ $stage }“
plan-line-mover = bewegtes Objekt „{ $mover }“
plan-line-problem = { $line }: { $problem }
plan-near-wall = { $line }: bei ({ $x }; { $y }) beträgt der Abstand zu einer Wand nur { $distance } m, nötig sind { $radius } m auf jeder Seite; verschieben Sie die Linie oder die Wand
plan-near-obstacle = { $line }: bei ({ $x }; { $y }) beträgt der Abstand zum Hindernis „{ $label }“ nur { $distance } m, nötig sind { $radius } m auf jeder Seite; verschieben Sie die Linie oder das Hindernis
plan-near-cone = { $line }: bei ({ $x }; { $y }) beträgt der Abstand zum Hindernis „Kegel { $number }“ nur { $distance } m, nötig sind { $radius } m auf jeder Seite; verschieben Sie die Linie oder das Hindernis
plan-dunes-without-area = Dünen liegen um eine Fläche herum; geben Sie dem Boden seine Fläche
# area, x_min, y_min, x_max, y_max: fields of the document, not translated.
plan-area-order = area besteht aus x_min, y_min, x_max, y_max, die kleineren Werte zuerst; korrigieren Sie es
plan-dune-inside = Düne { $number } reicht in die Fläche hinein, auf der gefahren wird; verschieben Sie sie nach außen

## Scenes: floor plans with tasks, some at several levels of difficulty. Names of fields and levels are not translated.

plan-scene-large = { $file }: das ist größer als { $most } MB und keine Szene; nennen Sie eine andere Datei
plan-scene-no-json = { $file }: das ist kein JSON; korrigieren Sie es ({ $problem })
plan-scene-no-object = { $file }: das ist keine Szene; beginnen Sie sie mit {"{"}
plan-scene-no-plan = { $file }, floorplan: es gibt keinen Grundriss „{ $plan }“; verwenden Sie einen von diesen: { $names }
plan-scene-level-twice = { $file }, levels: eine Stufe kommt zweimal vor; lassen Sie eine davon weg
# The place of a problem, in front of a comma and the problem.
plan-scene-level = { $file }, Stufe { $level }
plan-scene-problem = { $where }, { $problem }
plan-scene-too-deep = { $place }...: so tief darf eine Szene nicht verschachtelt sein; korrigieren Sie sie
plan-scene-one-value = { $place }: ohne Stufen ist nur ein Wert möglich; geben Sie einen an
plan-scene-value-missing = { $place }: für die Stufe { $level } fehlt ein Wert; ergänzen Sie ihn
plan-scene-level-unknown = { $place }: die Szene hat keine Stufe { $level }; ergänzen Sie sie in levels, oder lassen Sie sie weg

## Import: titles in the new plan, and what was done

plan-path-proposed = Durch das Gebäude
plan-path-drawn = Strecke { $number }
plan-path-instruction = Folgen Sie der weißen Linie bis zum Ende.
plan-path-is-proposal = Die Strecke ist ein Vorschlag: Ändern Sie sie nach Belieben.
plan-wall-pieces =
    { $count ->
        [one] { NUMBER($count, useGrouping: 1) } Wandstück.
       *[other] { NUMBER($count, useGrouping: 1) } Wandstücke.
    }

## Import of drawings (DXF). $unit: a text plan-unit; $units: mm, cm, m, inch, foot.

plan-unit =
    { $unit ->
        [inch] Zoll
        [foot] Fuß
       *[other] { $unit }
    }

plan-drawing-empty = { $file }: in dieser Zeichnung gibt es (auf den gewählten Ebenen) keine Linien; wählen Sie andere Ebenen
plan-drawing-walls-too-many = { $file }: diese Zeichnung hat { NUMBER($count, useGrouping: 1) } Wandstücke, höchstens { NUMBER($most, useGrouping: 1) } sind möglich; wählen Sie weniger Ebenen
plan-layer-unknown = { $file }: es gibt keine Ebene „{ $layer }“ mit Linien; zur Wahl stehen: { $names }
# In place of the names of layers in the sentence above.
plan-no-layers = keine
plan-drawing-improbable =
    { $file }: nach eigener Angabe ist diese Zeichnung in { $unit } gezeichnet und damit { NUMBER($width, useGrouping: 1, minimumFractionDigits: 1, maximumFractionDigits: 1) } × { NUMBER($height, useGrouping: 1, minimumFractionDigits: 1, maximumFractionDigits: 1) } m groß, was für ein Stockwerk unwahrscheinlich ist; geben Sie ihre Einheit an, oder entfernen Sie, was weit vom Gebäude entfernt liegt
# sizes: a list of plan-size-in-unit.
plan-drawing-improbable-unit =
    { $file }: nach eigener Angabe ist diese Zeichnung in { $unit } gezeichnet und damit { NUMBER($width, useGrouping: 1, minimumFractionDigits: 1, maximumFractionDigits: 1) } × { NUMBER($height, useGrouping: 1, minimumFractionDigits: 1, maximumFractionDigits: 1) } m groß, was für ein Stockwerk unwahrscheinlich ist; geben Sie ihre Einheit an ({ $sizes }), oder entfernen Sie, was weit vom Gebäude entfernt liegt
plan-size-in-unit = { $width } × { $height } m bei Einheit { $unit }
plan-drawing-size-given = Die Zeichnung ist { $width } × { $height } m groß, wie angegeben in { $unit }.
plan-drawing-size = Die Zeichnung ist { $width } × { $height } m groß, nach eigener Angabe in { $unit }.
plan-drawing-size-units = Die Zeichnung ist { $width } × { $height } m groß, nach eigener Angabe in { $unit } ({ $sizes }).
plan-drawing-wide = { $file }: diese Zeichnung ist { NUMBER($width, useGrouping: 1) } × { NUMBER($height, useGrouping: 1) } m groß; geben Sie ihre Einheit an, oder entfernen Sie, was weit vom Gebäude entfernt liegt
plan-drawing-small = { $file }: diese Zeichnung ist nur { $width } × { $height } m groß; geben Sie ihre Einheit an
# PATH: the name of a layer, not translated.
plan-drawing-paths =
    { $count ->
        [one] Die Strecke stammt von der Ebene PATH.
       *[other] { $count } Strecken stammen von der Ebene PATH.
    }
plan-drawing-without-path = Ein Rollstuhl passt nirgends hinein, deshalb gibt es noch keine Strecke: Zeichnen Sie eine, oder prüfen Sie die Einheit.
# names: a list of plan-counted.
plan-drawing-layers-out = Ausgelassen wegen der Namen ihrer Ebenen, die sich aber wählen lassen: { $names }.
plan-drawing-hidden = Auf ausgeschalteten oder gefrorenen Ebenen: { $names }.
plan-drawing-files = In anderen Dateien, die zum Übernehmen in die Zeichnung eingebunden sein müssen: { $names }.
# names: a list of plan-left-out.
plan-drawing-left-out = Nicht übernommen: { $names }.
plan-counted = { $count } { $name }
plan-counted-more = { $count } weitere
# Things in a drawing that are not read; any other name is a kind of thing in DXF, such as SPLINE.
plan-left-out =
    { $name ->
        [invisible] { $count ->
            [one] { $count } unsichtbares Objekt
           *[other] { $count } unsichtbare Objekte
        }
        [texts] { $count ->
            [one] { $count } Text oder Maß
           *[other] { $count } Texte oder Maße
        }
        [missing-blocks] { $count ->
            [one] { $count } fehlender Block
           *[other] { $count } fehlende Blöcke
        }
        [clipped-blocks] { $count ->
            [one] { $count } zugeschnittener Block (wird ganz gelesen)
           *[other] { $count } zugeschnittene Blöcke (werden ganz gelesen)
        }
       *[other] { $count } { $name }
    }
plan-drawing-damaged = { $file }: in dieser Zeichnung ist etwas beschädigt; speichern Sie sie noch einmal als DXF
plan-drawing-large = { $file }: das ist größer als { $most } MB; zeichnen Sie nur, was im Gebäude steht
plan-drawing-dwg = { $file }: das ist eine DWG-Zeichnung; speichern Sie sie als DXF
plan-drawing-no-dxf = { $file }: das ist keine lesbare DXF-Zeichnung; speichern Sie sie noch einmal als DXF
plan-drawing-without-unit = { $file }: in dieser Zeichnung steht nicht, in welcher Einheit sie gezeichnet ist; geben Sie ihre Einheit an ({ $units })
plan-drawing-too-much = { $file }: das enthält mehr als { NUMBER($most, useGrouping: 1) } Objekte; zeichnen Sie nur die Wände
plan-drawing-lines-too-many = { $file }: das enthält mehr als { NUMBER($most, useGrouping: 1) } Linien; zeichnen Sie nur die Wände
plan-drawing-blocks-deep = { $file }: die Blöcke sind mehr als { $most }-fach ineinander verschachtelt; lösen Sie sie auf
plan-drawing-block-often = { $file }: ein Block kommt { NUMBER($count, useGrouping: 1) }-mal vor; zeichnen Sie nur die Wände
plan-drawing-far = { $file }: auf der Ebene „{ $layer }“ liegt etwas sehr weit weg; entfernen Sie es

## Import of pictures

plan-picture-threshold = { $file }: der Schwellenwert („{ import-threshold }“) muss zwischen 0 (schwarz) und 1 (weiß) liegen; korrigieren Sie ihn
plan-picture-without-scale = { $file }: ein Bild hat keinen Maßstab; geben Sie entweder Meter pro Pixel oder die Breite in m an
plan-picture-size = { $file }: mit diesem Maßstab ist das Bild { $width } × { $height } m groß; korrigieren Sie ihn
plan-picture-dark = { $file }: nichts in diesem Bild ist so hell wie der Schwellenwert („{ import-threshold }“); senken Sie ihn
plan-picture-coarse = { $file }: eine Zelle wäre { $size } m groß, und Türöffnungen gingen verloren; nehmen Sie einen kleineren Ausschnitt
plan-picture-large = { $file }: das ist größer als { $most } MB; verringern Sie die Auflösung
plan-picture-pixels = { $file }: dieses Bild hat mehr als { NUMBER($most, useGrouping: 1) } Pixel; verringern Sie die Auflösung
plan-picture-no-picture = { $file }: das ist kein lesbares PNG- oder JPEG-Bild; speichern Sie es neu
plan-picture-damaged = { $file }: dieses Bild ist beschädigt; speichern Sie es neu
plan-picture-unreadable = { $file }: dieses Bild lässt sich nicht lesen ({ $reason }); speichern Sie es neu

## Import of maps of robots (ROS) and, with the noun “picture”, of pictures. A map is divided into cells.

plan-map-no-building =
    { $noun ->
        [map] { $file }: alles Freie in dieser Karte ist mit ihrem Rand verbunden, so dass kein Gebäude zu erkennen ist; wählen Sie „{ import-outside }“ (--outside)
       *[picture] { $file }: alles Freie in diesem Bild ist mit seinem Rand verbunden, so dass kein Gebäude zu erkennen ist; wählen Sie „{ import-outside }“ (--outside)
    }
plan-map-walls-too-many =
    { $noun ->
        [map] { $file }: diese Karte hat auch in der einfachsten Form { NUMBER($count, useGrouping: 1) } Wandstücke, höchstens { NUMBER($most, useGrouping: 1) } sind möglich; behalten Sie etwa { $share } % davon, und malen Sie den Rest als Wand, oder übermalen Sie Flecken und Möbel
       *[picture] { $file }: dieses Bild hat auch in der einfachsten Form { NUMBER($count, useGrouping: 1) } Wandstücke, höchstens { NUMBER($most, useGrouping: 1) } sind möglich; behalten Sie etwa { $share } % davon, und malen Sie den Rest als Wand, oder übermalen Sie Flecken und Möbel
    }
plan-map-too-narrow =
    { $noun ->
        [map] { $file }: ein Rollstuhl passt in dieser Karte nirgends hinein; prüfen Sie ihre Auflösung und ihre Schwellenwerte
       *[picture] { $file }: ein Rollstuhl passt in diesem Bild nirgends hinein; prüfen Sie seinen Maßstab und den Schwellenwert („{ import-threshold }“)
    }
plan-map-size =
    { $noun ->
        [map] Der Plan ist { $width } × { $height } m groß und hat { $free } m² freie Fläche; die ganze Karte ist { $whole_width } × { $whole_height } m groß.
       *[picture] Der Plan ist { $width } × { $height } m groß und hat { $free } m² freie Fläche; das ganze Bild ist { $whole_width } × { $whole_height } m groß.
    }
plan-map-unknown = { $area } m² der Karte sind unbekannt und zählen als Wand.
plan-map-open = Das Gebäude ist nach außen offen: Im Plan sind seine Öffnungen bis { $width } m Breite geschlossen.
plan-map-narrow-closed = Es waren zu viele Wandstücke: Was schmaler als { $width } m war, ist geschlossen.
plan-map-cells-joined = Je { $side } × { $side } Zellen sind zu Zellen von { $size } m zusammengefasst. Wände können um so viel dicker sein.
# mode, negate, free_thresh, occupied_thresh, image, resolution, origin: fields of a map's document, not translated.
plan-map-nothing-free = { $file }: kein Pixel ist frei; prüfen Sie mode, negate, free_thresh und occupied_thresh in { $document }
plan-map-alias = { $file }: Aliasse (*name) sind im Dokument einer Karte nicht möglich; schreiben Sie die Werte selbst hin
plan-map-no-yaml = { $file }: das ist kein YAML-Dokument; nennen Sie die .yaml-Datei einer Karte für map_server
plan-map-no-document = { $file }: das ist kein Dokument einer Karte (image, resolution, origin); nennen Sie eine andere Datei
plan-map-image-missing = { $file }: dieses Bild gibt es nicht; legen Sie es neben { $document }
plan-map-no-image = { $file }: das ist kein lesbares Bild (PGM oder PNG); speichern Sie es neu
plan-map-image-unreadable = { $file }: dieses Bild lässt sich nicht lesen ({ $reason }); speichern Sie es neu
plan-map-image-pixels = { $file }: dieses Bild hat mehr als { NUMBER($most, useGrouping: 1) } Pixel; verringern Sie die Auflösung
