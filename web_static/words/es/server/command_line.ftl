### Texts of the command line, `bodydrive COMMAND ...`: what it prints, and what it says of bad input.
### Words that begin with --, and words in capitals behind them, are typed on the command line: they are not translated.

## Every command

# A name of the reader's own, such as a file or a joint, and a sentence on it.
cli-named = { $name }: { $text }
cli-file-failed = { $file } no se puede leer o escribir ({ $reason }): resuélvalo e inténtelo de nuevo
cli-output-failed = la salida no se puede leer o escribir ({ $reason }): resuélvalo e inténtelo de nuevo
# $problem is a sentence of the library that reads the command line, $command is such as: bodydrive score
cli-see-help = { $problem }: vea { $command } --help
cli-out-was-read = --out { $file } es un archivo que se leyó para esto: elija otro lugar
cli-out-unwritable = --out { $file } no se puede escribir ({ $reason }): elija otro lugar
cli-out-no-folder = --out { $folder }: { $file } es un archivo y no una carpeta, elija otro lugar
cli-out-forbidden = --out { $folder }: no se permite escribir nada en { $parent }, elija otro lugar
cli-out-no-file = --out { $file } no es un archivo corriente: elija otro lugar
cli-file-written = El archivo { $file } está escrito.
cli-source = Origen: { $source }
cli-no-clinic = No hay ninguna clínica en { $folder }: indique su carpeta con --state.
cli-no-set-up = La clínica de { $folder } todavía no está configurada: abra primero sus páginas.
cli-folder-unwritable = No se puede escribir en { $folder }: elija otra carpeta con --state.
cli-folder-in-use = La clínica de { $folder } ya está abierta: termine el otro programa, o elija otra con --state.
cli-other-version = El programa en marcha es de otra versión que este comando: use el comando de esa versión, o termine antes ese programa.
cli-others-can-read =
    { $count ->
        [one] Otras personas de este equipo pueden leer { $count } archivo de la clínica, { $file }: asígnelo a esta cuenta, o traslade la clínica a un disco que conserve los permisos.
       *[other] Otras personas de este equipo pueden leer { $count } archivos de la clínica, el primero es { $file }: asígnelos a esta cuenta, o traslade la clínica a un disco que conserve los permisos.
    }
# The name of a clinic that a command makes.
cli-clinic-name = Clínica
cli-no-such-patient = No hay ningún paciente con el código “{ $code }”: vea la lista de pacientes.
cli-yes = sí
cli-no = no
# Of a measured value, in a table.
cli-unknown = sin datos

## about

cli-about-compiled = bodydrive { $version }, construido con los cálculos compilados (los números son los mismos de un modo u otro, bit a bit)
cli-about-plain = bodydrive { $version }, construido como Python sin compilar (los números son los mismos de un modo u otro, bit a bit)
cli-about-held = Sus propios archivos contienen obras de otros; los textos de las licencias están en THIRD_PARTY_NOTICES.txt:
cli-about-no-licence = sin licencia declarada
# Of a package, in the place of its version.
cli-about-missing = no instalado
cli-about-not-installed = bodydrive no está instalado en este Python, así que no se conocen sus paquetes: instale su wheel.

## chair and shirt: pairing. The key is shown as a QR code above these sentences.

# The chair whose options were wrong.
cli-the-chair = la silla
cli-chair-paired = { $name }, en { $host }:{ $port }, queda vinculada. Su clave está en { $file } y en el código de arriba.
# A command follows.
cli-chair-next = En la silla, escriba lo que dice el código en un archivo { $file } que solo pueda leer su propietario, e inicie allí:
cli-shirt-paired = La camiseta queda vinculada. Su clave está en { $path } y en el código de arriba; elija { $file } en la página Camiseta.
# A command follows.
cli-shirt-next =
    El firmware de la camiseta necesita lo que dice el código. Para probarlo, escríbalo en un archivo { $file } que solo
    pueda leer su propietario, en cualquier equipo, e inicie allí:

## chair: the rehearsal without one, and its record

