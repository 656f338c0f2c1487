### Why a command to the chair, the shirt or the head tracker is refused; why the chair cannot be armed; the state of
### what is connected; why a recorded drive cannot be computed again.

## Arming

drives-during-test = La prueba de dos minutos está en marcha, y en ella no se mueve ninguna silla: termínela primero y después habilite la silla.
drives-not-calibrated = Todavía no hay con qué conducir: calibre primero.
drives-controls-changed = Mientras tanto se cambiaron los controles o el documento de la silla: cargue de nuevo los controles y después habilite la silla.
# $happened and $remedy are whole sentences on the stop that is still in force: what happened, and what to do.
drives-latched = { $happened } { $remedy } Anule la parada y después empiece de nuevo.
drives-speed-without-brake = Con estos controles, la silla mantendría una velocidad que ningún movimiento puede reducir: en la página Controles, asigne un movimiento a la dirección contraria o a “Parar”, o elija “Sigue el movimiento”.
drives-posture-without-brake = Con estos controles, un sensor que se queda fijo mientras se mantiene una postura podría hacer que la silla siga en marcha, y ningún movimiento podría detenerla: en la página Controles, asigne a “Parar” movimientos de otras articulaciones, o elija “Mover” en lugar de “Mantener”.
# $problem says what became of the key of the pairing, without a full stop.
drives-shirt-unpaired = La camiseta ya no está vinculada: { $problem }.
# $problem says what became of the key of the pairing, without a full stop.
drives-chair-unpaired = La silla ya no está vinculada: { $problem }.
drives-only-recorded = Una silla real solo se conduce mientras se graba: empiece primero una conducción.
# $state is a whole sentence: the state of the chair.
drives-switch-pressed = { $state } Compruebe el entorno, suelte el interruptor y el joystick y después habilite la silla otra vez.
drives-switch-unproved = Con “Mantiene la velocidad” o “Mantiene el giro”, una silla sigue en marcha por sí sola, así que una real necesita su interruptor de parada: púlselo y suéltelo una vez para mostrar que funciona, o elija “Sigue el movimiento” en la página Controles.
drives-virtual-chair-chosen = Está elegida la silla virtual: elija primero una real.
drives-not-practised = Esta configuración no se ha practicado nunca con la silla virtual de esta clínica: termine antes un ensayo con ella y deje que cuente.
drives-show-the-switch = Con “Mantiene la velocidad” o “Mantiene el giro”, una silla sigue en marcha por sí sola: pulse y suelte una vez su interruptor de parada para mostrar que funciona, o elija “Sigue el movimiento” en la página Controles.
drives-wait-for-process = El proceso de control se está reiniciando: espere un momento.
# $name is the name of a chair.
drives-chair-silent = “{ $name }” no responde: compruebe su alimentación y la red.
# $name is the name of a chair.
drives-stop-switch-pressed = El interruptor de parada de “{ $name }” está pulsado: compruebe el entorno y después suéltelo.

## Refused commands

# $commands lists the names of all commands.
drives-no-command = No hay ningún comando “{ $name }”: use uno de estos, { $commands }.
# $problem is a sentence without its full stop: what is wrong, and what to do.
drives-problem = { $problem }.
drives-opening = Se está abriendo otro dispositivo: espere un momento e inténtelo de nuevo.
drives-wrong-sender = Este emisor no envía muestras de esta camiseta: vea en la página Camiseta qué emisor las envía.
drives-keys-move-nobody = Las teclas no mueven a nadie en esta camiseta: elija primero “Usted” como cuerpo.
drives-no-tablet = No se usa ninguna tableta como seguimiento de la cabeza: elíjala primero en la página Camiseta.
drives-no-camera = La cámara no es la camiseta en uso: elíjala primero en la página Camiseta.
drives-no-pose = El seguimiento de la cabeza todavía no ha indicado hacia dónde mira la cabeza: espere a que llegue su primera posición.
drives-run-ending = La grabación está terminando: empiece primero una nueva.
drives-another-stop = Mientras tanto hubo otra parada: compruebe el entorno y después toque Continuar otra vez.
drives-recording = Ya se está grabando algo: termínelo primero.
drives-armed = La silla está habilitada: termine primero la conducción.
drives-no-body = Solo en la camiseta simulada se puede elegir un cuerpo: elija primero la camiseta simulada.
drives-limits-while-moving = Los límites solo se suben mientras la silla está detenida y nadie se mueve: termine primero la conducción.
drives-dial-while-moving = El selector de velocidad solo se sube mientras la silla está detenida y el paciente está en reposo.
drives-plan-on-real-chair = Una silla real no se conduce en ningún plano: elija primero la silla virtual.
drives-other-sensors = Estos controles se hicieron para una camiseta con otros sensores: calibre con esta camiseta.
# $cutoff is in Hz; $least and $rate are frames a second.
drives-cutoff-too-high = Una atenuación del temblor de { $cutoff } Hz necesita más de { $least } muestras por segundo, y esta camiseta envía { $rate }: ponga un valor menor en la página Controles.
drives-still-stopping = La silla todavía se está deteniendo: inténtelo de nuevo en un momento.
drives-not-recording = No se está grabando nada: empiece primero una grabación.
# $problem is the reason that the operating system gives.
drives-cannot-record = No se puede empezar la grabación ({ $problem }): libere espacio en el disco.
drives-disk-full = Solo quedan { $free } MB libres en el disco de las grabaciones, y de una conducción no se puede perder nada: libere espacio hasta { $needed } MB y empiece de nuevo.

