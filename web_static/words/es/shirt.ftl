### Texts of the shirt page: source, body, sensors.

shirt-title = La camiseta
shirt-words-count =
    { $good ->
        [one] { $good } de { $all } sensores está bien.
       *[other] { $good } de { $all } sensores están bien.
    }
shirt-lost =
    { $count ->
        [one] Se perdió { $count } muestra.
       *[other] Se perdieron { $count } muestras.
    }
shirt-none = Todavía no hay camiseta: elija de dónde vienen los movimientos.
# Stands beside the sensors; the lamps are those of the joint that moves.
shirt-wiggle = Mueva una articulación: se encienden sus indicadores.
shirt-moves = Se mueve ahora: { $joint }.
source-none = Todavía no hay camiseta: elija una.
source-worn = Movimientos propios de una persona
source-practice = Solo práctica (simulada)
shirt-calibrate = Calibrar
shirt-drive = Seguir a conducir
shirt-front = Delante
shirt-back = Detrás
shirt-sensors = Sensores
shirt-sensors-hint = Toque un indicador para ver su señal.
shirt-sensors-label = Sensores sobre el cuerpo. Las flechas pasan de uno a otro.
shirt-right = derecha
shirt-left = izquierda
shirt-legend = Qué significan los indicadores
sensor-joint = zona: { $joint }
sensor-unused = No usar este sensor
sensor-unused-hint = La próxima calibración lo excluye.
sensor-noise = ruido { $noise }
sensor-now = ahora { $value }
sensor-trace = Señal de { $name }, últimos 10 segundos
quality-good = Bien
quality-near = Cerca del límite
quality-railed = En el límite
quality-flat = Plano
quality-noisy = Con ruido
quality-nan = Valores imposibles
quality-estimated = Estimado
quality-unused = Sin usar
quality-silent = Sin señal
quality-good-words = Sigue al cuerpo.
quality-near-words = Se acerca al final de su rango: compruebe si la camiseta aprieta demasiado en esa zona.
quality-railed-words = Permanece al final de su rango: afloje la camiseta en esa zona o excluya este sensor.
quality-flat-words = No cambia nada: revise su conector o exclúyalo.
quality-noisy-words = Oscila más que sus vecinos: revise su conector.
quality-nan-words = Da valores imposibles: revise su cable o exclúyalo.
quality-estimated-words = Está averiado. Su valor se estima con los sensores vecinos, para que los movimientos sigan funcionando: revise su cable.
quality-unused-words = Usted lo ha excluido: la próxima calibración prescinde de él.
quality-silent-words = No llega nada de él: compruebe que la camiseta está encendida y conectada.
traces-title = Señales en vivo por articulación
traces-label =
    { $count ->
        [one] { $joint }, { $count } sensor
       *[other] { $joint }, { $count } sensores
    }