cli-rehearsal-title = Ensayo sin silla
cli-rehearsal-about = { $who }, { $date }; bodydrive { $version }, salida { $output }, clave { $key }.
cli-rehearsal-no-chair = La silla era emulada. Esto no muestra qué hace una silla real cuando se desconecta su cable o termina el receptor: pruébelo con las ruedas levantadas.
cli-rehearsal-signed = { $file } está firmado. SHA-256: { $digest }. HMAC: { $tag }.
cli-rehearsal-end = Se cumplieron { $kept } de { $steps } pasos. El registro es { $file }.
cli-rehearsal-no-output = --output { $output } no se puede emular: indique uno de { $outputs }
cli-rehearsal-no-who = el registro necesita --who, un nombre en una línea de { $most } letras como máximo: indíquelo
cli-rehearsal-no-json = --out { $file } no termina en .json: indique un nombre así
cli-rehearsal-no-receiver = el receptor no arranca ({ $reason }): corrija lo que indica
cli-rehearsal-false = { $file } no es un registro firmado con esta clave, o se ha modificado después: indique el archivo y la clave correctos
cli-rehearsal-genuine = { $file } está tal como se firmó con esta clave.
cli-rehearsal-step =
    { $step ->
        [paired] El receptor arranca con la clave de la silla.
        [armed] Se habilita la silla.
        [driven] Se conduce hacia delante.
        [stopped] Se pulsa Parar.
        [switch] Durante la marcha se pulsa el interruptor de la silla.
        [silence] Durante la marcha cesan los comandos, como al desconectar el cable de la red.
        [hand] Durante la marcha alguien mueve el joystick propio de la silla.
        [cable] Durante la marcha se desconecta el cable de la silla.
        [plugged] Se vuelve a conectar el cable.
       *[killed] Durante la marcha se interrumpe el proceso del receptor.
    }
cli-rehearsal-must =
    { $step ->
        [paired] Debe responder.
        [armed] Debe aceptarlo.
        [driven] Sus ruedas deben girar.
        [stopped] Sus ruedas deben quedar paradas.
        [switch] Sus ruedas deben quedar paradas.
        [silence] Sus ruedas deben quedar paradas.
        [hand] Sus ruedas deben quedar paradas.
        [cable] El receptor debe avisar del fallo y no pedir más velocidad.
        [plugged] Las ruedas deben quedar paradas y la silla, deshabilitada.
       *[killed] La clínica debe ver que no responde.
    }
cli-rehearsal-result =
    { $how ->
        [kept] CUMPLIDO: { $took } de { $limit } ms.
        [late] NO CUMPLIDO: { $took } ms en lugar de { $limit }.
       *[never] NO CUMPLIDO: no ocurrió ({ $limit } ms).
    }

## decode

cli-decode-suffix = --out { $file }: su nombre debe terminar en .parquet o .csv
cli-decode-done = { $frames } muestras, { $seconds } s, decodificadas en { $out }
cli-profile-unreadable = --profile { $file } no se puede leer ({ $reason }): indique el archivo que escribió calibrate
cli-profile-no-json = --profile { $file } no es un documento JSON: indique el archivo que escribió calibrate
cli-range-dead-zone = --dead-zone { $value }: indique movimientos completos por segundo, de { $least } a { $most }
cli-range-cutoff = --cutoff { $value }: indique Hz, de { $least } a { $most }
# The options that were wrong together.
cli-dead-zone-or-cutoff = --dead-zone o --cutoff

## floorplan

cli-plan-suffix = --out { $file }: su nombre debe terminar en .json
# The options of the command, which were wrong.
cli-the-options = las opciones
cli-plan-no-room = { $file }: no hay ningún lugar donde quepa una silla, dibuje un recorrido en una capa PATH o compruebe la unidad
cli-plan-made = { $title }: tramos de pared: { $walls }, recorrido de { $length } m, escrito en { $out }
# $plans are names, with commas between them
cli-plan-fine = { $file }: correcto ({ $plans })

## log

cli-log-unreadable = El registro de { $file } no se puede leer ({ $reason }): indique otra carpeta con --state.

## people

