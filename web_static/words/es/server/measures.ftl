### Measures of trials and of the two-minute test: their names, and what they measure.

# A level, as in "1.23 m²": $unit stands in no catalogue, because units are written alike in every language.
measure-with-unit = { $figure } { $unit }
measure-degrees = { $figure }°
# A difference of two shares, as in "fell by about 12 percentage points". $count is that number, $figure how it is written.
measure-points =
    { $count ->
        [one] { $figure } punto porcentual
       *[other] { $figure } puntos porcentuales
    }
measure-number = { $figure }

## Measures of a trial. The message that ends in "-subject" is the measure within a sentence, as in "Within noise over 12
## trials: the area off the path was about 1.23 m²." The one that ends in "-definition" says for exports what is measured.

measure-stages-done = Etapas hechas
measure-stages-done-subject = el número de etapas hechas
measure-stages-done-definition = Número de etapas hechas
measure-follow-error-rms = Error habitual de la distancia al guía
measure-follow-error-rms-subject = el error habitual de la distancia al guía
measure-follow-error-rms-definition = Media cuadrática del error de la distancia al guía
measure-follow-error-max = Error máximo de la distancia al guía
measure-follow-error-max-subject = el error máximo de la distancia al guía
measure-follow-near = Proporción del tiempo cerca de la distancia pedida
measure-follow-near-subject = la proporción del tiempo cerca de la distancia pedida
measure-heading-error-deg = Desviación de la orientación pedida
measure-heading-error-deg-subject = la desviación de la orientación pedida
measure-heading-error-deg-definition = Error de la orientación
measure-turn-drift = Desplazamiento fuera del punto
measure-turn-drift-subject = el desplazamiento fuera del punto
measure-turn-drift-definition = Distancia máxima al lugar del giro
measure-cones-touched = Conos tocados
measure-cones-touched-subject = el número de conos tocados
measure-cones-touched-definition = Número de conos tocados
measure-gap-clearance = Margen más estrecho en un hueco
measure-gap-clearance-subject = el margen más estrecho en un hueco
measure-gap-clearance-definition = Margen mínimo en los huecos
measure-door-contacts = Contactos con puertas o huecos
measure-door-contacts-subject = el número de contactos con puertas o huecos
measure-door-contacts-definition = Número de contactos en puertas
measure-e-diff = Área fuera del recorrido
measure-e-diff-subject = el área fuera del recorrido
measure-e-diff-definition = Área entre la trayectoria y el recorrido
measure-dist = Distancia recorrida
measure-dist-subject = la distancia recorrida
measure-time = Tiempo
measure-time-subject = el tiempo de un ensayo
measure-time-definition = Tiempo hasta la meta
measure-dist-ratio = Distancia respecto a la longitud del recorrido
measure-dist-ratio-subject = la distancia recorrida respecto a la longitud del recorrido
measure-dist-ratio-definition = Distancia recorrida dividida por la longitud del recorrido
measure-cross-track-rms = Distancia habitual al recorrido
measure-cross-track-rms-subject = la distancia habitual al recorrido
measure-cross-track-rms-definition = Media cuadrática de la distancia al recorrido
measure-cross-track-max = Distancia máxima al recorrido
measure-cross-track-max-subject = la distancia máxima al recorrido
measure-mean-speed = Velocidad media
measure-mean-speed-subject = la velocidad media
measure-stops = Paradas
measure-stops-subject = el número de paradas
measure-stops-definition = Número de paradas
measure-collisions = Contactos
measure-collisions-subject = el número de contactos con paredes y obstáculos
measure-collisions-definition = Número de colisiones
measure-contact-time = Tiempo en contacto
measure-contact-time-subject = el tiempo en contacto con paredes y obstáculos
measure-contact-time-definition = Tiempo en contacto con paredes y obstáculos
measure-turn-reversals = Cambios de giro
measure-turn-reversals-subject = el número de cambios entre giros a la izquierda y a la derecha
measure-turn-reversals-definition = Número de inversiones del comando de giro
measure-pulses-per-metre = Comandos por metro
measure-pulses-per-metre-subject = el número de comandos por metro
measure-pulses-per-metre-definition = Número de comandos por metro
measure-sparc = Fluidez
measure-sparc-subject = la fluidez de la velocidad (un valor mayor es más fluido)
measure-sparc-definition = Fluidez: longitud de arco espectral
measure-ldlj = Fluidez, otra medida
measure-ldlj-subject = otra medida de la fluidez de la velocidad (un valor mayor es más fluido)
measure-ldlj-definition = Fluidez: logaritmo del jerk adimensional

