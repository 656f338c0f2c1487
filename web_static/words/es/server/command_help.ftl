### The help of the command line, `bodydrive COMMAND --help`. Each message is one line without values.
### Words that begin with --, words in capitals and names of files are typed on the command line: they are not translated.

## Every command

cli-help-program = Interfaz cuerpo-máquina para sillas de ruedas eléctricas: calibrar, practicar, medir, conducir.
cli-help-version = Mostrar qué versión es esta y terminar.
cli-help-state = La carpeta de la base de datos y las grabaciones de la clínica.
cli-help-json = Mostrar un único objeto JSON y nada más.

## demo and serve

cli-help-demo = Abrir una clínica de demostración que no se guarda: una camiseta simulada, un paciente y la silla virtual.
cli-help-serve = Abrir una clínica; su base de datos y sus grabaciones se conservan.
cli-help-port = El puerto en el que escuchar; 0 toma cualquiera que esté libre.
cli-help-demo-host = La dirección en la que escuchar, una que sea solo de este equipo.
cli-help-demo-floorplan = Un plano propio en el que también se pueda conducir.
cli-help-serve-host = La dirección en la que escuchar; con --lan, una o varias de este equipo en vez de todas.
cli-help-serve-lan = Abrir la clínica a las tabletas de esta red, por https.
cli-help-serve-certificate = Un certificado propio para --lan: un archivo PEM, con su cadena.
cli-help-serve-key = La clave privada de ese certificado: un archivo PEM.
cli-help-serve-behind-proxy = La dirección del proxy inverso de la clínica, la única entrada; necesita --name.
cli-help-serve-name = El nombre, o NAME:PORT, con el que los navegadores llegan al proxy.
cli-help-serve-lsl = Enviar comandos, gestos y marcas a LabRecorder por LSL; cualquiera en la red puede leerlos.

## check and service

cli-help-check = Medir lo que ofrece este equipo y decir si basta para conducir; código de salida 1 si no basta.
cli-help-check-seconds = Durante cuánto tiempo medir el bucle.
cli-help-check-own-port = Un puerto de la clínica que está en marcha, en vez de los dos habituales.
cli-help-service = Hacer que el equipo inicie la clínica por sí solo.
cli-help-service-install = Instalar una unidad de systemd que ejecuta `bodydrive serve --lan`, e iniciarla.
cli-help-service-install-system = Una unidad del sistema, que se inicia con el equipo; necesita sudo.
cli-help-service-install-account = Con --system: la cuenta propietaria de la clínica, que no sea root.
cli-help-service-install-print = Mostrar la unidad y no cambiar nada.

## calibrate and decode. A column of a CSV file, such as start, is not translated.

cli-help-signals = CSV, Parquet, XLSX, MATLAB, C3D, EDF, XDF o BVH, o la carpeta de una grabación.
cli-help-signals-command = Mostrar qué contiene un archivo de señales antes de usarlo.
cli-help-signals-show = Mostrar qué contiene un archivo de señales: columnas, tiempo con su unidad, frecuencia de muestreo, canales y articulaciones.
cli-help-signals-layout = La disposición de la camiseta, JSON; sin esta opción, la que está junto al archivo.
cli-help-signals-out = Dónde se escriben las señales tal como se leen: un archivo .parquet con t en segundos.
cli-help-signals-time = La columna de los tiempos; vacía si ninguna es correcta y cuenta --rate.
cli-help-signals-unit = La unidad de los tiempos: s, ms, us, ns, min, h o d.
cli-help-signals-rate = La frecuencia de muestreo, Hz: las muestras son uniformes, digan lo que digan sus tiempos.
cli-help-signals-channels = Las columnas de los canales, en el orden de la disposición.
cli-help-signals-part = El flujo o la hoja que se lee por separado, por su nombre.
cli-help-layout = La disposición de la camiseta, JSON.
cli-help-calibrate = Ajustar un perfil de calibración a un archivo de señales: de cada articulación, su movimiento principal, rango, signo y umbrales.
cli-help-calibrate-out = Dónde se escribe el perfil de calibración, JSON.
cli-help-calibrate-prompts = CSV start,end,joint: cuándo se movió qué articulación hacia su gesto; cada fila cuenta. Fija el signo.
cli-help-calibrate-from = Dónde empieza el movimiento libre, s.
cli-help-calibrate-to = Dónde termina el movimiento libre, s.
cli-help-calibrate-rest-from = Dónde empieza el reposo, s.
cli-help-calibrate-rest-to = Dónde termina el reposo, s.
cli-help-calibrate-unused = Un canal que no se debe usar; la opción se puede repetir.
cli-help-calibrate-prior = Lo que `bodydrive prior` escribió de otras personas con la misma camiseta.
cli-help-calibrate-map = Con qué calibración se conduce: la estándar, la aprendida de las indicaciones, la de otras personas o la mejor.
cli-help-calibrate-gestures = Ordenar por calidad todos los gestos encontrados, de ida y de vuelta, y proponer cuatro.
cli-help-decode = Decodificar un archivo de señales exactamente como lo hace el bucle de control.
cli-help-decode-profile = Lo que escribió `bodydrive calibrate`, o una configuración guardada.
cli-help-decode-out = Dónde se escriben los comandos: .parquet o .csv.
cli-help-decode-dead-zone = Desde dónde cuenta cada gesto, en movimientos completos por segundo.
cli-help-decode-cutoff = Atenuación del temblor, Hz: un valor más bajo atenúa más.

