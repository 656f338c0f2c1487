### Texts about files of signals (CSV, Parquet and other kinds): what is wrong with one, and what was mended. Most begin with the name
### of a file, or with a place in it (signals-line, signals-row), and have no full stop.

## Places, and lists of names

signals-line = { $file }, línea { $line }
signals-row = { $file }, fila { $row }
# layout: a field of the file, not translated.
signals-layout-place = { $file }, layout
# The end of a list of names that is too long.
signals-names-more = { $names } y { $count } más

## Files and columns

signals-file-missing = { $file }: no existe este archivo, compruebe su nombre
# reason: what the operating system says of it, in its own language.
signals-file-unreadable = { $file }: este archivo no se puede leer ({ $reason }), compruébelo
signals-folder = { $file }: esto es una carpeta, indique un archivo que esté en ella
signals-device = { $file }: esto es un dispositivo o una tubería, indique un archivo corriente
signals-no-rows = { $file }: no hay ninguna fila debajo del encabezado, grabe de nuevo o indique otro archivo
signals-no-csv = { $file }: esto no es un archivo CSV, sino algo binario, guárdelo como CSV o como Parquet
signals-no-parquet = { $file }: esto no es un archivo Parquet, guárdelo como tal o dele el nombre de un CSV
signals-parquet-damaged = { $file }: este archivo Parquet se cortó o se modificó y no se puede leer, guárdelo de nuevo
# kind: the name of a format, such as C3D; library, extra: names of parts of programs. None is translated.
signals-library-missing = { $file }: los archivos { $kind } necesitan la biblioteca { $library }, instálela con pip install 'bodydrive[{ $extra }]' o guarde el archivo como CSV
signals-foreign-damaged = { $file }: este archivo { $kind } está dañado o tiene una forma desconocida, guárdelo de nuevo o como CSV
signals-foreign-empty = { $file }: este archivo { $kind } no contiene señales, indique otro
signals-variables-left-out = Se dejaron fuera variables de otra longitud: { $names }.
signals-streams-left-out = Se dejaron fuera flujos sin números: { $names }.
# sheet: the name of a sheet of a workbook; names: those of others.
signals-sheet-read = Se leyó la hoja { $sheet }; se dejaron fuera estas otras: { $names }.
# count: 2 or more, parts of a recording between which nothing was recorded.
signals-blocks-left-out = El archivo tiene { $count } bloques; se leyó el primero.
# part: the name of a stream or of a sheet.
signals-part-missing = { $file }: no hay ninguna parte “{ $part }” (hay { $names }), indique una de estas
signals-matlab-objects = { $file }: sus tablas están en una forma que solo lee MATLAB, guárdelas como CSV con writetable
signals-topics-left-out = Los lugares son los del topic { $topic }; se dejaron fuera estos otros: { $names }.
signals-places-several = { $file }: varias columnas pueden ser el lugar ({ $names }), llame x e y a las correctas
signals-kitti-times = { $file }: las poses con la forma de KITTI no tienen tiempos, ponga al lado times.txt con { $count } tiempos o indique la frecuencia de muestreo
signals-numbers = { $file }: esto contiene más de { NUMBER($most, useGrouping: 1) } números, divídalo en grabaciones más cortas
signals-empty = { $file }: este archivo está vacío, indique otro
signals-line-ends = { $file }: sus líneas terminan solo con retornos de carro, guarde el archivo con otros finales de línea
signals-column-missing = { $file }: no hay ninguna columna “{ $column }” (hay { $names }), añádala
signals-columns-missing = { $place }: no está ninguna de las columnas { $names }, solo { $there }, añádalas o indique otro archivo
signals-columns-twice = { $place }: hay dos columnas “{ $column }”, cambie el nombre de una de ellas
signals-column-unnamed = { $place }: la columna { $number } no tiene nombre, dele uno
# kind: the name of a type of data, not translated.
signals-column-type = { $file }: la columna “{ $column }” contiene { $kind } y no números, quítela o conviértala
signals-no-number = { $place }: “{ $column }” no tiene ningún número ahí, añádalo
signals-cells =
    { $count ->
        [one] { $place }: { $count } celda donde el encabezado tiene { $expected }, corrija o quite esta línea
       *[other] { $place }: { $count } celdas donde el encabezado tiene { $expected }, corrija o quite esta línea
    }