# Whether somebody can sign in: a person's state in a list.
cli-person-state-active = con acceso
cli-person-state-invited = con invitación
cli-person-state-disabled = acceso desactivado
# Behind a reviewer, in a list: the codes of the patients whom the reviewer may see.
cli-person-patients = pacientes: { $codes }
cli-person-no-patients = pacientes: ninguno
cli-no-role = --role { $role } no es una función: indique owner, clinician o reviewer.
cli-name-unusable = Este nombre no se puede usar: indique de 1 a 80 caracteres visibles.
cli-no-patient-option = --patient { $code }: no hay ningún paciente con este código, vea la página Pacientes.
cli-person-is-disabled = El acceso de { $name } está desactivado: las páginas que { $name } tiene abiertas se cierran en menos de 5 segundos.
cli-person-is-enabled = { $name } puede entrar de nuevo, con la contraseña de antes.
# The link follows. $time is a day with a time of day.
cli-invitation = { $name } elige una contraseña con este enlace, una sola vez, hasta el { $time }:
cli-not-running = El programa no está en marcha: inícielo con `bodydrive serve` y abra el enlace en su dirección.

## demo and serve: addresses, ports, certificates

cli-no-address = “{ $host }” no es una dirección de este equipo: omita --host, o indique una que lo sea.
cli-port-busy = El puerto { $port } de { $host } está ocupado: termine el programa que lo usa, o elija otro puerto con --port (con make: PORT={ $next }).
cli-port-of-system = El puerto { $port } está reservado al sistema: elija uno por encima de 1023 con --port.
cli-proxy-no-address = --behind-proxy “{ $text }” no es una dirección: escriba una como 127.0.0.1, o 10.1.2.0/24.
cli-proxy-too-large = --behind-proxy { $text } abarca demasiadas direcciones para confiar en ellas: indique la del proxy.
cli-no-public-name = --name “{ $text }” no es un nombre: escriba uno como clinic.example.org.
cli-not-encrypted = Otros equipos llegan a { $host }, y sin https cualquiera podría leer y cambiar por el camino lo que envían: use “bodydrive serve --lan”, u omita --host.
cli-proxy-needs-name = --behind-proxy y --name se usan juntos: indique la dirección del proxy y su nombre.
cli-proxy-or-lan = Un proxy es la única entrada: use --lan o --behind-proxy, pero no ambos.
cli-one-host = Sin --lan solo hay una dirección: indique --host una sola vez, u omítalo.
cli-certificate-needs-lan = Un certificado es para otros equipos: use --certificate y --key junto con --lan.
cli-certificate-needs-key = Un certificado necesita su clave: indique ambos, con --certificate FILE --key FILE.
# A QR code and an address follow.
cli-scan = En una tableta, escanee este código, o abra la dirección que está debajo:
# A QR code and an address follow.
cli-scan-again = La dirección de este equipo ha cambiado. En una tableta, escanee este código, o abra la dirección que está debajo:
cli-demo-opened = Una demostración, que no se guarda en ningún sitio. Ctrl-C la termina.
cli-serve-opened = La clínica de { $folder }. Ctrl-C la cierra.
cli-setup-code = Código de configuración, para el primer administrador, durante { $minutes } minutos: { $code }
cli-control-process-failed = No se puede iniciar el proceso de control ({ $reason }): cierre otros programas e inténtelo de nuevo.
cli-control-process-ended = El proceso de control no se inició, así que no hay nada que mostrar: vea los mensajes de arriba e inténtelo de nuevo.
# $kind is the name of an error in Python, $problem what it says
cli-not-started = El programa no se inició, a causa de { $kind }: { $problem }. Corríjalo si puede e inícielo de nuevo; si no, comunique esta línea.
# The name of the clinic of `bodydrive demo`.
cli-demo-clinic = Demostración
# What is noted about the two patients of `bodydrive demo`.
cli-demo-calibrated = Paciente de demostración: no es una persona real. Calibración hecha con la camiseta simulada.
cli-demo-newcomer = Paciente de demostración: no es una persona real. Sin calibración: conduce con lo aprendido de otras personas.

## service

cli-service-account = Una unidad propia se ejecuta con la cuenta de usted: omita --account, o añada --system.
cli-service-root = La clínica no debe ejecutarse como root: indique su cuenta con --account.
cli-service-state = Indique la carpeta de la clínica con --state: una unidad del sistema no tiene carpeta personal.
cli-service-letters = La carpeta o la cuenta tiene un carácter que una unidad no admite: elija otra.

