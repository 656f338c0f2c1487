### Refusals of requests, and what the pages show of the server's state: signing in, roles, addresses, files, floor plans,
### screens, replays, this computer.

## Signing in

api-locked = Esta página está bloqueada: escriba la contraseña, o deje que entre otra persona.
api-not-signed-in = Su acceso no está abierto, o ya no lo está: entre de nuevo.
api-reviewer-changes-nothing = Un revisor lee y comenta, y no cambia nada más: pida más permisos a un administrador.
api-reviewer-exports-nothing = Un revisor no saca ningún historial de la clínica: pida un informe o una exportación a un profesional.
api-only-owners = Solo los administradores de la clínica cambian esto: pídaselo a uno de ellos.
api-link-wrong = Este enlace es incorrecto, ya se usó o tiene más de { $hours } horas: pida uno nuevo a un administrador.
api-person-disabled = Esta persona ya no puede entrar: consulte a un administrador.
api-no-demonstration = Esto no es una demostración: entre con su nombre y contraseña.
api-other-demonstration = Este enlace es de otra demostración: abra el último enlace que mostró el programa.
api-set-up-already = Esta clínica ya está configurada: entre con su nombre y contraseña.
api-set-up-code-wrong = Este código es incorrecto, ya se usó o tiene más de { $minutes } minutos: reinicie el programa para obtener uno nuevo.
api-passwords-not-checked = En este momento no se pueden comprobar las contraseñas: inténtelo de nuevo.
api-sign-in-wrong = El nombre o la contraseña no son correctos: inténtelo de nuevo, o pida una contraseña nueva a un administrador.
# $name is the name of the person who is signed in.
api-password-not-own = Esa no es la contraseña de { $name }: inténtelo de nuevo, o pida una nueva a un administrador.
api-sign-in-busy = En este momento están entrando demasiadas personas: espere unos segundos e inténtelo de nuevo.
api-password-short = Esta contraseña es demasiado corta: use { $least } caracteres como mínimo.
api-password-long = Esta contraseña es demasiado larga: use { $most } caracteres como máximo.
api-password-common = Esta contraseña es de las primeras que probaría cualquiera: elija otra.
api-tries-name =
    { $seconds ->
        [one] Demasiadas contraseñas incorrectas para este nombre: espere { $seconds } segundo, o entre desde donde ya haya entrado antes.
       *[other] Demasiadas contraseñas incorrectas para este nombre: espere { $seconds } segundos, o entre desde donde ya haya entrado antes.
    }
api-tries-here =
    { $seconds ->
        [one] Desde aquí llegaron demasiadas contraseñas incorrectas: espere { $seconds } segundo e inténtelo de nuevo.
       *[other] Desde aquí llegaron demasiadas contraseñas incorrectas: espere { $seconds } segundos e inténtelo de nuevo.
    }
api-tries-code =
    { $seconds ->
        [one] Desde aquí llegaron demasiados códigos incorrectos: espere { $seconds } segundo e inténtelo de nuevo.
       *[other] Desde aquí llegaron demasiados códigos incorrectos: espere { $seconds } segundos e inténtelo de nuevo.
    }

## Addresses and requests

