### A visit of a patient: the open session, its equipment, its calibration, its trials and drives, and the adaptation of
### the calibration.

## The open session

visit-nobody = No hay ninguna sesión abierta: elija primero un paciente en la página Pacientes.
visit-not-calibrated = Todavía no hay nada calibrado: calibre primero y toque “Usar esta calibración”.
visit-shirt-silent = La camiseta no envía señales: la página Camiseta indica qué llega de ella.
visit-calibrated-unworn = La calibración del paciente es de una camiseta que no llevaba nadie: calibre primero con la camiseta puesta.
visit-calibrated-in-another = La calibración del paciente se hizo con otra camiseta: calibre primero con esta.
visit-calibrated-at-another-rate = La camiseta no envía con la frecuencia con la que se calibró: primero calibre de nuevo.
visit-code-wrong = Este código es incorrecto, ya se usó o tiene más de { $minutes } minutos: pida uno nuevo de la página del profesional.

# $now and $page are whole sentences: which session is open now, and what the page shows.
visit-another-session = { $now } { $page }
visit-session-ended = La sesión se terminó en otra pantalla, y ahora no hay ninguna sesión abierta.
# $code is the code of a patient, $time a time of day.
visit-session-opened = La sesión del paciente { $code } se abrió en otra pantalla a las { $time }.
visit-session-opened-by = { $person } abrió la sesión del paciente { $code } en otra pantalla a las { $time }.
visit-page-of-no-session = Lo que muestra esta página no pertenece a ninguna sesión y ya no se puede enviar: vuelva a cargar la página.
# $code is the code of a patient.
visit-page-of-session = Lo que muestra esta página pertenece a { $code } y ya no se puede enviar: vuelva a cargar la página.

## What must end first

visit-busy =
    { $running ->
        [trial] Hay un ensayo en marcha. Termínelo primero e inténtelo de nuevo.
        [drive] La silla real está habilitada. Termine primero la conducción e inténtelo de nuevo.
        [step] Hay un paso de la calibración en marcha. Espere a que termine o pare la grabación, e inténtelo de nuevo.
       *[test] La prueba de dos minutos está en marcha. Termínela primero e inténtelo de nuevo.
    }
visit-already-recorded =
    { $start ->
        [trial] Ya se está grabando algo: termínelo primero y después empiece un ensayo.
        [drive] Ya se está grabando algo: termínelo primero y después habilite la silla.
       *[test] Ya se está grabando algo: termínelo primero y después empiece la prueba de dos minutos.
    }
visit-recording = Ya se está grabando algo: espere a que termine, o párelo primero.
visit-no-trial = No hay ningún ensayo en marcha: empiece primero uno.
visit-trial-still-measured = El ensayo todavía se está midiendo: véalo de nuevo en un momento.
visit-no-drive = La silla no se está conduciendo: habilítela primero.
visit-drive-still-closing = La grabación todavía se está cerrando: vea de nuevo la conducción en un momento.
visit-no-test = No hay ninguna prueba de dos minutos en marcha: empiece primero una.
visit-test-still-measured = La prueba de dos minutos todavía se está midiendo: véala de nuevo en un momento.

## Recordings

visit-ticks-lost =
    { $count ->
        [one] Durante la grabación se perdió { $count } vuelta del bucle de control: cierre otros programas y repita este paso.
       *[other] Durante la grabación se perdieron { $count } vueltas del bucle de control: cierre otros programas y repita este paso.
    }
visit-recording-without-plan = La grabación no contiene el plano de su ensayo: no se puede medir de nuevo.
visit-recording-without-parameters = La grabación no indica con qué parámetros se condujo: no se puede valorar.

## Equipment

visit-no-shirt = Todavía no hay camiseta: elija una en la página Camiseta.
# $name is the name of a sensor.
visit-no-sensor = Esta camiseta no tiene ningún sensor “{ $name }”: elija uno de sus indicadores.
visit-layout-unreadable = La disposición de la camiseta no se puede leer: elija otra camiseta.
visit-no-file =
    { $kind ->
        [key] Aquí no hay ningún archivo “{ $name }”: vincule primero la camiseta (bodydrive shirt pair).
       *[file] Aquí no hay ningún archivo “{ $name }”: tráigalo primero con “Añadir archivo”.
    }
visit-keys-used-up = Ya se han usado todos los números de clave de camisetas: empiece con una carpeta nueva para la clínica.
# Of the phones that are paired as sensors.
visit-no-phone = No hay ningún teléfono { $number }: mire la lista otra vez.
visit-phones-most = Los { $most } números de teléfonos están ocupados: desvincule antes uno.
visit-chair-virtual = La silla virtual: solo se mueve la imagen.
visit-chair-not-open = La silla no está abierta: elíjala otra vez.
# $name is the name of a chair.
visit-chair-not-open-named = La silla “{ $name }” no está abierta: elíjala otra vez.
visit-chair-silent = La silla no responde: compruebe su alimentación y la red.
visit-chair-unknown-fault = La silla comunica un fallo que este programa no conoce.