## prior

cli-help-prior = Aprender de otras personas con la misma camiseta, para que alguien nuevo conduzca antes de su calibración.
cli-help-prior-file = El prior; se crea si no existe.
cli-help-prior-person = Un código de la persona: letras, cifras, puntos y guiones, ningún nombre.
cli-help-prior-add = Añadir las grabaciones de una persona a un prior. Si la persona ya está en él, se sustituye.
cli-help-prior-add-signals = CSV, Parquet o la carpeta de una grabación; todas las grabaciones de la persona.
cli-help-prior-add-prompts = CSV start,end,joint: cuándo se movió qué articulación hacia su gesto. Uno por cada uno de SIGNALS.
cli-help-prior-add-from = Dónde empiezan diez segundos de movimiento libre, s.
cli-help-prior-remove = Quitar a una persona de un prior, como si nunca se hubiera añadido.
cli-help-prior-show = Mostrar, por articulación y gesto, lo que sabe un prior: personas, segundos, movimientos y su velocidad, rangos de los canales.
cli-help-prior-merge = Unir priors. El resultado contiene sumas de ocho personas o más, y la entrada de nadie: puede salir de la clínica.
# A further paragraph.
cli-help-prior-merge-released = Un prior propio recuerda a quiénes se publicó, porque nadie puede estar en dos publicaciones: de un prior que ha crecido solo se publica a las personas nuevas, y las publicaciones se unen. Para eso se escriben de nuevo los archivos de los priors propios que se publican.
cli-help-prior-merge-priors = Priors propios o publicaciones.
cli-help-prior-merge-out = Dónde se escribe el resultado: un archivo .json.
cli-help-prior-merge-own = Conservar una entrada por persona. El resultado no debe salir de la clínica.
cli-help-prior-export = Escribir lo que la clínica sabe de los pacientes con una camiseta puesta. Sin --release no debe salir de la clínica.
cli-help-prior-export-out = Dónde se escribe el prior.
cli-help-prior-export-layout = La disposición de la camiseta puesta, JSON.
cli-help-prior-export-release = Solo sumas de ocho personas o más, todas con consentimiento para compartir.
cli-help-prior-import = Incorporar el prior propio de una clínica: para todas sus personas, o para ninguna. Lo que se sabe de ellas se sustituye.
cli-help-prior-import-file = El prior propio de una clínica, como lo escribe `export`.

## score, study, replay and floorplan