api-address-not-ours = Esta dirección no es de este programa: abra el enlace que mostró el programa.
api-not-our-page = Esta petición no procede de una página de este programa: abra la página e inténtelo de nuevo.
api-too-large = Esto es demasiado grande: envíe aquí { $megabytes } MB como máximo.
api-too-many-files = En este momento están llegando otros archivos: espere a que terminen de llegar e inténtelo de nuevo.
api-too-slow = Esto llega demasiado despacio, así que se interrumpió: lleve este dispositivo adonde la red llegue mejor e inténtelo de nuevo.
api-not-the-proxy = A este programa solo se llega a través del proxy de la clínica: abra la dirección del proxy.
api-proxy-incomplete = El proxy no indica quién envió esta petición: haga que fije X-Forwarded-For, X-Forwarded-Proto y X-Forwarded-Host, cada uno una sola vez, como en docs/proxy.
api-proxy-not-encrypted = La petición llegó al proxy sin cifrado: haga que el proxy responda solo por https, y abra su dirección https.
# $none is a word of the interface for programs, $header the name of a header.
api-session-unnamed = La petición no indica la sesión que muestra su página: envíe el id de esa sesión, o “{ $none }” mientras no haya ninguna abierta, en el encabezado { $header }.
api-link-only-here = Solo este equipo puede abrir el enlace, porque el programa no atiende a ningún otro.
api-link-only-in-network = El enlace solo se abre en la red o la VPN de la propia clínica: desde otro lugar hace falta un proxy (página para el departamento de informática).
api-screen-only-here = Solo este equipo puede abrir el enlace, porque el programa no atiende a ningún otro. Para usar otra pantalla, cierre el programa e inícielo con bodydrive serve --lan.
api-this-machine-only = Este programa atiende solo a este equipo: ciérrelo e inícielo con bodydrive serve --lan.
api-only-tablet-page = Por http solo está la página que explica cómo conectarse: abra / en esta dirección.
api-own-certificate = Esta clínica tiene un certificado propio: no hay nada que instalar.

## Driving

api-far = La silla solo se pone en movimiento desde una pantalla del edificio, conectada sin nada en medio: vaya junto a la silla y abra allí la página.
api-another-controller = Otra persona inició esta conducción, y solo esa persona la continúa o la termina aquí: usted puede detenerla y preguntar a esa persona.
api-no-picture = Esta pantalla no tiene imagen, y nadie conduce a ciegas: espere a que aparezca la vista 3D, o elija el plano dibujado en la página Conducir.
api-no-picture-for-patient = La pantalla del paciente no tiene imagen, y nadie conduce a ciegas: espere a que la tenga, o desvincule esa pantalla.
api-patients-screen-away = No hay conexión con la pantalla del paciente, que se usa en este ensayo: restablézcala, o desvincule esa pantalla, y después toque Continuar.
api-process-restarting = El proceso de control se está reiniciando.
api-controls-changed = Mientras tanto se cambiaron los controles o el documento de la silla: lea de nuevo qué se aplica y después habilite la silla.
api-not-in-view = Esta pantalla todavía no ha indicado que está a la vista: espere un momento y habilite la silla otra vez.
api-trial-on-real-chair = Está elegida una silla real: para un ensayo, elija la virtual.
# $name is the name of a path in the program.
api-no-path = Este plano no tiene ningún recorrido “{ $name }”: elija uno de la lista.
api-no-view = Sin una sesión abierta no hay vista 3D: abra primero una sesión.

## Calibration and controls

# Title of the last step of a calibration.
api-result = Resultado
api-result-instruction = Revise cada articulación. Repita lo que no sea lo bastante bueno y después toque “Usar esta calibración”.
api-calibration-busy = Se está grabando un paso o calculando la calibración: espere a que termine.
api-calibration-in-use = Esta calibración ya está en uso: siga a los controles, o repita un paso.
# Begins a sentence on what is wrong in a set of controls.
api-the-controls = Los controles

## Review

api-replay-while-driving = Alguien está conduciendo: elija Plano, o espere a que termine la conducción.
api-no-replay = No hay imagen de este ensayo: su grabación no se puede leer, o no indica ningún lugar.
api-replay-closed = Esta reproducción se cerró: ábrala de nuevo.
api-trial-still-running = Este ensayo todavía está en marcha: véalo cuando haya terminado.
api-recording-unreadable = La grabación de este ensayo no se puede leer: restáurela desde una copia de seguridad.
# Follows the name of what was sent. $measures are names of measures in the program.
api-no-measure = esto no es una medida: use una de estas, { $measures }
api-trials-not-comparable = Estos dos ensayos difieren en el paciente, la tarea o el origen, así que ninguno se califica de mejor.

## Floor plans and objects

