### Texts about 3D objects (GLB files) and about the 3D view of a drive.

## An object that is refused. Most messages are the second half of object-unusable, without a full stop.

# reason: what the operating system says of it, in its own language.
object-file-unreadable = { $file }: este archivo no se puede leer ({ $reason }), compruébelo
object-unusable = { $file }: este objeto no se puede usar, { $problem }
object-not-scaled = { $file }: el tamaño de este objeto no se puede cambiar con certeza, expórtelo en metros
object-improbable = { $file }: según indica, este objeto mide { NUMBER($length, useGrouping: 1) } x { NUMBER($width, useGrouping: 1) } x { NUMBER($height, useGrouping: 1) } m, lo que es improbable: elija su tamaño, o expórtelo en metros.
object-no-glb = no es un archivo GLB: exporte el objeto como glTF binario (.glb)
object-version = es glTF de la versión { $version }: expórtelo con la versión 2
object-cut-off = está cortado o dañado: expórtelo de nuevo
object-damaged = está dañado: expórtelo de nuevo
object-no-description = su descripción no se puede leer: expórtelo de nuevo
object-parts-missing = se refiere a partes que no contiene: expórtelo de nuevo
object-lists-end = sus listas terminan más allá de sus datos: expórtelo de nuevo
object-no-tree = sus partes no forman un árbol: expórtelo de nuevo
object-nested = sus partes están anidadas a más de { $most } niveles: expórtelo de nuevo
object-far = algunos de sus puntos son infinitos o están demasiado lejos: expórtelo de nuevo
object-size-unknown = su tamaño no se puede leer con certeza: expórtelo de nuevo sin animación ni compresión
object-large = ocupa más de { $most } MB: simplifique el objeto
object-memory = necesita demasiada memoria: simplifique el objeto
object-faces = tiene { NUMBER($count, useGrouping: 1) } caras y se dibujan { NUMBER($most, useGrouping: 1) } como máximo: simplifique el objeto
object-points = tiene { NUMBER($count, useGrouping: 1) } puntos y se leen { NUMBER($most, useGrouping: 1) } como máximo: simplifique el objeto
object-nodes = tiene más de { NUMBER($most, useGrouping: 1) } nodos: únalos antes de exportar
object-long-list = tiene listas de más de { NUMBER($most, useGrouping: 1) } números: simplifique el objeto
object-numbers = sus listas tienen más de { NUMBER($most, useGrouping: 1) } números: simplifique el objeto
object-targets = tiene más de { $most } “morph targets”: expórtelo con una sola forma
object-without-faces = no contiene nada que tenga caras: exporte un objeto sólido
# name: of an extension of glTF, not translated.
object-extension = necesita “{ $name }”, que aquí no se lee: expórtelo sin compresión ni extensiones
object-instances = necesita “{ $name }”, que aquí no se lee: expórtelo sin instancias
object-compressed = está comprimido: expórtelo sin compresión
object-draco = está comprimido con Draco: expórtelo sin compresión
object-other-files = necesita otros archivos: exporte todo en un solo archivo GLB
# A buffer is a part of a GLB file.
object-picture-elsewhere = sus imágenes están en otro búfer: expórtelo de nuevo
object-picture-size = una de sus imágenes mide { NUMBER($width, useGrouping: 1) } x { NUMBER($height, useGrouping: 1) } píxeles, y se leen { NUMBER($most, useGrouping: 1) } píxeles como máximo: hágala más pequeña
object-picture-pixels = una de sus imágenes tiene más de { NUMBER($most, useGrouping: 1) } píxeles: hágala más pequeña
object-pictures-in-all = sus imágenes tienen en total más de { NUMBER($most, useGrouping: 1) } píxeles: use menos imágenes
object-picture-damaged = una de sus imágenes está dañada: expórtelo de nuevo
object-picture-unreadable = una de sus imágenes no es PNG ni JPEG, o está dañada: expórtelo de nuevo

## The 3D view

# The heading of a small panel beside the view, and of its two diagrams; m: metres.
object-plots = Gráficos
object-plot-driven = Trayectoria y recorrido, m
object-plot-error = Distancia al recorrido en 30 s, m
object-port-closed = Este puerto es solo para el propio programa: abra las páginas del programa.
# viser: the library that draws the view.
object-viser-port = viser abrió un puerto que cualquiera puede leer: instale viser 1.1.1
object-viser-page = { $file }: esta no es la página de viser 1.1.1, instale esa versión