## Calibration

visit-shirt-changed = La camiseta no es la misma que cuando empezó esta calibración: empiece de nuevo la calibración.
# $step is the name of a step in the program.
visit-no-step = En esta calibración no hay ningún paso “{ $step }”: elija uno de la lista.
visit-step-recorded = Se está grabando un paso: espere a que termine, o pare primero la grabación.
visit-step-not-recorded = Este paso no se está grabando, o ya no: empiécelo, o elija otro.
visit-no-short-calibration = Solo una cámara que ve la cabeza, el tronco y los hombros tiene una calibración corta: empiece la completa.
visit-step-needed = Los pasos Reposo y Movimiento libre no se pueden omitir: con ellos se hace la calibración.
visit-step-interrupted = El programa se cerró durante este paso: repítalo.
visit-step-process-ended = El proceso de control terminó durante este paso: repita el paso.
visit-step-nothing-recorded = Durante tres segundos no se grabó nada: mire la página Camiseta y después repita este paso.
visit-step-lossy = Solo llegó el { $share } % de las señales de la camiseta: compruebe su batería y su transmisor, y después repita este paso.
visit-step-silent = La camiseta no envió señales durante { $seconds } segundos: compruebe su transmisor y después repita este paso.
# $joint is the name of a joint, $reason one or more whole sentences on its movement.
visit-no-joint-moves = Ninguna articulación se mueve con suficiente claridad. { $joint }: { $reason }
visit-drive-now-too-early = Haga primero los pasos Reposo y Movimiento libre. Para conducir ya, deben conocerse los movimientos de otras cuatro personas con esta camiseta.
visit-fit-too-early = Haga primero los pasos Reposo y Movimiento libre. El ajuste necesita una calibración anterior de este paciente con esta camiseta.
visit-fitting = Se está calculando.
visit-fit-interrupted = El cálculo se interrumpió: repita cualquier paso y se hará de nuevo.
visit-controls-changed = Mientras tanto se cambiaron los controles: inténtelo de nuevo.
visit-calibration-without-shirt = No hay camiseta: elija una en la página Camiseta y después empiece de nuevo la calibración.
visit-no-result = Todavía no hay ningún resultado: haga primero todos los pasos.
# $joint and $joints are names of joints in the program.
visit-no-map = No hay ninguna calibración para “{ $joint }”: elija una de estas articulaciones, { $joints }.
visit-guided-not-better = La calibración aprendida de las indicaciones no es mejor para esta articulación: conserve la estándar.
visit-prior-not-better = No hay ninguna calibración de otras personas que sea mejor para esta articulación: conserve la actual.
visit-ring-not-turned = En esta articulación, la camiseta está colocada como en otras personas: no hay nada que elegir.

## Adaptation of the calibration

visit-adapt-off = La calibración de este paciente queda como está: vea ahora qué cambiaría, o elija que se sugieran los cambios.
visit-adapt-suggest = Cuando un ensayo con la silla virtual muestra que la calibración se ajusta peor, esta página indica qué cambiaría.
visit-adapt-auto = Cuando un ensayo con la silla virtual muestra que la calibración se ajusta peor, esta página indica qué cambia.
visit-adapt-not-now = Usted la dejó como está: se examina de nuevo después del próximo ensayo.
visit-adapt-no-trials = Con esta calibración todavía no se ha conducido nada: haga un ensayo con la silla virtual y después vea qué cambiaría.
visit-adapt-left-off = Alguien está conduciendo: se examina de nuevo después del ensayo.
visit-adapt-switched = La calibración ya no se adapta sola: vea la propuesta y después decida.
visit-adapt-stale = Los controles o los ensayos han cambiado desde esta propuesta: vea de nuevo qué cambiaría y después decida.
visit-adapt-gone = Esta propuesta ya no existe: vea de nuevo qué cambiaría y después decida.
visit-adapt-real-chair = Está elegida una silla real, y con ella no se adapta nada: elija primero la virtual.
visit-adapt-not-still = La silla está habilitada o se mueve: termine el ensayo o la conducción y después aplique el cambio.
visit-adapt-large = El paciente lo notaría: es un 5 % o más. Por eso espera a que alguien lo vea y lo aplique.
visit-adapt-restarting = El proceso de control se está reiniciando: espere un momento e inténtelo de nuevo.
visit-adapt-stopped = Sigue activa una parada: anúlela primero y después aplique el cambio.
