### The kinds of shirts on the Shirt page; what shirts say of themselves, and why one cannot be used.

## The form of each kind of shirt: its title, what it is, how it is named when it is in use, its fields.

# Whether a kind of shirt may drive a real chair, where shirts are chosen.
shirtdev-chair-wired = Puede conducir una silla real si su cable está conectado a este equipo: por él solo puede enviar la camiseta.
shirtdev-chair-with-key = Puede conducir una silla real solo con clave, porque sin ella cualquiera en la red podría enviar.
shirtdev-chair-nobody-wears = Nunca conduce una silla real, porque no la lleva nadie.
shirtdev-chair-nobody-proves = Nunca conduce una silla real, porque nada demuestra de quién son los movimientos.
# What a kind -needs and -costs, and how long it -takes, stands in source-needs, source-costs, source-takes of shirt.ftl.
shirtdev-rate = Muestras por segundo
shirtdev-file = Archivo
shirtdev-key = Clave
# In “ ” stands a command, which is not translated.
shirtdev-key-hint = Por la red, solo una camiseta con clave puede conducir una silla real. El comando “bodydrive shirt pair”, en este equipo, crea una.
# The document that names the shirt's sensors.
shirtdev-layout = Disposición de un archivo
shirtdev-layout-hint = Un archivo JSON que nombra los sensores. Sin él, se conserva la disposición que está en uso.
shirtdev-simulator-title = Camiseta simulada
shirtdev-simulator-about = Un tejido con 52 sensores, calculado a partir del cuerpo que lo lleva.
shirtdev-simulator-in-use = Camiseta simulada, { $rate } muestras por segundo
shirtdev-simulator-needs = nada más
shirtdev-simulator-costs = ninguno
shirtdev-simulator-takes = ninguno, se mueve enseguida
# A number from 1 to 999; each is a shirt with other sensors.
shirtdev-simulator-seed = Qué camiseta simulada
shirtdev-simulator-sensors = Sus sensores
shirtdev-simulator-all-work = Funcionan todos
shirtdev-simulator-two-dead = Dos están averiados
shirtdev-replay-title = Reproducción de un archivo
shirtdev-replay-about = Señales grabadas antes, que se reproducen como si llegaran ahora.
shirtdev-replay-in-use = Reproducción de { $file }
shirtdev-replay-needs = una grabación de este programa o un archivo de señales (CSV o Parquet)
shirtdev-replay-costs = ninguno
shirtdev-replay-takes = un minuto
shirtdev-replay-loop = Empezar de nuevo al final
shirtdev-replay-layout-hint = Un archivo JSON que nombra las columnas, por sus nombres o en su orden. Sin él, las columnas indican su articulación, como right_elbow_1.
shirtdev-serial-title = Una camiseta con cable
shirtdev-serial-about = Una placa, como un Arduino, que envía sus sensores por USB o por otra línea serie.
shirtdev-serial-in-use = Camiseta con cable en { $device }
shirtdev-serial-needs = una camiseta con sensores de estiramiento, una placa, como un Arduino, y un cable USB
shirtdev-serial-costs = unos 100 a 150 €
shirtdev-serial-takes = una tarde para construirla, después un minuto y luego la calibración
shirtdev-serial-device = Línea serie
shirtdev-serial-device-hint = Como la llama el sistema. Un nombre de /dev/serial/by-id/ no cambia al volver a conectar el cable.
shirtdev-serial-baud = Baudios
shirtdev-serial-format = Formato
shirtdev-serial-format-hint = Las muestras llevan una suma de comprobación: la que llega dañada se descarta. En una línea, una cifra perdida cambia un número.
shirtdev-serial-format-frames = Muestras con suma de comprobación
shirtdev-serial-format-lines = Líneas sencillas de números
shirtdev-udp-title = Una camiseta por la red
shirtdev-udp-about = Muestras que llegan a este equipo por UDP.
shirtdev-udp-in-use = Camiseta por la red en el puerto { $port }
shirtdev-udp-needs = una camiseta que envía muestras por UDP, en la red de este equipo
shirtdev-udp-costs = el de la camiseta
shirtdev-udp-takes = un minuto, otro para vincular su clave y luego la calibración
# An address of this machine.
shirtdev-udp-host = Escuchar en
shirtdev-udp-port = Puerto
# Trackers: small sensors of orientation, each worn on one part of the body. SlimeVR and owoTrack are names.
shirtdev-slimevr-title = Rastreadores (SlimeVR)
shirtdev-slimevr-about = Pequeños sensores de orientación en partes del cuerpo, por la red inalámbrica; también teléfonos con owoTrack.
shirtdev-slimevr-in-use = Rastreadores en el puerto { $port }
shirtdev-slimevr-needs = dos o más rastreadores, correas y la red inalámbrica de este equipo
shirtdev-slimevr-costs = unos 30 a 60 € por rastreador
shirtdev-slimevr-takes = un minuto cuando los rastreadores ya están en la red y luego la calibración
shirtdev-slimevr-host-hint = 0.0.0.0 son todas las redes de este equipo: allí lo buscan los rastreadores.
shirtdev-trunk-hint = Se ofrecen los sensores que envían. Cabeza, brazos y muslos se miden desde este.
shirtdev-chair-hint = Sin un sensor en el tronco, este lo sustituye.
# A limb: an arm or a leg. Its neighbour is the next part towards the trunk, such as the upper arm for the forearm.
shirtdev-from-neighbour = Medir cada parte desde su vecina
# Parts of the body that wear a tracker: the label of a field, and in lists.
shirtdev-part-trunk = Tronco
shirtdev-part-chair = Silla
shirtdev-part-head = Cabeza
shirtdev-part-left-upper-arm = Brazo izquierdo
shirtdev-part-right-upper-arm = Brazo derecho
shirtdev-part-left-forearm = Antebrazo izquierdo
shirtdev-part-right-forearm = Antebrazo derecho
shirtdev-part-left-hand = Mano izquierda
shirtdev-part-right-hand = Mano derecha
shirtdev-part-left-fingers = Dedos de la mano izquierda
shirtdev-part-right-fingers = Dedos de la mano derecha
shirtdev-part-left-thigh = Muslo izquierdo
shirtdev-part-right-thigh = Muslo derecho
shirtdev-part-left-lower-leg = Pierna izquierda, por debajo de la rodilla
shirtdev-part-right-lower-leg = Pierna derecha, por debajo de la rodilla
shirtdev-part-left-foot = Pie izquierdo
shirtdev-part-right-foot = Pie derecho
shirtdev-bluetooth-title = Sensores por Bluetooth (WitMotion)
shirtdev-bluetooth-about = Pequeños sensores de orientación en partes del cuerpo, como el WT901BLE.
shirtdev-bluetooth-in-use = Sensores Bluetooth, { $rate } muestras por segundo
shirtdev-bluetooth-needs = dos sensores o más, correas y un adaptador Bluetooth con Low Energy (4.0 o posterior)
shirtdev-bluetooth-costs = unos 35 a 50 € por sensor; un adaptador, unos 10 €
shirtdev-bluetooth-takes = un minuto y luego la calibración
# BrainFlow and OpenBCI are names. A board measures with electrodes or other sensors, and sends what it measures.
shirtdev-brainflow-title = Una placa (BrainFlow)
shirtdev-brainflow-about = Placas de OpenBCI y de otros fabricantes, con electrodos o sensores de movimiento.
shirtdev-brainflow-in-use = Placa { $board }
shirtdev-brainflow-needs = una placa de la lista de BrainFlow, por ejemplo una de OpenBCI
shirtdev-brainflow-costs = desde unos 150 € por un sensor muscular hasta más de 1000 € por un amplificador
shirtdev-brainflow-takes = unos minutos y luego la calibración
shirtdev-brainflow-board = Placa
shirtdev-brainflow-board-hint = Como la llama la lista de placas de BrainFlow, por ejemplo CYTON_BOARD, o su número en ella.
# What of the board's data is used. accel, gyro and so on are names that are typed, and are not translated.
shirtdev-brainflow-data = Datos
shirtdev-brainflow-data-hint = Nombres separados por comas: accel (aceleración), gyro (giro), analog, resistance (resistencia), exg (todos los electrodos), emg o lo que la placa tenga además.
# A board can send up to three streams, each at a rate of its own.
shirtdev-brainflow-preset = Flujo
shirtdev-brainflow-preset-hint = Algunas placas envían la aceleración en su segundo flujo.
shirtdev-brainflow-preset-default = Flujo principal
shirtdev-brainflow-preset-auxiliary = Segundo flujo (auxiliary)
shirtdev-brainflow-preset-ancillary = Tercer flujo (ancillary)
shirtdev-brainflow-needs-hint = Rellene lo que la lista de BrainFlow pide para esta placa y deje vacío lo demás.
# Of a Bluetooth device.
shirtdev-brainflow-mac = Dirección MAC
shirtdev-brainflow-ip = Dirección IP
shirtdev-brainflow-port-hint = 0 si la placa no necesita ninguno.
shirtdev-brainflow-number = Número de serie
# What else BrainFlow's list asks for with some boards.
shirtdev-brainflow-other = Otros datos
shirtdev-brainflow-layout-hint = Un archivo JSON que nombra los sensores. Sin él, cada tipo de datos es una articulación.
shirtdev-phones-title = Teléfonos como sensores
shirtdev-phones-about = Hasta seis teléfonos o tabletas, sujetos a partes del cuerpo, muestran cómo giran estas. Cada uno abre una página y envía; no se instala nada.
shirtdev-phones-in-use = Teléfonos, { $rate } muestras por segundo
shirtdev-phones-needs = de uno a seis teléfonos o tabletas con un navegador actual y algo que los sujete; páginas por https
shirtdev-phones-costs = ninguno, si ya se tienen los dispositivos; un brazalete, unos 10 €
shirtdev-phones-takes = un minuto por teléfono y luego la calibración
shirtdev-camera-title = Una cámara
shirtdev-camera-about = La cámara de una tableta, un portátil o un teléfono sigue la parte superior del cuerpo; nadie lleva nada puesto. Su imagen se queda en el navegador.
shirtdev-camera-in-use = Cámara, { $rate } muestras por segundo
shirtdev-camera-needs = un dispositivo con cámara y un navegador actual, y luz de frente; una página por https o en este mismo equipo
shirtdev-camera-costs = ninguno, si ya se tiene el dispositivo
shirtdev-camera-takes = uno o dos minutos y luego la calibración
shirtdev-camera-rate-hint = Elija menos si el dispositivo no llega a tiempo.
# LSL is the Lab Streaming Layer, a network protocol of laboratories.
shirtdev-lsl-title = Flujos de Lab Streaming Layer
shirtdev-lsl-about = LSL: amplificadores, captura de movimiento y otros dispositivos de un laboratorio.
shirtdev-lsl-in-use = Flujos de LSL
shirtdev-lsl-needs = un dispositivo o programa que envía números por LSL, en la red de este equipo
shirtdev-lsl-costs = ninguno, si ya se tiene el dispositivo
shirtdev-lsl-takes = un minuto y luego la calibración
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
shirtdev-no-cable = Esta camiseta no habilita ninguna silla real, porque su línea serie no pertenece a ningún dispositivo de este equipo y cualquier programa podría enviar por ella: elija en la página Camiseta la línea del cable de la camiseta.

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