## check

cli-check-begins = Midiendo durante { $seconds } s, igual que funcionaría el bucle de control…

## replay

cli-replay-speed = --speed { $speed }: indique un número entre { $least } y { $most }
cli-replay-begins = Se envía { $name } a { $to }: { $channels } canales a { $rate } Hz, { $seconds } s. Ctrl-C lo termina.
cli-replay-loops = Se envía { $name } a { $to }: { $channels } canales a { $rate } Hz, { $seconds } s una y otra vez. Ctrl-C lo termina.
cli-replay-failed = --to { $to }: no se puede enviar nada allí ({ $reason }), indique otra dirección
cli-replay-stopped = Detenido. Muestras enviadas: { $frames }.
cli-replay-ended = La grabación ha terminado. Muestras enviadas: { $frames }.
cli-replay-address = --to { $to }: escriba un host y un puerto, como { $example }
cli-replay-no-host = --to { $to }: no hay ningún host con este nombre, corríjalo

## score

cli-score-radius = --goal-radius { $radius }: indique metros, más de 0 y { $most } como máximo
cli-score-places = { $file }: x e y deben ser metros, a { $most } de 0 como máximo: corríjalos
cli-score-too-long = { $file }: dura { $seconds } s, más de un día: indique t en segundos, de un solo ensayo
cli-score-rows = { $file }: sus filas suelen estar a { $seconds } s unas de otras: indique t en segundos, no en milisegundos
cli-score-speed = { $file }: su velocidad media es de { $speed } m/s: indique x e y en metros, y t en segundos
cli-score-slow = { $file }: su velocidad media es de { $speed } m/s con filas a { $seconds } s unas de otras: indique t en segundos, no en milisegundos
cli-score-loops = Dos vueltas alrededor de un mismo lugar en sentidos opuestos se anulan en el área; la distancia recorrida cuenta ambas.

## signals. column, unit, role, ... are titles of a table.

cli-signals-title-column = columna
cli-signals-title-unit = unidad
cli-signals-title-role = contiene
cli-signals-title-joint = articulación
cli-signals-title-least = mínimo
cli-signals-title-most = máximo
cli-signals-title-missing = falta
cli-signals-role =
    { $role ->
        [time] tiempo
        [channel] canal
        [other-time] otro tiempo
        [counter] contador
        [text] palabras
        [empty] nada
        [constant] un solo valor
       *[unused] no se usa
    }
cli-signals-summary =
    { $channels ->
        [one] { $rows } muestras, { $seconds } s, a { $rate } Hz, { $channels } canal.
       *[other] { $rows } muestras, { $seconds } s, a { $rate } Hz, { $channels } canales.
    }
# names: of streams or sheets.
cli-signals-parts = Partes que pueden leerse solas con --part: { $names }.
cli-signals-suffix = --out { $file }: el nombre debe terminar en .parquet
cli-signals-rate = --rate { $rate }: indique Hz de { $least } a { $most }
cli-signals-unit = --unit { $unit }: indique una de estas unidades: { $known }
cli-signals-channels = --channels { $channels }: indique nombres distintos de columnas, separados por comas
# problem: a sentence without a full stop.
cli-signals-correct = { $problem } (o indíquelo con --time, --unit o --rate; bodydrive signals show muestra qué contiene un archivo)

## study