# $problem says what is wrong in the file of the plan, and what to do, without a full stop.
api-plan-unusable = El plano “{ $name }” no se puede usar: { $problem }; después guárdelo o impórtelo de nuevo.
api-no-plan = No hay ningún plano “{ $name }”: elija uno de la lista.
# Begins a sentence on what is wrong in a floor plan.
api-the-plan = El plano
# $problem is a sentence without its full stop: what is wrong, and what to do.
api-problem = { $problem }.
api-plan-too-many-parts = El plano tiene más de { NUMBER($count, useGrouping: 1) } puntos y objetos: simplifíquelo.
api-plan-other-name = El plano, name: no es “{ $name }”, como en la dirección: corríjalo.
api-plan-unreadable = Este plano ya no se puede leer: guárdelo de nuevo tal como se dibujó.
api-options-not-json = La importación, options: esto no es JSON, corríjalo.
# $endings are endings of file names.
api-wrong-plan-file = “{ $name }” no es de ninguno de estos tipos: { $endings }. Guárdelo como uno de ellos y añádalo otra vez.
api-plan-too-large = “{ $name }” ocupa más de { $megabytes } MB: hágalo más pequeño y añádalo otra vez.
api-map-too-large = “{ $name }” ocupa más de 100 kB: hágalo más pequeño y añádalo otra vez.
api-map-incomplete = Un mapa de ROS son dos archivos: elija juntos su .yaml y su imagen.
api-map-picture-alone = Una imagen .pgm pertenece a un mapa: elija también su archivo .yaml.
api-one-plan-at-a-time = Los planos se crean de uno en uno: elija un solo archivo, o los dos de un mapa.
api-no-glb = “{ $name }” no es un archivo GLB: exporte el objeto como glTF binario (.glb).
api-glb-too-large = “{ $name }” ocupa más de { $megabytes } MB: simplifique el objeto.
api-too-many-objects = Ya hay { $count } objetos: elimine algunos de la carpeta “models”.

## Files of signals and bodies

api-wrong-upload = “{ $name }” no es un archivo CSV ni Parquet: guárdelo como uno de los dos y añádalo otra vez.
api-upload-too-large = “{ $name }” ocupa más de { $megabytes } MB: recórtelo, o guárdelo como Parquet.
api-upload-empty = “{ $name }” está vacío: elija otro archivo.
# Begins a sentence on what is wrong in what a person has corrected.
api-the-import = La importación
# A choice among joints: of channels whose names say no part of the body.
api-joint-body = Cuerpo, como una sola articulación
api-one-recording = Las grabaciones se importan de una en una: elija un solo archivo, o el de BIDS-motion con su _channels.tsv y su _motion.json.
# $count is a count of numbers in the file.
api-upload-columns = “{ $name }” no tiene una columna de tiempos (t) con canales al lado, o contiene más de { NUMBER($count, useGrouping: 1) } números: una fila encima de los números debe nombrar el tiempo y cada canal.
# $problem is the reason that the operating system gives.
api-upload-not-kept = “{ $name }” no se puede guardar ({ $problem }): libere espacio en el disco y añádalo otra vez.

## This computer

api-measuring-while-busy = Hay una silla habilitada o se está grabando algo, y la medición quita tiempo al bucle de control: mida cuando eso haya terminado.
api-measuring-interrupted = Se habilitó una silla o empezó una grabación, y la medición terminó, porque quita tiempo al bucle de control: mida de nuevo cuando eso haya terminado.
api-measuring-already = Este equipo ya se está midiendo: espere a que termine la medición.
api-measuring-failed = No se pudo medir este equipo: inténtelo de nuevo, o ejecute en él “bodydrive check” para ver por qué.
# The name of a screen: begins a sentence on how many pictures a second it draws. $name is the name of a person.
api-page-of = La página de { $name }
# The name of a screen: begins a sentence on how many pictures a second it draws.
api-patients-screen = Una pantalla del paciente
