### The kinds of shirts on the Shirt page; what shirts say of themselves, and why one cannot be used.

## The form of each kind of shirt: its title, what it is, how it is named when it is in use, its fields.

shirtdev-rate = Muestras por segundo
shirtdev-file = Archivo
shirtdev-key = Clave
# In “ ” stands a command, which is not translated.
shirtdev-key-hint = Solo una camiseta con clave puede conducir una silla real. El comando “bodydrive shirt pair”, en este equipo, crea una.
# The document that names the shirt's sensors.
shirtdev-layout = Disposición
shirtdev-layout-hint = Un archivo JSON que nombra los sensores. Sin él, se conserva la disposición que está en uso.
shirtdev-simulator-title = Camiseta simulada
shirtdev-simulator-about = Un tejido con 52 sensores, calculado a partir del cuerpo que lo lleva.
shirtdev-simulator-in-use = Camiseta simulada, { $rate } muestras por segundo
# A number from 1 to 999; each is a shirt with other sensors.
shirtdev-simulator-seed = Qué camiseta simulada
shirtdev-simulator-sensors = Sus sensores
shirtdev-simulator-all-work = Funcionan todos
shirtdev-simulator-two-dead = Dos están averiados
shirtdev-replay-title = Reproducción de un archivo
shirtdev-replay-about = Señales grabadas antes, que se reproducen como si llegaran ahora.
shirtdev-replay-in-use = Reproducción de { $file }
shirtdev-replay-loop = Empezar de nuevo al final
shirtdev-udp-title = Una camiseta por la red
shirtdev-udp-about = Muestras que llegan a este equipo por UDP.
shirtdev-udp-in-use = Camiseta por la red en el puerto { $port }
# An address of this machine.
shirtdev-udp-host = Escuchar en
shirtdev-udp-port = Puerto
# LSL is the Lab Streaming Layer, a network protocol of laboratories.
shirtdev-lsl-title = Flujos de Lab Streaming Layer
shirtdev-lsl-about = LSL: amplificadores, captura de movimiento y otros dispositivos de un laboratorio.
shirtdev-lsl-in-use = Flujos de LSL
shirtdev-lsl-name = Nombre del flujo
shirtdev-lsl-name-hint = Deje vacío lo que no importe. Varios valores, separados por comas, unen otros tantos flujos.
# What names the device that sends the stream.
shirtdev-lsl-source = Identificador del origen
# The kind of what the stream contains, such as EEG or MoCap.
shirtdev-lsl-type = Tipo
# The computer that sends the stream.
shirtdev-lsl-host = Equipo
shirtdev-lsl-rate-hint = Solo cuenta para flujos sin frecuencia propia.
shirtdev-lsl-layout-hint = Un archivo JSON que nombra los sensores. Sin él, los nombran los flujos.

## Why a shirt may not drive a real chair.

shirtdev-nobody-wears = Una camiseta simulada o reproducida no habilita ninguna silla real, porque no la lleva nadie: elija la camiseta puesta en la página Camiseta.
shirtdev-nobody-proves = Este origen no habilita ninguna silla real, porque nada demuestra de quién son los movimientos que muestra: elija la camiseta puesta en la página Camiseta.
shirtdev-no-key = Una camiseta sin clave no habilita ninguna silla real, porque cualquiera en la red podría enviar sus muestras: vincúlela (bodydrive shirt pair) y elija después su clave en la página Camiseta.

## What shirts say of themselves, and why one cannot be opened.

shirtdev-no-standard = { $file }: la camiseta estándar no se puede leer ({ $why }), instale de nuevo el programa
shirtdev-no-channel = la camiseta “{ $shirt }” no tiene ningún canal “{ $channel }” que pueda estar averiado: corrija su nombre

shirtdev-simulator-closed = La camiseta simulada está cerrada.
# $rate is the count of frames a second.
shirtdev-simulator-empty = Camiseta simulada, { $sensors } sensores a { $rate } Hz, sin nadie dentro.
shirtdev-simulator = Camiseta simulada, { $sensors } sensores a { $rate } Hz, con un cuerpo simulado dentro.