cli-study-seeds = --seed { $seed } no deja sitio para --seeds { $seeds }: la semilla mayor es { $largest }
cli-study-learning = --no-learning se usa sin --adapt: cuando hay varias sesiones, la persona se elige con --person
cli-study-interface = --interface-test se usa sin --adapt ni --no-learning: elija una de estas opciones
cli-study-map = --map { $map } se usa con --adapt: indique cómo se adapta la calibración, u omita --map
cli-study-path = --path { $path }: no tiene ninguna línea respecto a la que medir, elija un recorrido a lo largo del cual se conduzca
cli-study-foreign = --out { $folder } contiene “{ $file }”, que no forma parte de un estudio: indique una carpeta nueva o vacía
# $names are names of floor plans, with commas between them
cli-study-no-plan = --floorplan “{ $plan }”: no hay ningún plano así: use { $names } o un archivo JSON
# A sentence on the floor plan, the path or the folder that was named, which begins with the name where it needs one.
cli-study-bad-plan = --floorplan { $problem }
cli-study-bad-path = --path: { $problem }
cli-study-bad-out = --out { $problem }
cli-study-figures = --format { $format }: las figuras necesitan la biblioteca matplotlib, instálela con pip install 'bodydrive[figures]', u omítalas con --format none
# One trial of a simulated person: the area between the driven and the prescribed path.
cli-study-trial = ensayo { $number } de { $trials }: distancia recorrida { $distance } m, área fuera del recorrido { $area } m², { $seconds } s
cli-study-trial-missed = ensayo { $number } de { $trials }: distancia recorrida { $distance } m, área fuera del recorrido { $area } m², { $seconds } s, meta no alcanzada
# $seed stands for a simulated person, $mode is off or what --adapt was given
cli-study-session-trial = semilla { $seed }, { $mode }, sesión { $session }, ensayo { $trial }: área fuera del recorrido { $area } m²
cli-study-session-trial-missed = semilla { $seed }, { $mode }, sesión { $session }, ensayo { $trial }: área fuera del recorrido { $area } m², meta no alcanzada
cli-study-seed-trials =
    { $count ->
        [one] semilla { $seed }: { $count } ensayo hecho
       *[other] semilla { $seed }: { $count } ensayos hechos
    }
cli-study-seed-sessions =
    { $count ->
        [one] semilla { $seed }: { $count } sesión
       *[other] semilla { $seed }: { $count } sesiones
    }
cli-study-trials-done =
    { $count ->
        [one] { $count } ensayo en { $seconds } s, escrito en { $out }
       *[other] { $count } ensayos en { $seconds } s, escritos en { $out }
    }
cli-study-tests-done =
    { $count ->
        [one] { $count } prueba de dos minutos en { $seconds } s, escrita en { $out }
       *[other] { $count } pruebas de dos minutos en { $seconds } s, escritas en { $out }
    }

## calibrate: a table with one line for each joint. A title of a column stays short.

cli-joints-joint = articulación
# How clear the main movement is, in percent.
cli-joints-clear = claro
cli-joints-span = rango
# How many of 100 movements reach half of full.
cli-joints-hits = reconocidos de 100
# How often the gesture acts while the person rests.
cli-joints-at-rest = en reposo por min
# From which speed of the movement the gesture counts.
cli-joints-counts-from = cuenta desde
cli-joints-full-at = máximo en
cli-joints-calibration = calibración
# Calibrations, in the last column: the standard one, one learnt from the cues, one learnt from other people.
cli-map-standard = estándar
cli-map-cues = guiada
cli-map-people = otras personas
# A share of the full movement per second.
cli-calibrate-rate = { $share } % / s
# $least is the least figure that the repetitions show
cli-at-least = { $figure } (al menos { $least })
cli-at-most = { $figure } (hasta { $most })
# An expected figure with its standard deviation.
cli-forecast = { $value } ± { $uncertainty }
cli-calibrate-clear-means = Claro: proporción de la señal que está en el movimiento principal. Rango: el del movimiento completo, en la unidad propia de las señales.
cli-calibrate-expected-means = Reconocidos de 100: movimientos que se espera que lleguen a la mitad del máximo. En reposo por min: cuántas veces se espera que el gesto actúe mientras la persona está en reposo.
# $reason has no full stop
cli-channel-left-out = El canal { $channel } queda excluido: { $reason }.
cli-calibrate-out = El perfil está en { $out }
# Titles of the columns of gestures: all of them together as one score, the strength of the signal, how well the
# movement repeats, how much moves along with it, the effort, false activations a minute, the share of cues answered.
cli-gesture = movimiento
cli-gestures-score = puntos
cli-gestures-signal = señal
cli-gestures-repeats = se repite
cli-gestures-along = a la vez
cli-gestures-effort = esfuerzo
cli-gestures-false = fals./min
cli-gestures-answered = reconoc.
# What gestures are suggested for.
cli-control-faster = más rápido
cli-control-slower = más lento
cli-control-left = girar a la izquierda
cli-control-right = girar a la derecha
cli-control-stop = parar
# $source says what the calibration was learnt from. $hits and $false are such as: 93 ± 6.6
cli-prior-joint = { $joint }: { $source } (personas: { $people }, repeticiones propias: { $repetitions }); reconocidos que se esperan de 100 movimientos: { $hits }; activaciones falsas que se esperan por minuto: { $false }
cli-prior-joint-dropped = { $joint }: { $source } (personas: { $people }, repeticiones propias: { $repetitions }); reconocidos que se esperan de 100 movimientos: { $hits }; activaciones falsas que se esperan por minuto: { $false }; canales que apenas se mueven: { $channels }
# A ring is a band of sensors around an arm.
cli-ring-as-others = Anillo { $ring }: está colocado como en otras personas.
cli-ring-turned =
    { $places ->
        [one] Anillo { $ring }: está girado { $places } posición respecto a otras personas; la calibración lo tiene en cuenta.
       *[other] Anillo { $ring }: está girado { $places } posiciones respecto a otras personas; la calibración lo tiene en cuenta.
    }