## Devices

drives-no-shirt = No hay ninguna camiseta conectada: elija una en la página Camiseta.
drives-no-tracker = No hay ningún seguimiento de la cabeza conectado: la vista mira al frente.
drives-tracker-failed = Falló el seguimiento de la cabeza ({ $problem }): elíjalo otra vez.
drives-shirt-failed = Falló la camiseta ({ $problem }): elíjala otra vez.
drives-virtual-chair =
    { $dynamics ->
        [wheelchair] La silla virtual, que se mueve como una silla real.
       *[unicycle] La silla virtual, que responde al instante.
    }
drives-others-hang =
    { $device ->
        [shirt] No se abre la camiseta, porque otras { $count } aperturas siguen sin terminar: inicie bodydrive de nuevo.
        [body] No se abre el cuerpo, porque otras { $count } aperturas siguen sin terminar: inicie bodydrive de nuevo.
        [chair] No se abre la silla, porque otras { $count } aperturas siguen sin terminar: inicie bodydrive de nuevo.
       *[tracker] No se abre el seguimiento de la cabeza, porque otras { $count } aperturas siguen sin terminar: inicie bodydrive de nuevo.
    }
drives-opening-slow =
    { $device ->
        [shirt] La camiseta no se abrió en { $seconds } segundos: compruebe sus ajustes.
        [body] El cuerpo no se abrió en { $seconds } segundos: compruebe sus ajustes.
        [chair] La silla no se abrió en { $seconds } segundos: compruebe sus ajustes.
       *[tracker] El seguimiento de la cabeza no se abrió en { $seconds } segundos: compruebe sus ajustes.
    }
# $library is the name of a Python package.
drives-library-missing =
    { $device ->
        [shirt] La camiseta necesita la biblioteca “{ $library }”, que no está instalada: instálela y después elija otra vez la camiseta.
        [body] El cuerpo necesita la biblioteca “{ $library }”, que no está instalada: instálela y después elija otra vez el cuerpo.
        [chair] La silla necesita la biblioteca “{ $library }”, que no está instalada: instálela y después elija otra vez la silla.
       *[tracker] El seguimiento de la cabeza necesita la biblioteca “{ $library }”, que no está instalada: instálela y después elija otra vez el seguimiento.
    }
# $error is the name of an error in the program's code.
drives-cannot-open =
    { $device ->
        [shirt] La camiseta no se puede abrir ({ $error }): compruebe sus ajustes.
        [body] El cuerpo no se puede abrir ({ $error }): compruebe sus ajustes.
        [chair] La silla no se puede abrir ({ $error }): compruebe sus ajustes.
       *[tracker] El seguimiento de la cabeza no se puede abrir ({ $error }): compruebe sus ajustes.
    }
# $error is the name of an error in the program's code, $message is what it says.
drives-cannot-open-message =
    { $device ->
        [shirt] La camiseta no se puede abrir ({ $error }: { $message }): compruebe sus ajustes.
        [body] El cuerpo no se puede abrir ({ $error }: { $message }): compruebe sus ajustes.
        [chair] La silla no se puede abrir ({ $error }: { $message }): compruebe sus ajustes.
       *[tracker] El seguimiento de la cabeza no se puede abrir ({ $error }: { $message }): compruebe sus ajustes.
    }
# $action is the name of a command, $error is the name of an error in the program's code, $message is what it says.
drives-defect = El programa tiene un error, y “{ $action }” no se llevó a cabo ({ $error }: { $message }): comuníquelo.

## The control process

drives-not-a-command = Esto no es un comando: envíe un objeto JSON por línea, con un número entero “id” y una palabra “do”.
drives-no-reason = El proceso de control rechazó esto sin decir por qué.
# $command is the name of a command.
drives-process-silent = El proceso de control no respondió a “{ $command }” en { $seconds } segundos.
drives-process-ended = El proceso de control ha terminado, y se está iniciando uno nuevo: inténtelo de nuevo en un momento.
drives-process-not-started = El proceso de control no se inició: busque su mensaje en la consola.
drives-process-restarting = El proceso de control se está reiniciando, y la silla está detenida: inténtelo de nuevo en un momento.
drives-process-no-answer = El proceso de control no respondió, y la silla está detenida: inténtelo de nuevo.

## A recorded drive, computed again

drives-replay-no-frame = la grabación no contiene ninguna muestra de la camiseta: elija otra grabación
drives-replay-empty = la grabación no contiene nada: elija otra
# Two counts of channels.
drives-replay-channels = el número de canales es { $recorded } en la grabación y { $expected } en el perfil: use el perfil de la misma camiseta
# $stated is what stands in the file run.json; the others are in Hz.
drives-replay-rate = su run.json indica { $stated } como frecuencia de muestreo, que debe estar entre { $slowest } y { $fastest } Hz: corríjala
# Begins a sentence on what is wrong: a field of the file run.json of the recording.
drives-replay-part = su run.json, { $part }