# $why is the reason that the system gives, $lines a list of serial lines that are there.
shirtdev-serial-failed =
    { $cause ->
        [missing] no se puede abrir la camiseta en { $device } ({ $why }): conecte su cable{ $lines ->
            [none] {""}
           *[other] {" "}o elija el nombre que la línea tiene ahora: { $lines }
        }
        [forbidden] no se puede abrir la camiseta en { $device } ({ $why }): permita a este programa usar líneas serie, en la mayoría de los sistemas añadiendo su cuenta al grupo dialout
        [busy] no se puede abrir la camiseta en { $device } ({ $why }): cierre el otro programa que la usa
       *[other] no se puede abrir la camiseta en { $device } ({ $why }): compruebe el cable y los baudios
    }
shirtdev-serial-closed = No hay ninguna línea serie abierta para la camiseta.
shirtdev-serial-lost = La camiseta en { $device } ya no está: vuelva a conectar su cable y sus señales regresarán solas.
shirtdev-serial-silent = No llega nada de la camiseta en { $device }: compruebe que su placa tiene corriente y ejecuta su programa.
# $trouble is a message shirtdev-serial-foreign or shirtdev-frame-...
shirtdev-serial-unreadable = Lo que llega a { $device } no es una muestra de esta camiseta ({ $trouble }).
# Stands in brackets, behind what is left out.
shirtdev-serial-foreign = elija el formato y los baudios del programa de la placa
# $refused counts what arrived and was no frame of this shirt; $delay are the seconds by which the newest frame came late.
shirtdev-serial =
    Camiseta en { $device }, { $sensors } sensores{ $lost ->
        [0] {""}
        [one] , { $lost } muestra perdida
       *[other] , { $lost } muestras perdidas
    }{ $refused ->
        [0] {""}
       *[other] , { $refused } veces llegó otra cosa ({ $trouble })
    }{ $late ->
        [yes] , { $delay } s de retraso
       *[no] {""}
    }.