signals-not-a-number = { $place }, columna “{ $column }”: “{ $cell }” no es un número, escriba uno o deje vacía la celda
signals-no-numbers = { $file }: en este archivo no hay ninguna tabla de números, indique otro
signals-line-cut = La última línea está cortada y se dejó fuera ({ $place }).
signals-table-further = En { $place } empieza otra tabla, que se dejó fuera.
signals-columns-left-out = Se dejaron fuera columnas sin números que cambien: { $names }.
# separator: what stands between two columns; decimal: the sign of a decimal number.
signals-dialect =
    { $separator ->
        [semicolons] { $decimal ->
            [comma] Se leyó con punto y coma entre columnas y con coma decimal.
           *[point] Se leyó con punto y coma entre columnas y con punto decimal.
        }
        [tabs] { $decimal ->
            [comma] Se leyó con tabuladores entre columnas y con coma decimal.
           *[point] Se leyó con tabuladores entre columnas y con punto decimal.
        }
        [bars] { $decimal ->
            [comma] Se leyó con barras verticales entre columnas y con coma decimal.
           *[point] Se leyó con barras verticales entre columnas y con punto decimal.
        }
        [blanks] { $decimal ->
            [comma] Se leyó con espacios entre columnas y con coma decimal.
           *[point] Se leyó con espacios entre columnas y con punto decimal.
        }
       *[commas] { $decimal ->
            [comma] Se leyó con comas entre columnas y con coma decimal.
           *[point] Se leyó con comas entre columnas y con punto decimal.
        }
    }

## Channels. column: the name of the column of times, often “t”.

signals-no-channel = { $file }: aparte de “{ $column }” no hay ningún canal, añada una columna por canal
signals-channels = { $file }: { $count } canales son más de los que puede tener una camiseta, deje { $most } como máximo
signals-channel-named-t = { $file }: la disposición “{ $layout }” tiene un canal “{ $column }”, que es el tiempo: cambie el nombre del canal
# names: one name or several.
signals-channel-missing = { $file }: de los canales de la disposición “{ $layout }”, esta grabación no contiene { $names }, añada lo que falta o use la disposición de la camiseta que se grabó
signals-channels-count = { $file }: se indicaron { $count } columnas para los { $expected } canales de la disposición “{ $layout }”, indique una por canal, en su orden
# pairs: such as “A = Strain A [mV]”.
signals-channels-taken = Estos canales tienen columnas con otros nombres: { $pairs }.
signals-samples-few =
    { $count ->
        [one] { $file }: { $count } muestra no basta para una señal, grabe al menos unos segundos
       *[other] { $file }: { $count } muestras no bastan para una señal, grabe al menos unos segundos
    }
signals-frames-few =
    { $count ->
        [one] { $file }: { $count } muestra no basta para una señal, indique una grabación más larga.
       *[other] { $file }: { $count } muestras no bastan para una señal, indique una grabación más larga.
    }
signals-run-without-layout = { $file }: la grabación no indica de qué camiseta es.
signals-layout-missing = { $file }: no existe esta disposición, compruebe su nombre
signals-layout-unreadable = { $file }: esta disposición no se puede leer ({ $reason }), compruébela

## Times. column: the name of their column, often “t”.

# names: the columns that there are.
signals-time-missing = { $file }: no hay ninguna columna “t” ni otra de tiempos (hay { $names }), añada una en segundos
# units: a list of texts signals-time-unit; unit: the first of them.
signals-time-units = { $file }: “{ $column }” aumenta { $step } de fila en fila, que pueden ser distintas unidades ({ $units }): escriba la unidad en el nombre, por ejemplo “{ $column } ({ $unit })”
signals-time-unit =
    { $unit ->
        [ms] milisegundos ({ $rate } Hz)
        [us] microsegundos ({ $rate } Hz)
        [ns] nanosegundos ({ $rate } Hz)
       *[s] segundos ({ $rate } Hz)
    }
signals-time-read =
    { $unit ->
        [ms] Los tiempos son los de la columna “{ $column }”, en milisegundos.
        [us] Los tiempos son los de la columna “{ $column }”, en microsegundos.
        [ns] Los tiempos son los de la columna “{ $column }”, en nanosegundos.
        [min] Los tiempos son los de la columna “{ $column }”, en minutos.
        [h] Los tiempos son los de la columna “{ $column }”, en horas.
        [d] Los tiempos son los de la columna “{ $column }”, en días.
       *[s] Los tiempos son los de la columna “{ $column }”, en segundos.
    }
signals-time-wraps =
    { $count ->
        [one] El reloj de “{ $column }” volvió a empezar en 0 { $count } vez; sus tiempos continúan ahí.
       *[other] El reloj de “{ $column }” volvió a empezar en 0 { $count } veces; sus tiempos continúan ahí.
    }
