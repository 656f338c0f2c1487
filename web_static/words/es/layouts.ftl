### Textos de la página de las disposiciones: qué sensores tiene una camiseta, dónde están, sus articulaciones; el editor de una.

rail-layouts = Disposiciones
layouts-lead = Una disposición dice qué sensores tiene una camiseta, en qué parte del cuerpo está cada uno y a qué articulación pertenece.
layouts-card = Disposición
# $name: of the layout; $count: of its sensors.
layouts-card-now =
    { $count ->
        [one] { $name }, { $count } sensor
       *[other] { $name }, { $count } sensores
    }
layouts-own = Sus disposiciones
layouts-none = Todavía ninguna: cree una nueva o duplique una de las de abajo.
layouts-bundled = Disposiciones incluidas en el programa
# $channels: how many sensors; $joints: how many joints.
layouts-counts = Sensores: { $channels } · Articulaciones: { $joints }
layouts-channels =
    { $count ->
        [one] { $count } sensor
       *[other] { $count } sensores
    }
# Marks a layout that the shirt has.
layouts-use-same = En uso
layouts-use-changed = En uso tal como era antes del último cambio
layouts-use = Usarla
layouts-use-label = Usarla: “{ $name }”
layouts-used = La camiseta tiene ahora la disposición “{ $name }”.
layouts-use-no-shirt = No hay ninguna camiseta en uso: elija una en la página Camiseta.
layouts-use-own = La camiseta en uso tiene una disposición propia, que no cambia.
layouts-edit = Editar
layouts-edit-label = Editar “{ $name }”
layouts-duplicate = Duplicar
layouts-duplicate-label = Duplicar “{ $name }”
layouts-copy = Copia de { $name }
layouts-export = Exportar
layouts-export-label = Exportar “{ $name }”
layouts-delete-label = Eliminar “{ $name }”
layouts-deleted = Se ha eliminado “{ $name }”.
layouts-gone = Esta disposición no existe: se ha eliminado o la dirección es incorrecta.
layouts-new = Disposición nueva
layouts-new-source = De dónde proceden sus sensores
layouts-from-stream = La camiseta en uso
layouts-from-stream-hint = Sus sensores, tal como llegan ahora.
layouts-from-file = Un archivo de señales
layouts-from-file-hint = Sus columnas; las articulaciones se proponen según lo que se mueve a la vez.
layouts-from-count = Un número de sensores
layouts-from-count-hint = Para una camiseta que ya envía y cuyos sensores aún no tienen nombre.
layouts-from-import = Un archivo con una disposición
layouts-from-import-hint = Un archivo JSON, como los que se exportan aquí.
layouts-no-file = Aquí no hay ningún archivo de señales: en la página Camiseta elija “Reproducción de un archivo” y añada uno.
layouts-count = Sensores
layouts-import-file = Archivo
layouts-import-wrong = { $file }: esto no es una disposición; elija un archivo JSON con los sensores de una camiseta.
layouts-name = Nombre de la disposición
layouts-new-name-hint = Si se deja vacío, recibe un nombre automáticamente.
layouts-new-go = Crearla
layouts-whole = Cuerpo entero
# The name of a joint until somebody names it; $number from 1.
layouts-group = Grupo { $number }

## El editor

layouts-edit-title = Disposición: { $name }
layouts-lead-live = Mueva un sensor: se ilumina en la lista y en el cuerpo. Elíjalo y toque después su lugar.
# $arriving, $count: how many sensors.
layouts-lead-not-live = Aquí no se ilumina nada: ahora llegan { $arriving } sensores, y esta disposición tiene { $count }.
layouts-body = En el cuerpo
layouts-body-hint = Toque, arrastre o use las flechas.
# The chosen sensor on the body, for a screen reader.
layouts-mark-label = Lugar de { $name }
layouts-list = Sensores, en el orden en que llegan
# A row of the list: joint and place of a sensor.
layouts-row = { $joint } · { $place }
layouts-moves = se mueve ahora
layouts-channel-name = Nombre del sensor
layouts-channel-name-hint = Letras sin acentos, cifras y _ . -
layouts-joint = Articulación
layouts-joint-hint = Los sensores de una articulación se calibran juntos.
layouts-joints-here = En esta disposición
layouts-joints-more = Otras
layouts-joint-other = Otra…
# The name of a joint until somebody names it.
layouts-joint-new = Articulación nueva
# $side: Front or Back; $part: of the body.
layouts-place = { $side }: { $part }
layouts-place-none = Todavía no está en el cuerpo
layouts-place-take = Quitarlo del cuerpo
layouts-side = Lado del cuerpo
layouts-part-head = cabeza
layouts-part-chest = pecho
layouts-part-belly = vientre
layouts-part-upper-back = parte alta de la espalda
layouts-part-lower-back = parte baja de la espalda
layouts-part-right-shoulder = hombro derecho
layouts-part-right-upper-arm = brazo derecho
layouts-part-right-elbow = codo derecho
layouts-part-right-forearm = antebrazo derecho
layouts-part-right-wrist = muñeca derecha
layouts-part-right-hand = mano derecha
layouts-part-left-shoulder = hombro izquierdo
layouts-part-left-upper-arm = brazo izquierdo
layouts-part-left-elbow = codo izquierdo
layouts-part-left-forearm = antebrazo izquierdo
layouts-part-left-wrist = muñeca izquierda
layouts-part-left-hand = mano izquierda
layouts-ring = Uno de un anillo alrededor del brazo o de la pierna
layouts-ring-hint = Sensores de una articulación que rodean el brazo o la pierna. Muestran si una manga se ha puesto girada.
layouts-ring-name = Nombre del anillo
layouts-ring-place = Cuál de ellos, contando alrededor del brazo o de la pierna
# $ring: its name; $count: how many sensors it has.
layouts-ring-places =
    { $count ->
        [one] El sensor del anillo “{ $ring }” es el único: tiene el número 1 o ninguno.
       *[other] Los sensores del anillo “{ $ring }” se cuentan del 1 al { $count }, cada número una sola vez, o ninguno de ellos tiene número.
    }
layouts-joints = Articulaciones
layouts-joint-row-label = Qué articulación es “{ $joint }”
layouts-joint-name-label = Nombre de “{ $joint }”
layouts-propose = Proponer articulaciones
layouts-propose-hint = Alguien mueve libremente todas las articulaciones durante { $seconds } segundos, una tras otra; los sensores que se mueven a la vez forman un grupo.
layouts-propose-move = Muévase ahora: todas las articulaciones, una tras otra.
layouts-propose-not-live = Se pueden proponer articulaciones mientras envía una camiseta con el mismo número de sensores.
# $names: of sensors.
layouts-propose-still = Sin movimiento: { $names }.
layouts-propose-use = Usar estos grupos
layouts-unsaved = Hay cambios sin guardar.
layouts-calibrations = Una calibración conserva la disposición con la que se hizo: calibre de nuevo para usar otras articulaciones.
layouts-save = Guardar
layouts-saved = “{ $name }” se ha guardado.
layouts-discard = Descartar los cambios
layouts-back = Todas las disposiciones