# $problem is a message device-key-...
shirtdev-not-opened = no se abre la camiseta: { $problem }
shirtdev-udp-no-address = no se puede recibir la camiseta en { $host }: no es una dirección, corríjala
shirtdev-udp-failed =
    { $cause ->
        [taken] no se puede recibir la camiseta en { $place } ({ $why }): cierre el otro programa que escucha ahí o use un puerto libre
        [forbidden] no se puede recibir la camiseta en { $place } ({ $why }): use un puerto a partir del 1024
        [elsewhere] no se puede recibir la camiseta en { $place } ({ $why }): use una dirección de este equipo, o 0.0.0.0 para todas
       *[other] no se puede recibir la camiseta en { $place } ({ $why }): use una dirección de este equipo y un puerto libre
    }
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

shirtdev-camera-closed = La cámara no se usa.
# $late and $refused count what is left out; $delay is how late the newest one was.
shirtdev-camera-silent =
    Ninguna cámara envía nada: iníciela en la página Camiseta o en la pantalla del paciente{ $late ->
        [0] {""}
       *[other] {" "}(sus imágenes llegaron con { $delay } s de retraso, y una tardía no cuenta: cierre otros programas en ese dispositivo o elija menos muestras por segundo)
    }{ $refused ->
        [0] {""}
        [one] , { $refused } mensaje rechazado
       *[other] , { $refused } mensajes rechazados
    }.
