### Texts of the frame: header, rail, notices, sign-in.

app-name = bodydrive
app-title = { $page } · bodydrive
demo-tag = Demostración
demo-explained = Todo lo que hay aquí es una demostración: los pacientes y los ensayos se descartan al cerrar el programa.
stop = STOP
stop-label = Parar la silla ahora
stop-sent = Parada enviada.
stop-not-sent = La parada no llegó: apague la silla con su propio interruptor.
app-title-of = { $code }, { $part } · { $page } · bodydrive
who-open = sesión { $number } abierta
who-shown = en pantalla
who-shown-one = sesión { $number } en pantalla
who-shown-two = sesiones { $first } y { $second } en pantalla
busy-trial = Hay un ensayo en marcha. Aquí no se puede cambiar nada hasta que termine.
busy-trial-go = Ir al ensayo
busy-drive = La silla real está habilitada. Aquí no se puede cambiar nada hasta que termine la conducción.
busy-drive-go = Ir a la silla
busy-test = La prueba de dos minutos está en marcha. Aquí no se puede cambiar nada hasta que termine.
busy-test-go = Ir a la prueba
busy-run = Hay un paso de la calibración en marcha. Aquí no se puede cambiar nada hasta que termine.
busy-run-go = Ir a la calibración
who-nobody = Ninguna sesión abierta
lamp-shirt = Camiseta { $good } de { $all }
lamp-shirt-estimated =
    { $estimated ->
        [one] Camiseta { $good } de { $all }, { $estimated } estimado
       *[other] Camiseta { $good } de { $all }, { $estimated } estimados
    }
lamp-shirt-silent = Camiseta sin señal
lamp-shirt-unknown = Camiseta: sin datos
lamp-shirt-none = Sin camiseta
lamp-chair = Silla: virtual
lamp-chair-unknown = Silla: sin datos
lamp-screen =
    { $count ->
        [one] Pantalla del paciente
       *[other] { $count } pantallas del paciente
    }
lamp-screen-bad =
    { $count ->
        [one] Pantalla del paciente: sin imagen
       *[other] Una pantalla del paciente: sin imagen
    }
lamp-screen-away =
    { $count ->
        [one] Pantalla del paciente: sin conexión
       *[other] Una pantalla del paciente: sin conexión
    }
lamp-armed = Silla: habilitada
lamp-real = Silla real: { $state }
lamp-real-disarmed = deshabilitada
lamp-real-checking = espera reposo
lamp-real-armed = habilitada
lamp-real-fault = no está lista
lamp-real-silent = sin respuesta
theme-label = Colores: { $theme }. Cambiar
theme-system = los del sistema
theme-light = claros
theme-dark = oscuros
theme-contrast = alto contraste
theme-now = Colores: { $theme }.
help-open = ¿Para qué sirve esta página?
sign-out = Salir
rail-label = Los pasos de una sesión y los ajustes
rail-done = hecho
rail-sign-in = Entrar
rail-set-up = Configurar la clínica
rail-chair = Silla real
rail-patients = Pacientes
rail-shirt = Camiseta
rail-calibrate = Calibrar
rail-controls = Controles
rail-drive = Conducir
rail-review = Revisar
rail-settings = Ajustes
note-lost = Sin conexión con el programa desde las { $time }.
note-lost-why = La silla que se conduce desde esta página se detiene sola. La página sigue intentando enviar STOP; todo lo demás espera la conexión.
practice-simulator = Camiseta simulada:
practice-replay = Señales grabadas:
practice-other = Camiseta que no lleva nadie:
practice-only = solo práctica
session-other = Hay otra sesión abierta
session-opened = { $name } abrió la sesión del paciente { $code } en otra pantalla a las { $time }.
session-opened-somebody = La sesión del paciente { $code } se abrió en otra pantalla a las { $time }.
session-ended = La sesión del paciente { $code } se terminó en otra pantalla, y ahora no hay ninguna sesión abierta.
session-belongs = Lo que muestra esta página pertenece a { $code } y ya no se puede enviar.
session-over = Hay otra sesión abierta: no se ha enviado nada desde esta página.
session-drafts = Escrito aquí y sin enviar:
session-draft = { $label }: { $value }
session-go = Seguir con { $code }
session-patients = Ir a los pacientes
note-control = El proceso de control ha terminado; la silla está detenida.
note-control-why = Se está iniciando uno nuevo…
note-fault-continue = Continuar
note-fault-again = Nueva parada a las { $time }.
note-fault-others = El profesional que está junto a la silla comprueba el entorno y después toca Continuar.
note-fault-drive = La silla está detenida. “Continuar” está en la página que la muestra.
note-fault-drive-go = Ir a la conducción
note-fault-idle = No hay ningún ensayo ni conducción en marcha. Al anular la parada no se mueve nada, y después se puede empezar un ensayo nuevo.
note-fault-idle-go = Anular la parada
note-fault-idle-others = La silla está detenida. El profesional que está junto a la silla comprueba el entorno y después anula la parada.
note-driving = Se está conduciendo una silla real.
note-driving-go = Ir allí
note-warning-go = Ver las copias
note-fault-first = Sigue activa una parada o un fallo: vea la franja de arriba y anule allí primero la parada.
note-signed-out = Se ha cerrado su acceso: entre de nuevo.
error-no-answer = El programa no responde: compruebe si sigue en marcha e inténtelo de nuevo.
error-status = El programa rechazó la petición (código { $status }): vuelva a cargar la página.
error-page = No se pudo mostrar esta página.
error-other-page = Ir a “{ $page }”
try-again = Reintentar
undo = Deshacer
redo = Rehacer
cancel = Cancelar
back = Atrás
loading = Un momento…
sign-in-title = Entrar
sign-in-lead = Interfaz cuerpo-máquina para sillas de ruedas eléctricas.
sign-in-name = Nombre
sign-in-password = Contraseña
sign-in-go = Entrar
sign-in-invited = ¿Tiene una invitación, pero todavía no una contraseña? Abra el enlace de su invitación o escanee su código en este dispositivo.
typed-show = Mostrar
typed-show-label = Mostrar lo escrito
typed-hide = Ocultar
typed-hide-label = Ocultar lo escrito
sign-in-demo = Esto es una demostración: abra el enlace que el programa mostró en su consola. Con él entra directamente.
setup-title = Configurar esta clínica
setup-lead = En esta clínica todavía no hay ninguna persona. Usted será el primer administrador y podrá añadir personas.
setup-code = Código de configuración
setup-code-hint = El programa lo mostró en su consola al iniciarse.
setup-password-hint = Al menos { $count } caracteres. Una frase corta es fácil de recordar.
setup-go = Configurar y entrar
nobody-title = No hay ninguna sesión abierta
nobody-lead = Elija un paciente: así empieza una sesión, y esta página la muestra.
nobody-go = Elegir un paciente
# What a page shows instead of a patient whom somebody has deleted; $code: of the patient.
gone-title = Paciente eliminado
gone-lead = Se ha eliminado { $code }: ya no se puede ver ni cambiar nada de este paciente.

## The choice of the language. Each language has its own name, in all files the same.

language-title = Idioma
language-lead = De estas páginas, para usted y para este navegador.
language-screen = Idioma de la pantalla del paciente
language-of-browser = El del navegador de la pantalla
language-en = English
language-es = Español
language-de = Deutsch