cli-ring-mirrored =
    { $places ->
        [one] Anillo { $ring }: está del revés y girado { $places } posición respecto a otras personas; la calibración lo tiene en cuenta.
       *[other] Anillo { $ring }: está del revés y girado { $places } posiciones respecto a otras personas; la calibración lo tiene en cuenta.
    }
cli-map-guided-missing = --map guided, { $joint }: { $reason }
cli-map-prior-missing = --map prior, { $joint }: { $reason }
cli-map-needs-prior = --map prior: los movimientos de otras personas están en un prior, indíquelo con --prior
# $reason is a sentence
cli-map-fallback = { $joint }: { $reason } Conserva la calibración estándar.
cli-map-guided-not-better = { $joint }: lo aprendido de las indicaciones no es mejor en las repeticiones reservadas. Use --map best para conservar allí la calibración estándar.
cli-map-prior-worse = { $joint }: lo aprendido de otras personas es peor en las repeticiones reservadas. Use --map best para prescindir de ello allí.
cli-compare-title = En repeticiones pedidas que se reservaron, la calibración estándar y la aprendida de las indicaciones (guiada):
# Titles of columns, each over two figures: of the standard calibration and of the one learnt from the cues.
cli-compared-in-phase = coincide
cli-compared-time-driven = tiempo activo
cli-compared-false = falsos por min
# Whether the calibration learnt from the cues is offered: yes or no.
cli-compare-offered = se ofrece
cli-no-seconds = --{ $option } { $value }: indique un número de segundos
cli-nothing-there = --{ $start } { $first } --{ $end } { $last }: ahí no hay nada de { $signals }, que va de { $begins } a { $ends } s
cli-prior-problem = --prior { $file }: { $problem }

## prior: what is known of other people in the same shirt. An own prior has an entry for each person; a release has sums over people only, and may leave the clinic.

cli-prior-one-table-each = grabaciones: { $recordings }, tablas de movimientos pedidos: { $tables }; indique una tabla por cada grabación
cli-prior-add-to-release = { $prior } es una publicación, que contiene sumas de varias personas: añada al prior propio de la clínica
cli-prior-added =
    { $people ->
        [one] { $person }: entrada añadida a { $prior } (movimientos: { $strokes }), que ahora contiene { $people } persona
       *[other] { $person }: entrada añadida a { $prior } (movimientos: { $strokes }), que ahora contiene { $people } personas
    }
cli-prior-replaced =
    { $people ->
        [one] { $person }: entrada sustituida en { $prior } (movimientos: { $strokes }), que ahora contiene { $people } persona
       *[other] { $person }: entrada sustituida en { $prior } (movimientos: { $strokes }), que ahora contiene { $people } personas
    }
cli-prior-nobody = { $prior }: no contiene a ninguna persona “{ $person }”
cli-prior-removed = { $person }: entrada quitada de { $prior }
cli-prior-own =
    { $people ->
        [one] { $prior }: prior propio, una entrada por persona, { $people } persona en “{ $layout }”
       *[other] { $prior }: prior propio, una entrada por persona, { $people } personas en “{ $layout }”
    }
