### What is said about trials: verdicts, warnings of control quality, events and interruptions.

## A verdict in a table: how a measure changed.

verdict-word-better = mejor, más allá de la variabilidad
verdict-word-within = dentro de la variabilidad
verdict-word-worse = peor, más allá de la variabilidad
verdict-word-few-trials = muy pocos ensayos
verdict-word-few-tests = muy pocas pruebas
# There is no verdict.
verdict-word-none = –

## A measure that has become worse over sessions.

verdict-worse = Peor, más allá de la variabilidad propia de esta persona, desde la sesión { $session }. Qué hacer: compruebe la colocación de la camiseta y los avisos sobre la calidad del control, pregunte por dolor, sueño y medicación, y calibre de nuevo. Si las dos sesiones siguientes son igual de malas, consulte al médico.
verdict-goal-missed = Desde la sesión { $session }, la meta queda sin alcanzar con más frecuencia de la que explica la variabilidad propia de esta persona. Qué hacer: compruebe la colocación de la camiseta y los avisos sobre la calidad del control, pregunte por dolor, sueño y medicación, y calibre de nuevo. Si las dos sesiones siguientes son igual de malas, consulte al médico.

## Warnings of control quality, each with advice. $joint is a name such as "Left elbow".

# The joints of a warning, as in "Left elbow and Right elbow".
warning-joints = { $joints }
warning-few-trials =
    Pocos ensayos: para saber si los movimientos se hacen más pequeños hacen falta { $least_trials } ensayos de una tarea en una sesión, o { $least_sessions } sesiones; { $trials ->
        [one] hasta ahora hay { $trials } ensayo en la última sesión
       *[other] hasta ahora hay { $trials } ensayos en la última sesión
    }, { $sessions ->
        [one] y { $sessions } sesión.
       *[other] y { $sessions } sesiones.
    }
warning-shirt = La camiseta no está colocada como cuando se calibró: { $count } sensores ({ $joints }) estuvieron fuera de su rango calibrado en el ensayo { $trial }, y lo que hicieron estas articulaciones no tuvo efecto.
warning-shirt-advice = Coloque bien la camiseta. Si se ha puesto de nuevo, ajuste a ella la calibración en la página { rail-calibrate }.
warning-sensor-silent = { $joint }: el sensor { $sensor } no dio ninguna señal durante el { $percent } % del ensayo { $trial }; mientras tanto, lo que hizo esta articulación no tuvo efecto.
warning-sensor-range = { $joint }: el sensor { $sensor } estuvo fuera de su rango calibrado durante el { $percent } % del ensayo { $trial }; mientras tanto, lo que hizo esta articulación no tuvo efecto.
warning-sensor-advice = Véalo en la página { rail-shirt }, coloque bien la camiseta e introduzca el conector hasta el fondo. Si sigue igual, elija allí “{ sensor-unused }” y calibre de nuevo.
warning-turned = { $joint }: el movimiento ha girado { $degrees }° respecto a los primeros ensayos con esta calibración.
warning-turned-advice = ¿Se ha puesto la camiseta de nuevo, o se ha desplazado? Colóquela bien, o calibre de nuevo.
warning-off-map = { $joint }: el movimiento está a { $degrees }° de la calibración, y un { $percent } % de él nunca llega al control.
warning-off-map-advice = Repita el movimiento libre y los movimientos pedidos de esta articulación tal como la persona la mueve al conducir.
warning-unclear = { $joint }: el movimiento principal solo es claro en un { $percent } %, menos que en los primeros ensayos.
warning-unclear-advice = Pida a la persona que mueva esta articulación en una sola dirección; si no ayuda, calibre de nuevo.
# Behind one of the three advices above.
warning-other-map = Para esta articulación se usa una calibración distinta de la estándar: compruebe si todavía es adecuada.
warning-trembles = { $joint }: en reposo tiembla a un { $percent } % / s del movimiento completo y cuenta desde { $counts_from } % / s, así que puede actuar por sí sola: haga que cuente desde { $better_from } % / s.
warning-trembles-advice = Compruebe si hay temblor, si el paciente está cansado o si un conector está suelto. Después suba su “{ tune-from }” en la página { rail-controls }, o baje “{ speed-cutoff }”: un valor menor atenúa más.
warning-noise = { $joint }: el ruido en reposo ha aumentado hasta { $ratio } veces el de los primeros ensayos.
# Rest is a step of the calibration.
warning-noise-advice = Compruebe si hay temblor, si el paciente está cansado o, en la página { rail-shirt }, si un conector está suelto. Si persiste, repita el paso { calibration-rest } de la calibración, para que el movimiento cuente solo por encima del ruido.
warning-smaller = { $joint }: el movimiento se ha hecho un { $percent } % más pequeño a lo largo de { $sessions } sesiones.
warning-smaller-advice = Pregunte por la fuerza y el dolor. Si persiste, calibre de nuevo, para que “{ tune-full }” sea lo que la persona alcanza ahora, y anote la amplitud de movimiento en la ficha.
warning-tired = { $joint }: el movimiento se ha hecho un { $percent } % más pequeño durante esta sesión.
warning-tired-advice = Puede que la persona esté cansada: déjela descansar o termine la sesión. No calibre mientras lo esté.

## Events of a trial on its time line.

timeline-checking = Empezó la comprobación del reposo.
timeline-armed = Se permitió el movimiento.
timeline-disarmed = Dejó de permitirse el movimiento.
timeline-contact = La silla tocó algo.
timeline-goal = Se alcanzó la meta.

## A recording that cannot be shown. $damage is one or more whole sentences.

trial-recording-no-place = La grabación de este ensayo no indica ningún lugar: elija otro ensayo.
trial-recording-empty = La grabación de este ensayo no contiene nada: elija otro ensayo.
trial-recording-damaged = La grabación de este ensayo no contiene nada. { $damage }

## What interrupted a trial, how often, and for how long.

interruption-halted =
    { $times ->
        [one] { $times } detención, { $seconds } s
       *[other] { $times } detenciones, { $seconds } s
    }
interruption-paused =
    { $times ->
        [one] { $times } pausa, { $seconds } s
       *[other] { $times } pausas, { $seconds } s
    }
interruption-stopped =
    { $times ->
        [one] { $times } parada por una persona, { $seconds } s
       *[other] { $times } paradas por una persona, { $seconds } s
    }
# Of the three above.
interruptions-several = { $before }; { $after }
interruptions-asked = la máquina lo interrumpió ({ $interruptions }), y todavía nadie ha indicado que cuenta