shirtdev-camera-nobody =
    La cámara no ve a nadie y faltan sus { $sensors } sensores: siéntese de modo que la cabeza, los hombros y los brazos estén en la imagen{ $lost ->
        [0] {""}
        [one] , { $lost } muestra perdida
       *[other] , { $lost } muestras perdidas
    }{ $refused ->
        [0] {""}
        [one] , { $refused } mensaje rechazado
       *[other] , { $refused } mensajes rechazados
    }{ $late ->
        [0] {""}
        [one] , { $late } imagen tardía omitida
       *[other] , { $late } imágenes tardías omitidas
    }.
# $pictures is the measured count a second, $delay the age of the newest picture in ms.
shirtdev-camera =
    Cámara, { $sensors } sensores, { $pictures } imágenes por segundo, cada una con { $delay } ms al llegar{ $lost ->
        [0] {""}
        [one] , { $lost } muestra perdida
       *[other] , { $lost } muestras perdidas
    }{ $refused ->
        [0] {""}
        [one] , { $refused } mensaje rechazado
       *[other] , { $refused } mensajes rechazados
    }{ $late ->
        [0] {""}
        [one] , { $late } imagen tardía omitida
       *[other] , { $late } imágenes tardías omitidas
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

shirtdev-brainflow-no-library = las placas necesitan la biblioteca BrainFlow ({ $why }): instálela con pip install 'bodydrive[brainflow]' y elija la placa de nuevo
# $boards is a list of names of boards.
shirtdev-brainflow-no-board = BrainFlow no tiene ninguna placa { $given }: escriba el nombre o el número de una, por ejemplo { $boards }
shirtdev-brainflow-nobody-wears = { $board } reproduce o genera señales y no la lleva nadie: elija una placa real, la camiseta simulada o la reproducción de un archivo
shirtdev-brainflow-no-stream = la placa { $board } no tiene ese flujo: elija otro
# $kinds is a list of names such as accel.
shirtdev-brainflow-no-data = este flujo de la placa { $board } tiene { $kinds }: escriba uno de ellos como datos, o varios separados por comas
shirtdev-brainflow-channels = la placa { $board } tiene { $channels } canales con estos datos y se pueden usar { $most } como máximo: escriba menos tipos
shirtdev-brainflow-misfit = el número de canales con estos datos es { $channels } en la placa y { $named } en la disposición: elija otra disposición o ninguna
shirtdev-brainflow-rate = este flujo de la placa { $board } tiene { $rate } muestras por segundo y se pueden usar de { $low } a { $high }: elija otro
shirtdev-brainflow-failed =
    { $cause ->
        [port] no se puede abrir la placa { $board } ({ $why }): compruebe su línea serie y cierre el otro programa que la usa
        [missing] no se puede abrir la placa { $board } ({ $why }): enciéndala y acérquela
        [fields] no se puede abrir la placa { $board } ({ $why }): rellene lo que la lista de BrainFlow pide para ella
       *[other] no se puede abrir la placa { $board } ({ $why }): compruebe que está encendida y los datos escritos
    }
shirtdev-brainflow-closed = Ninguna placa está abierta.
shirtdev-brainflow-silent =
    No llega nada de la placa { $board }{ $why ->
        [none] {""}
       *[other] {" "}({ $why })
    }: enciéndala y sus señales regresarán solas.
# $age is how much longer the newest sample took than the quickest one.
shirtdev-brainflow =
    Placa { $board }, { $sensors } sensores a { $rate } Hz, { $age } ms más tarde que la más rápida{ $lost ->
        [0] {""}
        [one] , { $lost } muestra perdida
       *[other] , { $lost } muestras perdidas
    }.

# So that no old frame drives, the number of the newest one is stored in a file.
shirtdev-newest-unknown = { $file }: nada indica cuál fue la muestra más reciente de esta camiseta, y una antigua no debe conducir: vincule de nuevo la camiseta

# $sensor is the name of a sensor: the address of a tracker, perhaps with a number and flex.
shirtdev-slimevr-no-name = “{ $given }” no es la dirección de un rastreador: escríbala como A1:B2:C3:D4:E5:F6, con /1 para un segundo sensor y /flex para un sensor de estiramiento
shirtdev-sensor-twice = el sensor { $sensor } está en dos partes del cuerpo: deje vacía una de ellas
shirtdev-slimevr-flex-chair = el sensor { $sensor } no mide la orientación: elija otro para la silla o deje vacío el campo
shirtdev-slimevr-closed = No se están escuchando los rastreadores.
# $refused counts datagrams (packets of the network) that are none of a tracker.
shirtdev-slimevr =
    Rastreadores en { $place }: envían { $sending } de { $placed }, { $sensors } sensores{ $refused ->
        [0] {""}
        [one] , { $refused } datagrama rechazado
       *[other] , { $refused } datagramas rechazados
    }.
# $sensors is a list of addresses.
shirtdev-slimevr-found = En ninguna parte del cuerpo: { $sensors }. Elija cada uno junto a la parte que lo lleva.
shirtdev-phones-no-number = “{ $given }” no es el número de ningún teléfono: escriba uno de 1 a { $most }
shirtdev-phones-closed = Los teléfonos no se usan.
# $late and $refused count what is left out; $delay is how late the newest one was.
shirtdev-phones =
    Teléfonos: envían { $sending } de { $placed }, { $sensors } sensores{ $refused ->
        [0] {""}
        [one] , { $refused } mensaje rechazado
       *[other] , { $refused } mensajes rechazados
    }{ $late ->
        [0] {""}
        [one] , { $late } mensaje tardío descartado (el último tardó { $delay } s más que el más rápido)
       *[other] , { $late } mensajes tardíos descartados (el último tardó { $delay } s más que el más rápido)
    }.
# $phones is a list of numbers.
shirtdev-phones-found = En ninguna parte del cuerpo: teléfono { $phones }. Elija cada uno junto a la parte que lo lleva.
shirtdev-bluetooth-no-address = “{ $given }” no es la dirección de un sensor Bluetooth: escríbala como A1:B2:C3:D4:E5:F6
# $why, here and below, is what a library or the system says.
shirtdev-bluetooth-no-library = los sensores Bluetooth necesitan la biblioteca bleak ({ $why }): instálela con pip install 'bodydrive[bluetooth]' y elíjalos de nuevo
shirtdev-bluetooth-failed =
    no se puede usar el Bluetooth de este equipo{ $why ->
        [none] {""}
       *[other] {" "}({ $why })
    }: compruebe que tiene un adaptador Bluetooth, enciéndalo y permita su uso a la cuenta de este programa
shirtdev-bluetooth-closed = Los sensores Bluetooth no se usan.
# $refused counts messages that are none of such a sensor, $repeated those with nothing new in them; $trouble is what
# the system's Bluetooth says.
shirtdev-bluetooth =
    Bluetooth: envían { $sending } de { $placed }, { $sensors } sensores{ $refused ->
        [0] {""}
        [one] , { $refused } mensaje rechazado
       *[other] , { $refused } mensajes rechazados
    }{ $repeated ->
        [0] {""}
        [one] , { $repeated } mensaje repetido
       *[other] , { $repeated } mensajes repetidos
    }{ $trouble ->
        [none] {""}
       *[other] {" "}({ $trouble })
    }.
# In the next four, $parts is a list of parts of the body.
shirtdev-sensors-silent = No envía: { $parts }. Encienda los sensores de ahí y compruebe su red.
shirtdev-sensors-moving = Aún no en reposo: { $parts }. Quédese quieto un segundo, con los brazos caídos.
shirtdev-sensors-drift = Deriva más de 2° por segundo: { $parts }. Deje el sensor apoyado un minuto o calíbrelo como indica su fabricante.
shirtdev-sensors-battery = Batería casi agotada: { $parts }. Cárguela.

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