cli-prior-release = { $prior }: publicación, solo sumas, { $people } personas en “{ $layout }”
# Titles of columns.
cli-prior-movement = articulación y gesto
cli-prior-column-people = pers.
cli-prior-column-seconds = seg.
cli-prior-column-strokes = movim.
cli-prior-column-rate = velocidad
cli-prior-ranges = rangos de los canales, unidades de la señal
# The prompted movement of a joint.
cli-prior-prompted = { $joint }, pedido
cli-prior-rate-means = Velocidad de los movimientos: media y desviación durante un movimiento, como proporciones de la velocidad que cuenta como máximo
cli-prior-ring =
    { $people ->
        [one] Anillo { $ring }: se conoce su colocación en { $people } persona
       *[other] Anillo { $ring }: se conoce su colocación en { $people } personas
    }
cli-prior-too-few = Muy pocas para conducir: se necesitan { $people } personas por articulación
cli-prior-twice = { $prior } aparece dos veces: indique cada prior una sola vez
cli-prior-merged =
    { $people ->
        [one] { $people } persona en { $out }
       *[other] { $people } personas en { $out }
    }
cli-prior-released = { $people } personas en { $out }
# $names are codes of people, or names of joints, with commas between them
cli-prior-left-out = Se omiten las articulaciones con menos de ocho personas que todavía no están en ninguna publicación: { $names }
cli-prior-exported =
    { $people ->
        [one] { $people } persona en { $out }, con una entrada propia: no debe salir de la clínica.
       *[other] { $people } personas en { $out }, cada una con su entrada: no debe salir de la clínica.
    }
cli-prior-sums =
    { $people ->
        [one] { $people } persona en { $out }: solo sumas, que pueden salir de la clínica.
       *[other] { $people } personas en { $out }: solo sumas, que pueden salir de la clínica.
    }
cli-prior-sums-without =
    { $people ->
        [one] { $people } persona en { $out }: solo sumas, que pueden salir de la clínica. Se omiten las articulaciones con menos de ocho personas que todavía no están en ninguna publicación: { $names }.
       *[other] { $people } personas en { $out }: solo sumas, que pueden salir de la clínica. Se omiten las articulaciones con menos de ocho personas que todavía no están en ninguna publicación: { $names }.
    }
cli-prior-import-release = { $prior } es una publicación, que contiene sumas y ninguna entrada de personas: úsela con `calibrate --prior`, e importe el prior propio de la clínica
cli-prior-switched-off = La clínica ha desactivado que las calibraciones ayuden a pacientes nuevos: vea la página Ajustes
cli-prior-no-patient = { $prior }: en la clínica no hay ningún paciente “{ $code }”; no se ha importado a nadie
# In quotation marks: a consent, as the page of the patient calls it.
cli-prior-no-consent = { $prior }: el paciente “{ $code }” no ha dado su consentimiento para “{ consent-clinic-prior }”; no se ha importado a nadie
cli-prior-imported =
    { $people ->
        [one] { $people } persona importada de { $prior }
       *[other] { $people } personas importadas de { $prior }
    }
cli-prior-nobody-shares =
    { $people ->
        [one] La { $people } persona conocida en “{ $layout }” no ha dado su consentimiento para “{ consent-sharing }”: pídalo y anótelo en la página del paciente
       *[other] Ninguna de las { $people } personas conocidas en “{ $layout }” ha dado su consentimiento para “{ consent-sharing }”: pídalo y anótelo en la página de cada paciente
    }
cli-prior-nobody-known = En “{ $layout }” no se conoce a nadie: calibre con esa camiseta a pacientes que hayan dado su consentimiento para “{ consent-clinic-prior }”
cli-prior-code = El código de un paciente tiene caracteres que no se admiten en un prior: use solo letras, cifras, puntos y guiones
cli-prior-no-release = De quienes han dado su consentimiento para “{ consent-sharing }”: { $problem }
cli-prior-was-read = { $file } es un archivo que se leyó para esto: dé otro nombre al prior
cli-prior-unwritable = { $file } no se puede escribir ({ $reason }): elija otro lugar
cli-prior-person = --person { $person }: indique de 1 a 64 letras, cifras, puntos o guiones

