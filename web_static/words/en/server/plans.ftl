### Texts about floor plans, scenes and their tasks, and about the import of floor plans from maps, drawings and
### pictures. Many begin with the name of a file; many stand after the name of a file and a colon, without a full stop.

## Files

plan-file-missing = { $file }: there is no such file, check its name
# reason: what the operating system says of it, in its own language.
plan-file-unreadable = { $file }: this file cannot be read ({ $reason }), check it
plan-file-large = { $file }: this is larger than { $most } MB and no floor plan, name another
plan-file-memory = { $file }: this needs too much memory, make it smaller
# kinds: endings of file names.
plan-file-of-no-kind = { $file }: this is no { $kinds } file, name another
# The place of a problem, in front of a comma or a colon and the problem.
plan-the-import = the import

## Floor plans

plan-path-not-finite = a point of the line is not a finite number: correct it
plan-path-too-short = a line needs at least two different points: add one
plan-path-twice = path '{ $path }' stands there twice: give each its own name
plan-path-unknown = floor plan '{ $plan }' has no path '{ $path }': use one of { $names }
plan-mover-twice = mover '{ $mover }' stands there twice: give each its own name
# A mover is a person, a chair or a ball that moves along a line. Its pace is a list of times and speeds.
plan-mover-pace = mover '{ $mover }': the times of its pace begin with 0 and grow: correct them
plan-walls-too-many =
    its walls have { NUMBER($count, useGrouping: 1) } pieces, and at most { NUMBER($most, useGrouping: 1) } are taken: draw fewer of them
plan-points-too-many =
    its paths and movers have too many points ({ NUMBER($count, useGrouping: 1) }, and at most { NUMBER($most, useGrouping: 1) } are taken): draw them with fewer
# movers: a field of the document, not translated.
plan-leader-without-movers = path '{ $path }': there is no mover '{ $leader }' to follow: add it to movers
plan-leader-unknown = path '{ $path }': there is no mover '{ $leader }' to follow: use one of { $names }
# A line on the floor, at the beginning of the sentences below.
plan-line-path = path '{ $path }'
plan-line-stage = path '{ $path }', '{ $stage }'
plan-line-mover = mover '{ $mover }'
plan-line-problem = { $line }: { $problem }
plan-near-wall = { $line } comes within { $distance } m of a wall near ({ $x }, { $y }), and { $radius } m are needed on each side: move the line or the wall
plan-near-obstacle = { $line } comes within { $distance } m of the obstacle '{ $label }' near ({ $x }, { $y }), and { $radius } m are needed on each side: move the line or the obstacle
plan-near-cone = { $line } comes within { $distance } m of the obstacle 'cone { $number }' near ({ $x }, { $y }), and { $radius } m are needed on each side: move the line or the obstacle
plan-dunes-without-area = dunes lie around an area: give the ground its area
# area, x_min, y_min, x_max, y_max: fields of the document, not translated.
plan-area-order = area is x_min, y_min, x_max, y_max, the smaller ones first: correct it
plan-dune-inside = dune { $number } reaches into the area that is driven on: move it out

## Scenes: floor plans with tasks, some at several levels of difficulty. Names of fields and levels are not translated.

plan-scene-large = { $file }: this is larger than { $most } MB and no scene, name another
plan-scene-no-json = { $file }: this is not JSON, correct it ({ $problem })
plan-scene-no-object = { $file }: this is not a scene, begin it with {"{"}
plan-scene-no-plan = { $file }, floorplan: there is no floor plan '{ $plan }', use one of { $names }
plan-scene-level-twice = { $file }, levels: a level stands there twice, leave one out
# The place of a problem, in front of a comma and the problem.
plan-scene-level = { $file }, level { $level }
plan-scene-problem = { $where }, { $problem }
plan-scene-too-deep = { $place }...: a scene is not nested so deeply, correct it
plan-scene-one-value = { $place }: without levels give one value
plan-scene-value-missing = { $place }: there is no value for level { $level }, add it
plan-scene-level-unknown = { $place }: the scene has no level { $level }, add it to levels or leave it out

## Import: titles in the new plan, and what was done

plan-path-proposed = Across the building
plan-path-drawn = Path { $number }
plan-path-instruction = Follow the white line to its end.
plan-path-is-proposal = The path is a proposal: change it as you like.
plan-wall-pieces =
    { $count ->
        [one] { NUMBER($count, useGrouping: 1) } wall piece.
       *[other] { NUMBER($count, useGrouping: 1) } wall pieces.
    }