shirtdev-replay-closed = La reproducción está cerrada.
shirtdev-replay-ended = La reproducción de { $file } ha terminado: empiécela otra vez o elija “{ shirtdev-replay-loop }”.
# $note is a further sentence: what was mended, or is missing, in the times of the file.
shirtdev-replay =
    Reproducción de { $file }, { $sensors } sensores a { $rate } Hz, { $played } s de { $length } s.{ $note ->
        [none] {""}
       *[other] {" "}{ $note }
    }
shirtdev-replay-failed = { $file }: esto no se puede leer ({ $why }), compruébelo
# $layout is the name of a file.
shirtdev-file-no-joint = { $file }: nada indica a qué articulación pertenece la columna “{ $column }”, ponga la disposición de la camiseta junto al archivo como { $layout } o dé a las columnas nombres como right_elbow_1
shirtdev-recording-short =
    { $frames ->
        [one] { $folder }: esta grabación contiene { $frames } muestra de una camiseta, indique una más larga
       *[other] { $folder }: esta grabación contiene { $frames } muestras de una camiseta, indique una más larga
    }
shirtdev-recording-times = { $folder }: los tiempos de esta grabación no aumentan, indique otra
shirtdev-recording-channels = { $folder }: el número de canales es { $channels } en esta grabación y { $named } en su disposición, indique otra
shirtdev-recording-rate = { $folder }: esta grabación no indica su frecuencia de muestreo, indique otra
# The place of a problem, in front of a colon or comma and the problem.
shirtdev-file-columns = { $file }: sus columnas no forman una disposición
shirtdev-recording-layout = { $folder }: la disposición de la camiseta en esta grabación

# $problem is a message device-key-...
shirtdev-not-opened = no se abre la camiseta: { $problem }
shirtdev-udp-no-address = no se puede recibir la camiseta en { $host }: no es una dirección, corríjala
shirtdev-udp-failed = no se puede recibir la camiseta en { $place } ({ $why }): use una dirección de este equipo y un puerto libre
# $trouble is a message shirtdev-newest-not-stored or shirtdev-frame-...
shirtdev-udp-closed =
    No se está escuchando la camiseta{ $trouble ->
        [none] {""}
       *[other] {" "}({ $trouble })
    }.
# $sender and $stranger are addresses. Left out are frames that do not count.
shirtdev-udp-silent =
    Sin muestras de { $sender ->
        [unknown] ninguna camiseta
       *[other] { $sender }
    } en { $place }{ $trouble ->
        [none] {""}
       *[other] {" "}({ $trouble })
    }{ $other ->
        [0] {""}
        [one] , { $other } muestra de otro emisor ({ $stranger }) descartada
       *[other] , { $other } muestras de otro emisor ({ $stranger }) descartadas
    }{ $repeated ->
        [0] {""}
        [one] , { $repeated } muestra repetida descartada
       *[other] , { $repeated } muestras repetidas descartadas
    }{ $late ->
        [0] {""}
        [one] , { $late } muestra tardía descartada
       *[other] , { $late } muestras tardías descartadas
    }.
# $refused counts datagrams (packets of the network) that hold no good frame of this shirt.
shirtdev-udp =
    Camiseta en { $place } desde { $sender }, { $sensors } sensores{ $lost ->
        [0] {""}
        [one] , { $lost } muestra perdida
       *[other] , { $lost } muestras perdidas
    }{ $refused ->
        [0] {""}
        [one] , { $refused } datagrama rechazado{ $trouble ->
            [none] {""}
           *[other] {" "}({ $trouble })
        }
       *[other] , { $refused } datagramas rechazados{ $trouble ->
            [none] {""}
           *[other] {" "}({ $trouble })
        }
    }{ $other ->
        [0] {""}
        [one] , { $other } muestra de otro emisor ({ $stranger }) descartada
       *[other] , { $other } muestras de otro emisor ({ $stranger }) descartadas
    }{ $repeated ->
        [0] {""}
        [one] , { $repeated } muestra repetida descartada
       *[other] , { $repeated } muestras repetidas descartadas
    }{ $late ->
        [0] {""}
        [one] , { $late } muestra tardía descartada
       *[other] , { $late } muestras tardías descartadas
    }.

