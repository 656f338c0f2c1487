### Texts about floor plans, scenes and their tasks, and about the import of floor plans from maps, drawings and
### pictures. Many begin with the name of a file; many stand after the name of a file and a colon, without a full stop.

## Files

plan-file-missing = { $file }: no existe este archivo, compruebe su nombre
# reason: what the operating system says of it, in its own language.
plan-file-unreadable = { $file }: este archivo no se puede leer ({ $reason }), compruébelo
plan-file-large = { $file }: esto ocupa más de { $most } MB y no es un plano, indique otro archivo
plan-file-memory = { $file }: esto necesita demasiada memoria, hágalo más pequeño
# kinds: endings of file names.
plan-file-of-no-kind = { $file }: esto no es un archivo de estos tipos ({ $kinds }), indique otro
# The place of a problem, in front of a comma or a colon and the problem.
plan-the-import = la importación

## Floor plans

plan-path-not-finite = un punto de la línea no es un número finito: corríjalo
plan-path-too-short = una línea necesita al menos dos puntos distintos: añada uno
plan-path-twice = el recorrido “{ $path }” aparece dos veces: dé a cada uno su propio nombre
plan-path-unknown = el plano “{ $plan }” no tiene ningún recorrido “{ $path }”: use uno de estos, { $names }
plan-mover-twice = el elemento móvil “{ $mover }” aparece dos veces: dé a cada uno su propio nombre
# A mover is a person, a chair or a ball that moves along a line. Its pace is a list of times and speeds.
plan-mover-pace = elemento móvil “{ $mover }”: los tiempos de su ritmo deben empezar en 0 y aumentar, corríjalos
plan-walls-too-many =
    sus paredes tienen { NUMBER($count, useGrouping: 1) } tramos, y se admiten { NUMBER($most, useGrouping: 1) } como máximo: dibuje menos
plan-points-too-many =
    sus recorridos y elementos móviles tienen demasiados puntos ({ NUMBER($count, useGrouping: 1) }, y se admiten { NUMBER($most, useGrouping: 1) } como máximo): dibújelos con menos
# movers: a field of the document, not translated.
plan-leader-without-movers = recorrido “{ $path }”: no hay ningún elemento móvil “{ $leader }” al que seguir, añádalo a movers
plan-leader-unknown = recorrido “{ $path }”: no hay ningún elemento móvil “{ $leader }” al que seguir, use uno de estos, { $names }
# A line on the floor, at the beginning of the sentences below.
plan-line-path = el recorrido “{ $path }”
plan-line-stage = la etapa “{ $stage }” del recorrido “{ $path }”
plan-line-mover = el elemento móvil “{ $mover }”
plan-line-problem = { $line }: { $problem }
plan-near-wall = { $line } pasa a { $distance } m de una pared cerca de ({ $x }; { $y }), y hacen falta { $radius } m a cada lado: mueva la línea o la pared
plan-near-obstacle = { $line } pasa a { $distance } m del obstáculo “{ $label }” cerca de ({ $x }; { $y }), y hacen falta { $radius } m a cada lado: mueva la línea o el obstáculo
plan-near-cone = { $line } pasa a { $distance } m del obstáculo “cono { $number }” cerca de ({ $x }; { $y }), y hacen falta { $radius } m a cada lado: mueva la línea o el obstáculo
plan-dunes-without-area = las dunas rodean un área: indique el área del suelo
# area, x_min, y_min, x_max, y_max: fields of the document, not translated.
plan-area-order = area es x_min, y_min, x_max, y_max, con los valores menores primero: corríjalo
plan-dune-inside = la duna { $number } entra en el área por la que se conduce: sáquela de ella

## Scenes: floor plans with tasks, some at several levels of difficulty. Names of fields and levels are not translated.

plan-scene-large = { $file }: esto ocupa más de { $most } MB y no es una escena, indique otro archivo
plan-scene-no-json = { $file }: esto no es JSON, corríjalo ({ $problem })
plan-scene-no-object = { $file }: esto no es una escena, empiécela con {"{"}
plan-scene-no-plan = { $file }, floorplan: no hay ningún plano “{ $plan }”, use uno de estos, { $names }
plan-scene-level-twice = { $file }, levels: un nivel aparece dos veces, quite uno
# The place of a problem, in front of a comma and the problem.
plan-scene-level = { $file }, nivel { $level }
plan-scene-problem = { $where }, { $problem }
plan-scene-too-deep = { $place }...: una escena no se anida a tanta profundidad, corríjala
plan-scene-one-value = { $place }: sin niveles, indique un solo valor
plan-scene-value-missing = { $place }: falta el valor del nivel { $level }, añádalo
plan-scene-level-unknown = { $place }: la escena no tiene el nivel { $level }, añádalo a levels o quítelo de aquí

## Import: titles in the new plan, and what was done