## Import of drawings (DXF). $unit: a text plan-unit; $units: mm, cm, m, inch, foot.

plan-unit =
    { $unit ->
        [inch] inches
        [foot] feet
       *[other] { $unit }
    }

plan-drawing-empty = { $file }: there are no lines in this drawing (on the chosen layers), choose others
plan-drawing-walls-too-many = { $file }: this drawing has { NUMBER($count, useGrouping: 1) } wall pieces and at most { NUMBER($most, useGrouping: 1) } are taken, choose fewer layers
plan-layer-unknown = { $file }: there is no layer '{ $layer }' with lines, use some of these: { $names }
# In place of the names of layers in the sentence above.
plan-no-layers = none
plan-drawing-improbable =
    { $file }: in { $unit }, as it says, this drawing is { NUMBER($width, useGrouping: 1, minimumFractionDigits: 1, maximumFractionDigits: 1) } x { NUMBER($height, useGrouping: 1, minimumFractionDigits: 1, maximumFractionDigits: 1) } m large, which is improbable for a storey, give its unit, or remove what lies far from the building
# sizes: a list of plan-size-in-unit.
plan-drawing-improbable-unit =
    { $file }: in { $unit }, as it says, this drawing is { NUMBER($width, useGrouping: 1, minimumFractionDigits: 1, maximumFractionDigits: 1) } x { NUMBER($height, useGrouping: 1, minimumFractionDigits: 1, maximumFractionDigits: 1) } m large, which is improbable for a storey, give its unit ({ $sizes }), or remove what lies far from the building
plan-size-in-unit = { $width } x { $height } m in { $unit }
plan-drawing-size-given = The drawing is { $width } x { $height } m large, as given, in { $unit }.
plan-drawing-size = The drawing is { $width } x { $height } m large, in { $unit } as it says.
plan-drawing-size-units = The drawing is { $width } x { $height } m large, in { $unit } as it says ({ $sizes }).
plan-drawing-wide = { $file }: this drawing is { NUMBER($width, useGrouping: 1) } x { NUMBER($height, useGrouping: 1) } m large, give its unit, or remove what lies far from the building
plan-drawing-small = { $file }: this drawing is only { $width } x { $height } m large, give its unit
# PATH: the name of a layer, not translated.
plan-drawing-paths =
    { $count ->
        [one] The path is that of the layer PATH.
       *[other] { $count } paths are from the layer PATH.
    }
plan-drawing-without-path = A chair fits nowhere, so there is no path yet: draw one, or check the unit.
# names: a list of plan-counted.
plan-drawing-layers-out = Left out by the names of their layers, which can be chosen: { $names }.
plan-drawing-hidden = On layers that are off or frozen: { $names }.
plan-drawing-files = In other files, bind them to the drawing to have them: { $names }.
# names: a list of plan-left-out.
plan-drawing-left-out = Not taken over: { $names }.
plan-counted = { $count } { $name }
plan-counted-more = { $count } more
# Things in a drawing that are not read; any other name is a kind of thing in DXF, such as SPLINE.
plan-left-out =
    { $name ->
        [invisible] { $count ->
            [one] { $count } invisible thing
           *[other] { $count } invisible things
        }
        [texts] { $count ->
            [one] { $count } text or dimension
           *[other] { $count } texts and dimensions
        }
        [missing-blocks] { $count ->
            [one] { $count } missing block
           *[other] { $count } missing blocks
        }
        [clipped-blocks] { $count ->
            [one] { $count } clipped block, which is read whole
           *[other] { $count } clipped blocks, which are read whole
        }
       *[other] { $count } { $name }
    }
plan-drawing-damaged = { $file }: something in this drawing is damaged, save it again as DXF
plan-drawing-large = { $file }: this is larger than { $most } MB, draw only what stands in the building
plan-drawing-dwg = { $file }: this is a DWG drawing, save it as DXF
plan-drawing-no-dxf = { $file }: this is no DXF drawing that can be read, save it again as DXF
plan-drawing-without-unit = { $file }: this drawing does not say in which unit it is drawn, give its unit ({ $units })
plan-drawing-too-much = { $file }: this has more than { NUMBER($most, useGrouping: 1) } things in it, draw only the walls
plan-drawing-lines-too-many = { $file }: this has more than { NUMBER($most, useGrouping: 1) } lines in it, draw only the walls
plan-drawing-blocks-deep = { $file }: its blocks lie in each other more than { $most } deep, explode them
plan-drawing-block-often = { $file }: a block stands there { NUMBER($count, useGrouping: 1) } times, draw only the walls
plan-drawing-far = { $file }: something on layer '{ $layer }' lies very far away, remove it

