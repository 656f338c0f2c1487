### Problems with the devices in general: their configurations, addresses, drivers, keys; the simulated body.

# $given is what a person wrote, in quotes.
device-no-host = { $given } no es una dirección: escriba un nombre como chair.local o una dirección como 192.168.1.20
device-no-line = { $given } no es una línea serie: escriba un nombre como /dev/ttyUSB0 o COM3
device-no-cable = { $given } es una conexión por radio (Bluetooth), por la que otros podrían enviar: conecte la placa con su cable

# $kind and $kinds are names in configurations, which are not translated: simulator, replay, serial, udp
device-unknown-kind =
    { $device ->
        [body] no hay ningún cuerpo del tipo “{ $kind }”: use uno de los tipos { $kinds }
        [chair] no hay ninguna silla del tipo “{ $kind }”: use uno de los tipos { $kinds }
        [head] no hay ningún seguimiento de la cabeza del tipo “{ $kind }”: use uno de los tipos { $kinds }
       *[shirt] no hay ninguna camiseta del tipo “{ $kind }”: use uno de los tipos { $kinds }
    }
device-needs-kind =
    { $device ->
        [body] la configuración de un cuerpo necesita “kind”: indique uno de los tipos { $kinds }
        [chair] la configuración de una silla necesita “kind”: indique uno de los tipos { $kinds }
        [head] la configuración de un seguimiento de la cabeza necesita “kind”: indique uno de los tipos { $kinds }
       *[shirt] la configuración de una camiseta necesita “kind”: indique uno de los tipos { $kinds }
    }
device-no-library =
    { $device ->
        [body] el cuerpo “{ $kind }” necesita la biblioteca “{ $library }”, que no está instalada: instálela
        [chair] la silla “{ $kind }” necesita la biblioteca “{ $library }”, que no está instalada: instálela
        [head] el seguimiento de la cabeza “{ $kind }” necesita la biblioteca “{ $library }”, que no está instalada: instálela
       *[shirt] la camiseta “{ $kind }” necesita la biblioteca “{ $library }”, que no está instalada: instálela
    }
# $driver is the name of a part of the program, such as app.hardware.head.opentrack.
device-no-driver =
    { $device ->
        [body] en esta instalación falta el controlador { $driver } del cuerpo “{ $kind }”: instale bodydrive de nuevo
        [chair] en esta instalación falta el controlador { $driver } de la silla “{ $kind }”: instale bodydrive de nuevo
        [head] en esta instalación falta el controlador { $driver } del seguimiento de la cabeza “{ $kind }”: instale bodydrive de nuevo
       *[shirt] en esta instalación falta el controlador { $driver } de la camiseta “{ $kind }”: instale bodydrive de nuevo
    }
device-no-class = el controlador { $driver } no tiene la clase { $name }: corrija su tabla en app/hardware

## The key that a shirt or a chair shares with this machine. Each also stands behind a colon.

device-key-unreadable = el archivo de clave { $file } no se puede leer ({ $why }): indique el archivo que se creó al vincular
device-key-no-text = el archivo de clave { $file } no se puede leer (no es un texto): indique el archivo que se creó al vincular
# In ` ` stands a command, which is not translated.
device-key-not-private = otras personas pueden leer el archivo de clave { $file }: ejecute `chmod 600 { $file }`, o vincule de nuevo
device-key-no-key = el archivo de clave { $file } no contiene ninguna clave: debe ser una sola línea con un número hasta 65535, un espacio y 64 dígitos hexadecimales
device-key-changed = el archivo de clave { $file } ya no contiene la misma clave que antes: elija la clave de nuevo

## The simulated body.

# $joint and $joints are names in configurations, which are not translated: right_elbow, left_wrist
bodydev-no-joint = este cuerpo no tiene la articulación “{ $joint }”: use { $joints }
bodydev-no-place = la articulación “{ $joint }” no puede ir a { $place }: indique una posición entre 0 y 1
bodydev-file-no-joint = { $file }: en este archivo no hay ninguna articulación del cuerpo simulado, dé a las columnas nombres como { $columns }
bodydev-file-times = { $file }: los tiempos de la columna “t” no aumentan de fila en fila, corríjalos
# The movement is repeated in a loop.
bodydev-file-short = { $file }: un movimiento de { $length } s es demasiado corto para repetirlo en bucle, indique uno de { $least } s como mínimo
bodydev-file-slow = { $file }: un movimiento necesita al menos { $least } filas por segundo, grábelo de nuevo
bodydev-file-uneven = { $file }: los tiempos de la columna “t” son demasiado irregulares, grabe de nuevo sin huecos largos