# A person has said that no column of the file is right as the time.
signals-rate-needed = { $file }: sin una columna de tiempos no se conoce la frecuencia de muestreo, indíquela en Hz
# rate: given by a person.
signals-rate-set = Las muestras cuentan como uniformes, a { $rate } Hz.
signals-rate-beyond = { $file }: su frecuencia de muestreo es de { $rate } Hz, grabe entre { $slowest } y { $fastest } Hz
# found: the sample rate by the column.
signals-rate-wrong = { $file }: la frecuencia de muestreo se indicó como { $rate } Hz, pero según la columna “{ $column }” es de { $found } Hz, indique esa o la unidad de la columna
signals-time-large = { $file }: { $column } va de { $first } a { $last }, indique el tiempo en segundos
signals-time-constant = { $file }: { $column } es { $time } en todas las filas, indique el tiempo de cada muestra en segundos
signals-time-backwards = { $place }: el tiempo retrocede ahí ({ $column } = { $after } después de { $before }), ordene las filas o quite la parte que se grabó dos veces
signals-time-jumps = { $place }: { $column } salta ahí { $seconds } s ({ $hours } horas), conserve la parte anterior o la posterior, o corrija la columna { $column }
signals-rate-changes = { $place }: la frecuencia de muestreo cambia ahí ({ $column } = { $time } s), divida el archivo en partes de una sola frecuencia
signals-uneven = { $file }: { $column } aumenta de { $least } a { $most } s de fila en fila, sin una frecuencia de muestreo uniforme: exporte el tiempo de cada muestra que da el propio dispositivo, o remuestree el archivo a una frecuencia uniforme
# Several samples have one time, that of their arrival, or their times come in groups.
signals-shared-uneven = { $file }: muestras con el mismo tiempo que la anterior: { NUMBER($shared, useGrouping: 1) } de { NUMBER($count, useGrouping: 1) }, en un número que varía de una vez a otra, así que la frecuencia de muestreo no se conoce: exporte el tiempo de cada muestra que da el propio dispositivo, en segundos
signals-shared-spread = Muestras con el mismo tiempo que la anterior: { NUMBER($shared, useGrouping: 1) } de { NUMBER($count, useGrouping: 1) }; se repartieron uniformemente, a { $rate } Hz.
signals-bursts-uneven = { $file }: las muestras vienen en ráfagas, con la hora de su llegada, y su número varía de una vez a otra, así que la frecuencia de muestreo no se conoce: exporte el tiempo de cada muestra que da el propio dispositivo, en segundos
signals-bursts-spread = Las muestras vienen en ráfagas, con la hora de su llegada: se repartieron uniformemente, a { $rate } Hz.
signals-steps-spread = Los pasos de { $column } difieren, aunque las muestras son uniformes: se repartieron uniformemente, a { $rate } Hz.
signals-gaps =
    { $count ->
        [one] Hay { NUMBER($count, useGrouping: 1) } hueco entre las muestras, de { $longest } s, antes de { $place }.
       *[other] Hay { NUMBER($count, useGrouping: 1) } huecos entre las muestras, el más largo de { $longest } s, antes de { $place }.
    }

## Times in another unit than seconds. step: by how much t rises.

signals-unit-counter = { $file }: { $column } debe estar en segundos, pero aumenta { $step } de fila en fila, como un contador de muestras: divida la columna { $column } entre la frecuencia de muestreo en Hz
signals-unit =
    { $unit ->
        [milliseconds] milisegundos ({ $rate } Hz)
        [microseconds] microsegundos ({ $rate } Hz)
        [nanoseconds] nanosegundos ({ $rate } Hz)
        [minutes] minutos ({ $rate } Hz)
        [hours] horas ({ $rate } Hz)
       *[days] días ({ $rate } Hz)
    }
# unit: a text signals-unit.
signals-unit-other = { $file }: { $column } debe estar en segundos, pero aumenta { $step } de fila en fila, como si fueran { $unit }: multiplique la columna { $column } por { $factor }
signals-unit-one-of-two = { $file }: { $column } debe estar en segundos, pero aumenta { $step } de fila en fila, como si fueran { $unit } o bien { $or_unit }: multiplique la columna { $column } por { $factor } o bien por { $or_factor }
signals-unit-or-slow = { $file }: { $column } debe estar en segundos, pero aumenta { $step } de fila en fila, como si fuera otra unidad o las muestras se hubieran tomado demasiado despacio: escriba { $column } en segundos, y grabe con una frecuencia de { $slowest } a { $fastest } Hz
signals-unit-or-fast = { $file }: { $column } debe estar en segundos, pero aumenta { $step } de fila en fila, como si fuera otra unidad o las muestras se hubieran tomado demasiado deprisa: escriba { $column } en segundos, y grabe con una frecuencia de { $slowest } a { $fastest } Hz
# span, rate: of the recording if t is in seconds; span_of_minutes (s), rate_of_minutes (Hz): if it is in minutes.
signals-unit-minutes = { $file }: { $column } debe estar en segundos, pero aumenta { $step } de fila en fila, como si fueran minutos ({ $span_of_minutes } s a { $rate_of_minutes } Hz) y no { $span } s a { $rate } Hz: multiplique la columna { $column } por 60, o grabe más de { $brief } s
