### Texts of the page that imports a recording of another program.

rail-import-recording = Importar una grabación
import-recording-lead = Una grabación de otro programa se convierte en una de este programa: mire qué contiene, corrija lo que no sea correcto y úsela.
import-recording-files = Grabación
import-recording-files-hint = CSV, TSV, Parquet, Excel (XLSX), MATLAB, C3D, TRC, MOT, EDF, XDF, BVH y otros, como máximo 64 MB. Para BIDS-motion elija también su _channels.tsv y su _motion.json.
import-recording-reading = Leyendo el archivo…
import-recording-holds = Qué contiene el archivo
import-recording-kind = Formato
import-recording-kind-text = Tabla de texto (CSV)
import-recording-length = Duración
# $seconds is a number.
import-recording-length-words =
    { $count ->
        [one] { $seconds } s, { $count } muestra
       *[other] { $seconds } s, { $count } muestras
    }
import-recording-rows =
    { $count ->
        [one] { $count } fila
       *[other] { $count } filas
    }
import-recording-rate = Frecuencia de muestreo
import-recording-rate-words = { $rate } Hz
import-recording-rate-open = Aún no se conoce
import-recording-channels = Canales
import-recording-joints = Articulaciones
import-recording-even = Las muestras se tomaron a intervalos iguales.
import-recording-correct = Corríjalo abajo: la columna de los tiempos, su unidad, la frecuencia de muestreo o qué columnas son canales.
import-recording-times = Tiempos
# A stream, or the sheet of a workbook.
import-recording-part = Parte del archivo
import-recording-part-all = Todas juntas
import-recording-part-largest = La hoja más grande
import-recording-time = Columna de los tiempos
import-recording-time-none = Ninguna: las muestras van a intervalos iguales
import-recording-as-it-says = Como dice el archivo
import-recording-unit = Unidad de los tiempos
import-recording-unit-s = Segundos
import-recording-unit-ms = Milisegundos
import-recording-unit-us = Microsegundos
import-recording-unit-ns = Nanosegundos
import-recording-unit-min = Minutos
import-recording-unit-h = Horas
import-recording-unit-d = Días
import-recording-rate-by-hand = Frecuencia de muestreo (Hz)
import-recording-rate-hint = Cámbiela solo si las muestras se tomaron a intervalos iguales y los tiempos no son correctos.
import-recording-channels-count = { $count } de { $all } columnas son canales
import-recording-title-channel = Columna
import-recording-title-unit = Unidad
import-recording-title-range = Rango
import-recording-title-missing = Faltan
import-recording-title-joint = Articulación
import-recording-range = de { $least } a { $most }
import-recording-joint-of = Articulación de { $name }
import-recording-none-chosen = Elija al menos un canal.
import-recording-back = Volver a la camiseta
import-recording-store = Solo guardarla
import-recording-use = Usarla