## What interrupted a trial.

measure-halts = Detenciones por la máquina
measure-halts-definition = Número de detenciones por la máquina; ninguna otra medida incluye su tiempo
measure-halt-time = Tiempo de detención por la máquina
measure-pauses = Pausas por la pantalla
measure-pauses-definition = Número de pausas debidas a la pantalla
measure-pause-time = Tiempo en pausa por la pantalla
measure-pause-time-definition = Tiempo en pausa debido a la pantalla
measure-person-stops = Paradas por una persona
measure-person-stops-definition = Número de paradas por una persona
measure-person-stop-time = Tiempo de parada por una persona

## What the measures of a trial are of.

measure-path-length = Longitud del recorrido
measure-cross-track-mean = Distancia media al recorrido, izquierda positiva
measure-stages = Etapas
measure-cones = Conos
measure-gaps = Huecos

## Measures of the two-minute test, in which a dot is moved from target to target.

measure-acquisitions-per-minute = Dianas por minuto
measure-acquisitions-per-minute-definition = Prueba de dos minutos: dianas por minuto
measure-acquisitions-per-minute-meaning = Cuántas dianas se alcanzaron y se mantuvieron durante un segundo, por cada minuto de la prueba.
measure-throughput = Velocidad y precisión juntas
measure-throughput-definition = Prueba de dos minutos: rendimiento (ISO 9241-411, anchura efectiva)
measure-throughput-meaning = Cuánta información contienen los movimientos: quien es el doble de rápido con la misma precisión tiene el doble. Un valor mayor es mejor; no se indica con menos de ocho dianas.
measure-first-entry = Tiempo hasta una diana
measure-first-entry-definition = Prueba de dos minutos: tiempo hasta la primera entrada en una diana
measure-first-entry-meaning = Desde que aparece una diana hasta que el punto está en ella por primera vez: la media de las dianas alcanzadas.
measure-dial-in = Tiempo hasta quedarse en una diana
measure-dial-in-definition = Prueba de dos minutos: tiempo desde la primera entrada hasta la última
measure-dial-in-meaning = Desde la primera entrada en una diana hasta que el punto se queda en ella: 0 si el punto no vuelve a salir de ninguna diana.
measure-path-efficiency = Rectitud del camino
measure-path-efficiency-definition = Prueba de dos minutos: camino recto dividido por el camino del cursor
measure-path-efficiency-meaning = El camino recto respecto al camino que siguió el punto: 100 % es recto.

## Names beside the measures.

measure-reached = Meta alcanzada
measure-workload = Carga de trabajo, de 0 a 100

## Errors in a table of a trajectory, and in recordings. The name of a file may stand before the sentence. $column is the
## name of a column, such as x.

measure-no-rows = la trayectoria no tiene filas: grabe antes un ensayo
measure-not-finite = { $column } no tiene un número finito en la fila { $row }: corríjalo
measure-time-backwards = t retrocede en la fila { $row }: ponga las filas en el orden del tiempo
measure-lengths = el número de filas es { $rows } en { $column } y { $times } en t: haga que sea el mismo
measure-no-number = “{ $name }” no es un número
measure-quality-no-frames = la grabación no contiene ninguna muestra de esta camiseta mientras se permitía el movimiento: haga antes un ensayo
measure-quality-gestures = la grabación contiene gestos distintos de los de sus parámetros: no se puede valorar, conduzca de nuevo
measure-forecast-channels = el número de canales es { $recorded } en la grabación y { $channels } en el perfil: use el perfil de la misma camiseta
