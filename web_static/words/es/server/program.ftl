### The program itself: its processes, its machine, and what is read from files in a process of their own.

## The processes

realtime-granted = El bucle de control funciona con planificación en tiempo real.
realtime-refused = El sistema no concedió la planificación en tiempo real: cierre otros programas mientras se conduce.
realtime-memory-refused = La memoria no se mantiene en la RAM: un equipo con poca memoria puede retrasar el bucle de control.
realtime-memory-locked = La memoria del bucle de control se mantiene en la RAM.
computing-ended = El proceso que calcula las cifras ha terminado: inténtelo de nuevo.
computing-too-long = El cálculo tardó más de { $limit } s: cierre otros programas e inténtelo de nuevo.
python-faulty = Python { $version } tiene fallos conocidos al leer archivos zip y tar: no importe expedientes ni restaure copias de seguridad de origen desconocido, e instale Python { $least } o posterior.
network-page-first = Un dispositivo que avisa del certificado debe abrir primero { $page }: esa página explica qué hacer.

## What is wrong with a file: the end of a sentence that begins with the file's name.

reading-failed = este archivo no se pudo leer o tarda demasiado: guárdelo de nuevo o hágalo más pequeño
reading-too-long = la lectura de este archivo tarda demasiado: hágalo más pequeño y añádalo otra vez
reading-memory = esto necesita demasiada memoria, hágalo más pequeño

## Names

names-two-scripts = En “{ $word }” hay letras de dos alfabetos: escríbalo con uno solo.
names-code-taken = Ya hay un paciente con el código “{ $other }”, y “{ $name }” se ve igual: elija otro.
names-file-taken = Ya hay un archivo o un plano “{ $other }”, y “{ $name }” se ve igual: elija otro nombre.
names-person-taken = Ya hay una persona con el nombre “{ $other }”, y “{ $name }” se ve igual: elija otro nombre.

## The source of a recording: "Simulated shirt (simulated person), virtual chair: practice only"

source-shirt-simulator = Camiseta simulada
source-shirt-replay = Señales grabadas
source-shirt-serial = Camiseta puesta con cable
source-shirt-udp = Camiseta puesta
source-shirt-slimevr = Rastreadores puestos
source-shirt-camera = Cámara
source-shirt-phones = Teléfonos puestos
source-shirt-bluetooth = Sensores Bluetooth puestos
source-shirt-brainflow = Placa puesta (BrainFlow)
source-shirt-lsl = Señales por LSL
source-shirt-unknown = Sin datos de la camiseta
source-other-shirt = Camiseta del tipo “{ $kind }”
source-body-person = persona simulada
source-body-visitor = cuerpo movido en la pantalla
source-body-recorded = cuerpo grabado
source-chair-virtual = silla virtual
source-chair-udp = silla real
source-chair-unknown = sin datos de la silla
source-other-chair = silla del tipo “{ $kind }”
source-with-body = { $shirt } ({ $body })
source-signals = { $shirt }, { $chair }
source-practice-only = { $source }: solo práctica

## The layout of a shirt: the end of a sentence that begins with the file or form.

layout-channel-twice = el canal “{ $name }” aparece dos veces: dé a cada uno su propio nombre
layout-joint-twice = la articulación “{ $name }” aparece dos veces: dé a cada una su propio nombre
layout-no-joint = el canal “{ $channel }” nombra la articulación “{ $joint }”, que no está entre las articulaciones: añádala o use una de estas, { $joints }
layout-no-channel = la articulación “{ $joint }” no tiene ningún canal: asígnele uno o quítela
layout-no-ring = el canal “{ $channel }” tiene posición pero no anillo: nombre su anillo o quite la posición
layout-ring-of-several = el anillo “{ $ring }” rodea varias articulaciones: dé a cada articulación su propio anillo
layout-ring-places =
    { $count ->
        [one] el anillo “{ $ring }” tiene { $count } sensor, así que su posición debe ser { $last } o no indicarse
       *[other] el anillo “{ $ring }” tiene { $count } sensores, así que sus posiciones deben ser de 0 a { $last }, cada una una sola vez, o no indicarse en ninguno
    }