## backup and restore. $time is a day with a time of day.

cli-backup-made =
    { $name }: { $files } archivos, { $size } MB, { $keys ->
        [with] con las claves de las sillas, las camisetas y la clínica
       *[without] sin las claves de las sillas, las camisetas y la clínica
    }, { $encrypted ->
        [yes] con cifrado
       *[no] sin cifrado
    }. Se ha leído de nuevo, y todas las huellas son correctas.
cli-backup-hash = Huella del conjunto: { $hash }
cli-backup-no-erased = No hay ningún archivo { $file }: indique la lista de pacientes borrados, u omita --erased.
cli-backup-clinic-open = La clínica de { $folder } está abierta: restaure en una carpeta vacía.
cli-restored-with-keys = La clínica, tal como era en { $time } UTC, está en { $folder }: { $files } archivos, { $size } MB, todos iguales según su huella. La copia contenía las claves de las sillas, las camisetas y la clínica.
cli-restored-without-keys = La clínica, tal como era en { $time } UTC, está en { $folder }: { $files } archivos, { $size } MB, todos iguales según su huella. La copia no contenía ninguna clave: vincule de nuevo las sillas y las camisetas.
cli-restored-erased =
    { $count ->
        [one] { $count } paciente que se borró desde entonces sigue borrado.
       *[other] { $count } pacientes que se borraron desde entonces siguen borrados.
    }
cli-backup-whole = { $name } está íntegra: { $files } archivos de { $time } UTC, todas las huellas son correctas.
cli-backup-is-folder = { $folder } es una carpeta de copias de seguridad: indique uno de sus archivos; el más reciente es { $newest }.
cli-no-backup = No hay ninguna copia de seguridad { $file }: indique un archivo.
cli-passphrase-needed = Esto necesita una frase de contraseña: póngala en la variable de entorno { $variable }.
# A question; a colon follows.
cli-passphrase = Frase de contraseña
cli-passphrase-short = Esta frase de contraseña es demasiado corta: use { $least } caracteres o más.
# The progress of making a backup, in two steps.
cli-backup-step-store = Copiando: { $done } de { $total } MB
cli-backup-step-verify = Comprobando: { $done } de { $total } MB
cli-backup-unlogged = La clínica es de otra versión que este comando, así que esta copia de seguridad no consta en su registro.

## report, export, archive, incident

cli-report-suffix = --out { $file } no termina en .pdf ni en .html: indique uno de los dos.
# $problem says in a sentence or two that the patient has not consented, and that a copy for the patient needs no consent
cli-report-for-patient = { $problem } Para una copia así, añada --for-patient.
cli-export-format = --format { $format }: indique uno de { $formats }.
cli-export-step = Grabación { $done } de { $total }
cli-archive-made = El archivo { $file } está escrito. Su huella es { $hash }.
cli-archive-imported = Se ha importado el paciente { $code }. Sesiones: { $sessions }. Ensayos terminados que cuentan: { $trials }.
cli-archive-replaced = Se ha sustituido el paciente { $code }. Sesiones: { $sessions }. Ensayos terminados que cuentan: { $trials }. El estado anterior del paciente se conserva 30 días en { $file }.
cli-archive-again = El paciente { $code } ya se había importado de este expediente: no ha cambiado nada.
cli-incident-key = --public-key se usa con --check: omítalo, o compruebe un archivo de incidente.
cli-incident-no-folder = No hay ninguna carpeta { $folder }: créela, o elija otro lugar.
# $start and $end are days with a time of day.
cli-incident-right = { $name }: archivos: { $files }, grabaciones: { $recordings }, de { $start } a { $end } UTC. Todas las huellas y la firma son correctas.
cli-incident-hash = Huella del manifiesto: { $hash }
cli-incident-fingerprint = Huella de la clave: { $fingerprint }
cli-incident-kept = Los pacientes de estas sesiones no se borran hasta que un administrador quite la marca (página Copias de seguridad).