plan-path-proposed = A través del edificio
plan-path-drawn = Recorrido { $number }
plan-path-instruction = Siga la línea blanca hasta el final.
plan-path-is-proposal = El recorrido es una propuesta: cámbielo como quiera.
plan-wall-pieces =
    { $count ->
        [one] { NUMBER($count, useGrouping: 1) } tramo de pared.
       *[other] { NUMBER($count, useGrouping: 1) } tramos de pared.
    }

## Import of drawings (DXF). $unit: a text plan-unit; $units: mm, cm, m, inch, foot.

plan-unit =
    { $unit ->
        [inch] pulgadas
        [foot] pies
       *[other] { $unit }
    }

plan-drawing-empty = { $file }: en este dibujo no hay líneas (en las capas elegidas), elija otras
plan-drawing-walls-too-many = { $file }: este dibujo tiene { NUMBER($count, useGrouping: 1) } tramos de pared y se admiten { NUMBER($most, useGrouping: 1) } como máximo, elija menos capas
plan-layer-unknown = { $file }: no hay ninguna capa “{ $layer }” con líneas, use alguna de estas: { $names }
# In place of the names of layers in the sentence above.
plan-no-layers = ninguna
plan-drawing-improbable =
    { $file }: en { $unit }, como indica, este dibujo mide { NUMBER($width, useGrouping: 1, minimumFractionDigits: 1, maximumFractionDigits: 1) } x { NUMBER($height, useGrouping: 1, minimumFractionDigits: 1, maximumFractionDigits: 1) } m, un tamaño improbable para una planta, indique su unidad o quite lo que está lejos del edificio
# sizes: a list of plan-size-in-unit.
plan-drawing-improbable-unit =
    { $file }: en { $unit }, como indica, este dibujo mide { NUMBER($width, useGrouping: 1, minimumFractionDigits: 1, maximumFractionDigits: 1) } x { NUMBER($height, useGrouping: 1, minimumFractionDigits: 1, maximumFractionDigits: 1) } m, un tamaño improbable para una planta, indique su unidad ({ $sizes }) o quite lo que está lejos del edificio
plan-size-in-unit = { $width } x { $height } m en { $unit }
plan-drawing-size-given = El dibujo mide { $width } x { $height } m en { $unit }, la unidad elegida.
plan-drawing-size = El dibujo mide { $width } x { $height } m en { $unit }, la unidad que indica.
plan-drawing-size-units = El dibujo mide { $width } x { $height } m en { $unit }, la unidad que indica ({ $sizes }).
plan-drawing-wide = { $file }: este dibujo mide { NUMBER($width, useGrouping: 1) } x { NUMBER($height, useGrouping: 1) } m, indique su unidad o quite lo que está lejos del edificio
plan-drawing-small = { $file }: este dibujo solo mide { $width } x { $height } m, indique su unidad
# PATH: the name of a layer, not translated.
plan-drawing-paths =
    { $count ->
        [one] El recorrido es el de la capa PATH.
       *[other] { $count } recorridos proceden de la capa PATH.
    }
plan-drawing-without-path = Una silla no cabe en ningún sitio, así que todavía no hay ningún recorrido: dibuje uno o compruebe la unidad.
# names: a list of plan-counted.
plan-drawing-layers-out = Capas omitidas por su nombre, que se pueden elegir: { $names }.
plan-drawing-hidden = En capas desactivadas o congeladas: { $names }.
plan-drawing-files = En otros archivos; únalos al dibujo para incluirlos: { $names }.
# names: a list of plan-left-out.
plan-drawing-left-out = No incluido: { $names }.
plan-counted = { $name } ({ $count })
plan-counted-more = { $count } más
# Things in a drawing that are not read; any other name is a kind of thing in DXF, such as SPLINE.
plan-left-out =
    { $name ->
        [invisible] { $count ->
            [one] { $count } elemento invisible
           *[other] { $count } elementos invisibles
        }
        [texts] { $count ->
            [one] { $count } texto o cota
           *[other] { $count } textos y cotas
        }
        [missing-blocks] { $count ->
            [one] { $count } bloque que falta
           *[other] { $count } bloques que faltan
        }
        [clipped-blocks] { $count ->
            [one] { $count } bloque recortado, que se lee entero
           *[other] { $count } bloques recortados, que se leen enteros
        }
       *[other] { $count } { $name }
    }
plan-drawing-damaged = { $file }: algo en este dibujo está dañado, guárdelo otra vez como DXF
plan-drawing-large = { $file }: esto ocupa más de { $most } MB, dibuje solo lo que hay en el edificio
plan-drawing-dwg = { $file }: este es un dibujo DWG, guárdelo como DXF
plan-drawing-no-dxf = { $file }: esto no es un dibujo DXF que se pueda leer, guárdelo otra vez como DXF
plan-drawing-without-unit = { $file }: este dibujo no dice en qué unidad está hecho, indíquela ({ $units })
plan-drawing-too-much = { $file }: esto contiene más de { NUMBER($most, useGrouping: 1) } elementos, dibuje solo las paredes
plan-drawing-lines-too-many = { $file }: esto contiene más de { NUMBER($most, useGrouping: 1) } líneas, dibuje solo las paredes
plan-drawing-blocks-deep = { $file }: sus bloques están anidados a más de { $most } niveles, descompóngalos
plan-drawing-block-often = { $file }: un bloque aparece { NUMBER($count, useGrouping: 1) } veces, dibuje solo las paredes
plan-drawing-far = { $file }: algo en la capa “{ $layer }” está muy lejos, quítelo