cli-help-score = Medir una trayectoria respecto a un recorrido indicado; s y m.
# A further paragraph.
cli-help-score-following = Si la trayectoria no termina más adelante en el recorrido de donde empezó, ni en su meta, no tiene medidas de cómo lo sigue. Dos vueltas alrededor de un mismo lugar en sentidos opuestos se anulan en el área fuera del recorrido; la distancia recorrida cuenta ambas.
cli-help-score-trajectory = CSV o Parquet con las columnas t, x, y; TUM, EuRoC o KITTI; un bag de ROS o MCAP.
cli-help-score-path = CSV o Parquet con las columnas x, y: los puntos del recorrido.
cli-help-score-goal-radius = A qué distancia del final del recorrido este cuenta como alcanzado, m.
cli-help-study = Hacer que una persona simulada calibre y conduzca después un recorrido una y otra vez, y medir cada ensayo.
cli-help-study-out = Carpeta en la que escribir; debe ser nueva o estar vacía.
cli-help-study-trials = Cuántas veces se conduce el recorrido: 22, o 3 por sesión.
cli-help-study-seed = La misma semilla da los mismos números.
cli-help-study-seeds = Cuántas personas, a partir de --seed.
cli-help-study-floorplan = Nombre de un plano que viene con el programa, o un archivo JSON.
cli-help-study-path = Nombre de un recorrido del plano; si no se indica, el primero.
cli-help-study-format = De las figuras; none las omite.
cli-help-study-no-learning = Nada de lo que se practica permanece.
cli-help-study-overwrite = Sustituir lo que contiene la carpeta.
cli-help-study-adapt = En varias sesiones: hacer que la calibración siga a la persona, comparada con una fija.
cli-help-study-person = En varias sesiones: qué les ocurre al cuerpo o a la camiseta.
cli-help-study-map = Con --adapt: la calibración estándar, o lo que enseñan las indicaciones u otras personas.
cli-help-study-sessions = Cuántas, con --adapt o --interface-test.
cli-help-study-interface-test = En varias sesiones: la prueba de dos minutos antes de los ensayos de cada una.
cli-help-study-jobs = Procesos a la vez; si no se indica, tantos como procesadores.
cli-help-replay = Enviar una grabación como lo haría una camiseta: sus muestras como datagramas, en sus propios tiempos. Ctrl-C lo termina.
cli-help-replay-recording = Carpeta de una grabación, CSV o Parquet.
cli-help-replay-to = Adónde van los datagramas, HOST:PORT.
cli-help-replay-loop = Empezar de nuevo al final.
cli-help-replay-speed = Por cuánto se multiplica la velocidad de la grabación.
cli-help-floorplan = Mostrar los lugares que vienen con el programa, comprobar uno, o crear uno a partir de un archivo.
cli-help-floorplan-import = Crear un plano a partir de un mapa de ROS, un dibujo DXF o una imagen: paredes y un recorrido para conducir.
cli-help-floorplan-import-file = MAP.yaml de un mapa de ROS, un dibujo DXF, o una imagen PNG o JPEG.
cli-help-floorplan-import-out = Dónde se escribe el plano: un archivo .json.
cli-help-floorplan-import-name = El nombre del plano: letras, cifras, puntos, guiones.
cli-help-floorplan-import-title = El título que leen las personas.
# The units are typed.
cli-help-floorplan-import-unit = De un dibujo que no la indica: mm, cm, m, inch o foot.
cli-help-floorplan-import-layer = Una capa del dibujo con paredes; la opción se puede repetir.
cli-help-floorplan-import-metres-per-pixel = La escala de una imagen.
cli-help-floorplan-import-width = O el ancho de toda la imagen, m.
cli-help-floorplan-import-threshold = Un píxel más claro que esta fracción del blanco está libre.
cli-help-floorplan-import-outside = Un mapa o una imagen: usar también lo que se alcanza desde su borde.
cli-help-floorplan-list = Mostrar lo que viene con el programa para conducir: escenas por nivel, edificios, y sus tareas.
cli-help-floorplan-check = Decir si se puede conducir en un plano o una escena y, si no, qué está mal y dónde.
cli-help-floorplan-check-file = Un plano o una escena.

## chair and shirt

cli-help-chair = Vincular una silla real; recibir en la silla lo que ha de conducir.
cli-help-chair-receive = En la silla: comprobar los comandos, vigilar el tiempo, cambiar las velocidades poco a poco y accionar una salida.
cli-help-chair-measure = En la silla: medir con recorridos cortos qué velocidad da cada desviación de su joystick.
cli-help-chair-rehearse = Ensayar sin silla: habilitar, conducir, parar, pulsar el interruptor y desconectar los cables de una silla emulada.
cli-help-chair-rehearse-record = Cada paso dice qué debe ocurrir y en cuántos milisegundos. El registro se firma con la clave de la silla.
cli-help-chair-rehearse-key-file = La clave de la silla, tal como la creó la vinculación.
cli-help-chair-rehearse-out = Dónde se guarda el registro: un archivo .json; a su lado queda un archivo .md para leer.
cli-help-chair-rehearse-who = Quién lo hace: figura en el registro.
cli-help-chair-rehearse-output = Qué se emula: sim o whill.
cli-help-chair-rehearse-verify = Comprobar en su lugar el registro de --out: si está tal como se firmó.
cli-help-chair-pair = Crear una clave para una silla, guardarla con la clínica y mostrarla una vez como código QR.
# A further paragraph.
cli-help-chair-pair-units = Las velocidades se dan en m/s y rad/s, las aceleraciones en m/s2 y rad/s2, los tirones en m/s3 y rad/s3.
cli-help-chair-pair-name = Cómo llaman las personas a la silla.
cli-help-chair-pair-host = La dirección por la que este equipo llega a la silla.
cli-help-chair-pair-port = El puerto en el que escucha su receptor.
# Of a speed, an acceleration or a jerk.
cli-help-chair-pair-limit = Lo máximo que puede hacer esta silla; si no se indica, un valor prudente.
cli-help-shirt = Vincular una camiseta por la red; enviar como lo hace una camiseta así.
cli-help-shirt-send = Enviar un archivo u ondas lentas como lo hace una camiseta vinculada: el ejemplo para el firmware de una camiseta.
cli-help-shirt-pair = Crear una clave para una camiseta, guardarla con la clínica y mostrarla una vez como código QR.