head-title = Seguimiento de la cabeza
head-none = Ninguno
head-none-hint = La vista mira al frente.
head-none-now = Ninguno: la vista mira al frente.
head-opentrack = opentrack
head-opentrack-hint = Su salida “UDP over network”, enviada a este equipo.
head-opentrack-now = opentrack en el puerto { $port }.
head-freepie = FreePIE
head-freepie-hint = O un teléfono que envía del mismo modo, por UDP.
head-freepie-now = FreePIE en el puerto { $port }.
head-flock-of-birds = Flock of Birds
head-flock-of-birds-hint = El rastreador magnético de Ascension, por una línea serie.
head-flock-of-birds-now = Flock of Birds en { $device }.
head-tablet = El sensor propio de una tableta
head-tablet-hint = Sostenida o fijada ante los ojos; su página debe estar abierta.
head-tablet-now = El sensor propio de una tableta.
head-tablet-start = Usar esta tableta
head-tablet-waiting = Esperando al sensor…
head-tablet-tells = Esta tableta indica ahora su dirección.
head-tablet-none = Este equipo no tiene ese sensor: abra esta página en una tableta o un teléfono.
head-tablet-denied = El navegador no permite usar el sensor: permita el movimiento para esta página en los ajustes del navegador.
head-tablet-insecure = Los navegadores solo dan acceso al sensor a páginas por https: abra esta página así, o en este mismo equipo.
head-recorded = Una cabeza grabada
head-recorded-hint = Un archivo con t, yaw_deg, pitch_deg y roll_deg.
head-recorded-now = Cabeza grabada { $file }.
head-simulator = Cabeza simulada
head-simulator-hint = Mira alrededor por sí sola.
head-simulator-now = Cabeza simulada.
head-device = Línea serie
head-baud = Baudios
head-address = Dirección
head-address-hint = Solo para un grupo de unidades; con una sola, deje este campo vacío.
head-ahead = Fijar como frente
head-ahead-done = La dirección actual de la cabeza es ahora el frente.
source-title = ¿De dónde vienen los movimientos?
# $what begins with a small letter where the language permits it: “a USB cable”.
source-needs = Hace falta: { $what }.
source-costs = Coste: { $what }.
source-takes = Tiempo: { $what }.
# Above the reason that is found, and what to do about it.
source-nothing = ¿No llega nada?
source-heed = Algo no está bien
source-change = Cambiar
source-use = Usar este
source-unit = { $value } { $unit }
source-file = Archivo
source-no-file = Todavía no hay ningún archivo de este tipo: añada uno abajo.
source-host = Escuchar en
source-port = Puerto
source-layout-wrong = { $file }: no es un documento JSON; elija la disposición de una camiseta.
source-layout-saved = Disposición guardada
source-layout-kept = La que hay ahora
source-key-none = Ninguna
# No sensor.
source-sensor-none = Ninguno
sender-now = Sus muestras llegan de { $shirt }.
sender-other = También llegan muestras de { $other }. Se descartan, porque la camiseta es el emisor en { $shirt }. Acepte el emisor nuevo solo si se ha cambiado o reiniciado la camiseta del paciente.
sender-use = Usar el emisor nuevo
sender-used = La camiseta es ahora el emisor en { $sender }.
source-add = Añadir archivo
source-add-hint = CSV o Parquet, como máximo 64 MB.
source-import = Importar una grabación
source-import-hint = De otro programa: la página dice qué contiene el archivo antes de usarlo.
source-added = Se ha añadido { $file }.
source-adding = Añadiendo { $file }…
source-file-option = { $name } ({ $size })
body-title = Cuerpo simulado
body-person-practised = Persona simulada, con práctica
body-person-practised-hint = Conduce sola y bien.
body-person-novice = Persona simulada, sin experiencia
body-person-novice-hint = Conduce sola y comete los errores de un principiante.
body-visitor = Usted
body-visitor-hint = Las teclas, los botones de la pantalla o un mando de juegos mueven los codos y los hombros dentro de la camiseta.
body-recorded = Un cuerpo grabado
body-recorded-hint = Rotaciones de las articulaciones de una persona real, de un archivo.
body-recorded-now = Cuerpo grabado: { $file }
body-yours = Usted mueve este cuerpo
pads-right-elbow = Codo derecho
pads-left-elbow = Codo izquierdo
pads-right-shoulder = Hombro derecho
pads-left-shoulder = Hombro izquierdo
pads-bend = doblar
pads-forward = adelante
pads-keys-right-elbow = W  ↑
pads-keys-left-elbow = S  ↓
pads-keys-right-shoulder = A  ←
pads-keys-left-shoulder = D  →
pads-note = Mantenga pulsado para mover y suelte para volver. Los dos codos a la vez son el gesto de parada.
pads-gamepad = Mando de juegos: los gatillos doblan los codos y las palancas empujan los hombros hacia adelante.
pads-group = Botones que mueven el cuerpo dentro de la camiseta