## Import of pictures

plan-picture-threshold = { $file }: the threshold (“{ import-threshold }”) lies between 0 (black) and 1 (white), correct it
plan-picture-without-scale = { $file }: a picture has no scale, give either metres per pixel or its width in m
plan-picture-size = { $file }: with this scale the picture is { $width } x { $height } m large, correct it
plan-picture-dark = { $file }: nothing in this picture is as light as the threshold (“{ import-threshold }”), lower it
plan-picture-coarse = { $file }: one cell would be { $size } m, and doorways would be lost, show a smaller part
plan-picture-large = { $file }: this is larger than { $most } MB, make it coarser
plan-picture-pixels = { $file }: this picture has more than { NUMBER($most, useGrouping: 1) } pixels, make it coarser
plan-picture-no-picture = { $file }: this is no PNG or JPEG picture that can be read, save it anew
plan-picture-damaged = { $file }: this picture is damaged, save it anew
plan-picture-unreadable = { $file }: this picture cannot be read ({ $reason }), save it anew

## Import of maps of robots (ROS) and, with the noun “picture”, of pictures. A map is divided into cells.

plan-map-no-building =
    { $noun ->
        [map] { $file }: all that is free in this map is connected to its edge, so that it shows no building, choose “{ import-outside }” (--outside)
       *[picture] { $file }: all that is free in this picture is connected to its edge, so that it shows no building, choose “{ import-outside }” (--outside)
    }
plan-map-walls-too-many =
    { $noun ->
        [map] { $file }: this map has { NUMBER($count, useGrouping: 1) } wall pieces when it is made as simple as it can be, and at most { NUMBER($most, useGrouping: 1) } are taken, keep about { $share } % of it and paint the rest as wall, or paint over speckles and furniture
       *[picture] { $file }: this picture has { NUMBER($count, useGrouping: 1) } wall pieces when it is made as simple as it can be, and at most { NUMBER($most, useGrouping: 1) } are taken, keep about { $share } % of it and paint the rest as wall, or paint over speckles and furniture
    }
plan-map-too-narrow =
    { $noun ->
        [map] { $file }: a chair fits nowhere in this map, check its resolution and thresholds
       *[picture] { $file }: a chair fits nowhere in this picture, check its scale and the threshold (“{ import-threshold }”)
    }
plan-map-size =
    { $noun ->
        [map] The plan is { $width } x { $height } m large, with { $free } m² free; the whole map is { $whole_width } x { $whole_height } m.
       *[picture] The plan is { $width } x { $height } m large, with { $free } m² free; the whole picture is { $whole_width } x { $whole_height } m.
    }
plan-map-unknown = { $area } m² of the map are unknown and count as wall.
plan-map-open = The building is open to the outside: its openings of up to { $width } m are closed in the plan.
plan-map-narrow-closed = There were too many wall pieces: spaces narrower than { $width } m are closed.
plan-map-cells-joined = { $side } x { $side } cells are joined to cells of { $size } m; walls may be thicker by that.
# mode, negate, free_thresh, occupied_thresh, image, resolution, origin: fields of a map's document, not translated.
plan-map-nothing-free = { $file }: no pixel is free, check mode, negate, free_thresh and occupied_thresh in { $document }
plan-map-alias = { $file }: a map's document has no aliases (*name), write the values themselves
plan-map-no-yaml = { $file }: this is not a YAML document, name the .yaml file of a map_server map
plan-map-no-document = { $file }: this is not a map's document (image, resolution, origin), name another file
plan-map-image-missing = { $file }: there is no such image, put it beside { $document }
plan-map-no-image = { $file }: this is not an image (PGM or PNG) that can be read, save it anew
plan-map-image-unreadable = { $file }: this image cannot be read ({ $reason }), save it anew
plan-map-image-pixels = { $file }: this image has more than { NUMBER($most, useGrouping: 1) } pixels, make it coarser