## people, log and about

cli-help-people = Ver, invitar, desactivar y activar a las personas de una clínica; crear un enlace para una contraseña nueva.
cli-help-people-name = El nombre con el que entra la persona.
# The roles are typed.
cli-help-people-role = owner, clinician o reviewer.
cli-help-people-patient = El código de un paciente que puede ver un revisor, una vez por cada uno; si no se indica, todos.
cli-help-people-address = La dirección de las páginas, para el enlace; si no se indica, la del programa en marcha.
cli-help-people-list = Mostrar las personas de la clínica: nombre, función, qué puede ver un revisor, si pueden entrar.
cli-help-people-invite = Añadir a una persona y mostrar el enlace con el que elige una contraseña en 24 horas.
# A further paragraph.
cli-help-people-invite-again = Para quien ya está, el enlace crea una contraseña nueva; la función y los pacientes no cambian.
cli-help-people-disable = No dejar entrar más a una persona; sus páginas abiertas se cierran en menos de 5 s.
cli-help-people-enable = Dejar entrar de nuevo a una persona desactivada.
cli-help-log = Consultar el registro de una clínica: quién hizo qué, y cuándo.
cli-help-log-verify = Comprobar que ninguna fila del registro se modificó, movió, insertó o quitó; la clínica puede estar abierta mientras tanto.
# A further paragraph.
cli-help-log-verify-exit = El código de salida es 0 si el registro está íntegro, 1 si se alteró, 2 si no se puede leer.
cli-help-about = Decir qué versión es esta, cómo se construyó y qué paquetes usa.
cli-help-about-licences = Mostrar sus paquetes y las obras de otros que hay en sus archivos, con licencias.

## report, export, archive, backup, restore and incident

cli-help-patient = El código del paciente.
cli-help-report = Escribir el informe de una sesión de un paciente, o de todas; la clínica puede estar abierta mientras tanto.
cli-help-report-out = El archivo que se escribe; termina en .pdf o .html.
cli-help-report-session = El número de una sesión; si no se indica, la evolución de todas.
cli-help-report-letter = Papel de tamaño carta en vez de A4.
cli-help-report-for-patient = Una copia para el paciente: no necesita consentimiento para compartir fuera.
cli-help-report-language = El idioma del informe; si no se indica, el del terminal.
cli-help-export = Exportar las grabaciones y medidas de un paciente; la clínica puede estar abierta mientras tanto. El paciente debe haber dado su consentimiento.
cli-help-export-out = El archivo zip que se escribe.
cli-help-export-format = El formato de los archivos que contiene.
cli-help-export-session = El número de una sesión; si no se indica, todas.
cli-help-archive = Llevar todo lo de un paciente a otra clínica: sesiones, controles, ensayos, grabaciones.
cli-help-archive-make = Escribir el expediente de un paciente, que debe haber dado su consentimiento; la clínica puede estar abierta mientras tanto.
cli-help-archive-make-out = El expediente que se escribe.
cli-help-archive-import = Importar un expediente; el mismo otra vez no cambia nada.
cli-help-archive-import-file = El expediente.
cli-help-archive-import-replace = Sustituir al paciente que ya está aquí; antes se guarda un expediente suyo.
cli-help-backup = Hacer una copia de seguridad de una clínica, también mientras está abierta, y comprobarla; en una carpeta solo se escribe lo nuevo.
cli-help-backup-file = El archivo que se crea, o una carpeta de copias.
cli-help-backup-encrypt = Cifrar la copia con una frase de contraseña, que se pide o está en BODYDRIVE_PASSPHRASE.
cli-help-backup-with-keys = Copiar también las claves de las sillas y de la clínica.
cli-help-backup-check = No crear ninguna: leer la copia FILE y comprobarla entera.
cli-help-restore = Restaurar una clínica en una carpeta vacía: cada archivo con la misma huella, sin los pacientes que se borraron desde entonces.
cli-help-restore-file = Una copia; de una carpeta de copias, uno de sus archivos.
cli-help-restore-erased = Un erased-patients.json más reciente, para que esos pacientes sigan borrados.
cli-help-incident = Archivar con firma el registro, las grabaciones, los parámetros y las versiones de las últimas 24 horas, y marcarlos para que se conserven.
cli-help-incident-file = El archivo que se crea o, con --check, que se lee.
cli-help-incident-check = No crear ninguno: comprobar cada huella y la firma del archivo FILE.
cli-help-incident-public-key = Con --check: la clave pública de la clínica (PEM), no la que hay dentro.