shirtdev-lsl-no-library = LSL no está instalado por completo: instale los paquetes pylsl y liblsl y pruebe otra vez
# One stream, in a sentence that lists several. $type, $source (its source ID) and $host can be 'none'.
shirtdev-lsl-stream =
    { $name } ({ $source ->
        [none] {""}
       *[other] origen { $source },{" "}
    }{ $type ->
        [none] {""}
       *[other] tipo { $type },{" "}
    }equipo { $host })
shirtdev-lsl-nothing = en esta red no hay ningún flujo de LSL con números: ponga en marcha el programa que lo envía y permita UDP y TCP del puerto 16571 al 16604
# $sought is a list of what was entered, $streams one of streams.
shirtdev-lsl-none = ningún flujo de LSL corresponde a { $sought }, hay { $streams }: corrija los datos o ponga en marcha el programa que lo envía
shirtdev-lsl-several = corresponden { $count } flujos de LSL, como { $streams }: escriba el identificador del origen o el equipo de uno, o varios identificadores separados por comas para unir esos flujos
shirtdev-lsl-no-answer = el flujo de LSL { $stream } no responde: permita UDP y TCP del puerto 16572 al 16604 entre ambos equipos
shirtdev-lsl-channels = los flujos de LSL tienen { $channels } canales en total y se pueden usar { $most } como máximo: elija menos flujos
shirtdev-lsl-misfit = el número de canales es { $channels } en los flujos de LSL y { $named } en la disposición: elija otra disposición o ninguna
shirtdev-lsl-rate = el flujo de LSL más rápido tiene { $rate } muestras por segundo y se pueden usar de { $low } a { $high }: elija otro
shirtdev-lsl-closed = Ningún flujo de LSL está abierto.
# $streams is a list of streams.
shirtdev-lsl-silent = No llegan muestras de { $streams }.
# $age is how long ago the newest sample was measured, $gone a list of streams whose senders have ended.
shirtdev-lsl =
    Flujos de LSL, { $sensors } sensores a { $rate } Hz, con { $age } ms de retraso{ $lost ->
        [0] {""}
        [one] , { $lost } muestra perdida
       *[other] , { $lost } muestras perdidas
    }{ $gone ->
        [none] {""}
       *[other] ; ya no llega nada de { $gone }
    }.

# So that no old frame drives, the number of the newest one is stored in a file.
shirtdev-newest-unknown = { $file }: nada indica cuál fue la muestra más reciente de esta camiseta, y una antigua no debe conducir: vincule de nuevo la camiseta

## Why frames are not used: each stands in brackets, behind what is left out.

shirtdev-newest-not-stored = el número de la muestra más reciente no se puede guardar ({ $why }): libere espacio en el disco
shirtdev-frame-late = sus muestras llegan con { $delay } s de retraso, y una muestra tardía no cuenta: acerque la camiseta a su receptor y compruebe qué más usa la red
shirtdev-frame-short = un datagrama de { $size } bytes es demasiado corto para ser una muestra
shirtdev-frame-foreign = lo que llega no procede de una camiseta
shirtdev-frame-version = la camiseta usa la versión { $version } del protocolo, pero se entiende la versión { $understood }
shirtdev-frame-flags = la camiseta usa opciones { $flags } que no se entienden
shirtdev-frame-sensors = la camiseta envía { $sent } sensores y su disposición tiene { $expected }: use la disposición de esta camiseta
shirtdev-frame-needs-key = la camiseta firma sus muestras: elija su clave
shirtdev-frame-not-signed = una muestra no estaba firmada con la clave de esta camiseta, o llegó dañada
shirtdev-frame-damaged = una muestra llegó dañada