## Import of pictures

plan-picture-threshold = { $file }: el umbral (“{ import-threshold }”) debe estar entre 0 (negro) y 1 (blanco), corríjalo
plan-picture-without-scale = { $file }: una imagen no tiene escala, indique o bien los metros por píxel o bien su anchura en m
plan-picture-size = { $file }: con esta escala, la imagen mide { $width } x { $height } m, corrija la escala
plan-picture-dark = { $file }: nada en esta imagen es tan claro como el umbral (“{ import-threshold }”), bájelo
plan-picture-coarse = { $file }: una celda mediría { $size } m y se perderían los pasos de las puertas, muestre una parte más pequeña
plan-picture-large = { $file }: esto ocupa más de { $most } MB, reduzca la resolución
plan-picture-pixels = { $file }: esta imagen tiene más de { NUMBER($most, useGrouping: 1) } píxeles, reduzca la resolución
plan-picture-no-picture = { $file }: esto no es una imagen PNG o JPEG que se pueda leer, guárdela de nuevo
plan-picture-damaged = { $file }: esta imagen está dañada, guárdela de nuevo
plan-picture-unreadable = { $file }: esta imagen no se puede leer ({ $reason }), guárdela de nuevo

## Import of maps of robots (ROS) and, with the noun “picture”, of pictures. A map is divided into cells.

plan-map-no-building =
    { $noun ->
        [map] { $file }: todo lo libre de este mapa se comunica con su borde, así que no muestra ningún edificio, elija “{ import-outside }” (--outside)
       *[picture] { $file }: todo lo libre de esta imagen se comunica con su borde, así que no muestra ningún edificio, elija “{ import-outside }” (--outside)
    }
plan-map-walls-too-many =
    { $noun ->
        [map] { $file }: este mapa, simplificado todo lo posible, tiene { NUMBER($count, useGrouping: 1) } tramos de pared, y se admiten { NUMBER($most, useGrouping: 1) } como máximo, conserve alrededor del { $share } % y pinte el resto como pared, o pinte encima de motas y muebles
       *[picture] { $file }: esta imagen, simplificada todo lo posible, tiene { NUMBER($count, useGrouping: 1) } tramos de pared, y se admiten { NUMBER($most, useGrouping: 1) } como máximo, conserve alrededor del { $share } % y pinte el resto como pared, o pinte encima de motas y muebles
    }
plan-map-too-narrow =
    { $noun ->
        [map] { $file }: una silla no cabe en ningún sitio de este mapa, compruebe su resolución y sus umbrales
       *[picture] { $file }: una silla no cabe en ningún sitio de esta imagen, compruebe su escala y el umbral (“{ import-threshold }”)
    }
plan-map-size =
    { $noun ->
        [map] El plano mide { $width } x { $height } m, con { $free } m² libres; el mapa entero mide { $whole_width } x { $whole_height } m.
       *[picture] El plano mide { $width } x { $height } m, con { $free } m² libres; la imagen entera mide { $whole_width } x { $whole_height } m.
    }
plan-map-unknown = En el mapa hay { $area } m² desconocidos, que cuentan como pared.
plan-map-open = El edificio está abierto al exterior: en el plano se cierran sus aberturas de hasta { $width } m.
plan-map-narrow-closed = Había demasiados tramos de pared: se cierran los espacios de menos de { $width } m de anchura.
plan-map-cells-joined = Cada { $side } x { $side } celdas se unen en una de { $size } m; las paredes pueden ser más gruesas en esa medida.
# mode, negate, free_thresh, occupied_thresh, image, resolution, origin: fields of a map's document, not translated.
plan-map-nothing-free = { $file }: ningún píxel está libre, compruebe mode, negate, free_thresh y occupied_thresh en { $document }
plan-map-alias = { $file }: el documento de un mapa no tiene alias (*name), escriba los propios valores
plan-map-no-yaml = { $file }: esto no es un documento YAML, indique el archivo .yaml de un mapa de map_server
plan-map-no-document = { $file }: esto no es el documento de un mapa (image, resolution, origin), indique otro archivo
plan-map-image-missing = { $file }: no existe esta imagen, póngala junto a { $document }
plan-map-no-image = { $file }: esto no es una imagen (PGM o PNG) que se pueda leer, guárdela de nuevo
plan-map-image-unreadable = { $file }: esta imagen no se puede leer ({ $reason }), guárdela de nuevo
plan-map-image-pixels = { $file }: esta imagen tiene más de { NUMBER($most, useGrouping: 1) } píxeles, reduzca la resolución
