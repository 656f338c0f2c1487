### Calibration: its steps, what is wrong with a sensor or a recording, why a joint has no map, and how maps are proposed
### and changed.

## Steps.

calibration-rest = Reposo
calibration-rest-instruction = Siéntese con comodidad y deje los brazos relajados. No se mueva durante tres segundos.
calibration-free = Movimiento libre
calibration-free-instruction = Mueva los brazos y los hombros como quiera durante diez segundos, hasta donde le resulte cómodo.
calibration-free-short-instruction = Durante diez segundos, gire la cabeza hacia un lado, incline el cuerpo hacia un lado y empuje cada hombro hacia adelante, una y otra vez, en cualquier orden, hasta donde le resulte cómodo.
# Below an instruction to move one joint.
calibration-prompt-instruction = Siga el ritmo { $count } veces: muévase cuando lo pida la indicación; después vuelva despacio y quédese en reposo.
calibration-move-elbow =
    { $side ->
        [left] Doble el codo izquierdo
       *[right] Doble el codo derecho
    }
calibration-move-shoulder =
    { $side ->
        [left] Empuje el hombro izquierdo hacia adelante
       *[right] Empuje el hombro derecho hacia adelante
    }
calibration-move-wrist =
    { $side ->
        [left] Doble la muñeca izquierda
       *[right] Doble la muñeca derecha
    }
calibration-move-head = Gire la cabeza hacia un lado
calibration-move-trunk = Incline el cuerpo hacia un lado
calibration-move = Mueva: { $joint }

## What is wrong with a sensor. The name of the sensor stands before it, as in "Channel e3 is left out: gives no numbers."

calibration-channel-no-numbers = no da ningún número
calibration-channel-nan =
    { $count ->
        [one] da { $count } muestra que no es un número (de { $samples })
       *[other] da { $count } muestras que no son números (de { $samples })
    }
calibration-channel-railed = llega al { $percent } % de su rango
calibration-channel-near = se acerca al final de su rango ({ $percent } %)
calibration-channel-clipped =
    { $end ->
        [upper] permanece en el extremo superior de su rango el { $percent } % del tiempo
       *[lower] permanece en el extremo inferior de su rango el { $percent } % del tiempo
    }
calibration-channel-dead = no cambia nunca: está averiado o no está conectado
calibration-channel-still = no cambia durante el { $percent } % del tiempo, mientras sus vecinos sí cambian
calibration-channel-noisy = es sobre todo ruido (el { $percent } % de su movimiento)
calibration-channel-gap = le faltan { $seconds } s seguidos, y se completan { $most } s como máximo
calibration-channel-missing = le falta el { $percent } % de las muestras, y se completa el { $most } % como máximo
calibration-channel-unused = marcado como sin usar

## Recordings that cannot be used. The name of a file may stand before the sentence.

# $what is the name of a joint where it is neither free movement nor rest.
calibration-recording-channels =
    { $what ->
        [free] la grabación del movimiento libre no tiene los { $count } canales de “{ $layout }”
        [rest] la grabación del reposo no tiene los { $count } canales de “{ $layout }”
       *[other] la grabación de “{ $what }” no tiene los { $count } canales de “{ $layout }”
    }
calibration-recording-short =
    { $what ->
        [free] el movimiento libre dura { $lasts } s, demasiado poco para una calibración: grabe al menos { $least } s (lo habitual son 10 s de movimiento libre y 3 s de reposo)
       *[rest] el reposo dura { $lasts } s, demasiado poco para una calibración: grabe al menos { $least } s (lo habitual son 10 s de movimiento libre y 3 s de reposo)
    }
calibration-unknown-name =
    { $what ->
        [joint] en “{ $layout }” no hay ninguna articulación “{ $name }”, use una de estas: { $names }
       *[channel] en “{ $layout }” no hay ningún canal “{ $name }”, use uno de estos: { $names }
    }
calibration-no-joint = ninguna articulación de “{ $layout }” tiene un sensor que se pueda usar: compruebe que la camiseta está conectada y que alguien se movió con ella
calibration-no-sensor = Ninguno de sus sensores se puede usar: revíselos en la página { rail-shirt } y después repita la calibración.

## Where a map comes from.

calibration-source-both = de otras personas y movimiento propio
calibration-source-people = de otras personas
calibration-source-prompts = de movimientos propios pedidos
calibration-source-standard = estándar

## Why there is no map learnt from the cues.

calibration-guided-unprompted = No se aprende nada de las indicaciones, porque el movimiento de esta articulación nunca se pidió: pídalo al menos { $least } veces.
calibration-guided-few =
    { $count ->
        [one] Con { $count } repetición pedida no se aprende nada de las indicaciones: pida al menos { $least }, para que lo aprendido se pueda comprobar con una que se haya reservado.
       *[other] Con { $count } repeticiones pedidas no se aprende nada de las indicaciones: pida al menos { $least }, para que lo aprendido se pueda comprobar con una que se haya reservado.
    }
calibration-guided-no-rest = No se aprende nada de las indicaciones, porque los momentos de reposo de esta articulación no suman { $seconds } s: grabe un reposo, o deje pausas entre los movimientos pedidos.
calibration-guided-small = No se aprende nada de las indicaciones, porque las señales son demasiado pequeñas: expréselas en una unidad menor.
calibration-guided-unlike = No se aprende nada de las indicaciones: las repeticiones no tienen nada en común, así que repita los movimientos pedidos.

## Maps from other people (a prior).

calibration-prior-few =
    { $count ->
        [one] Los movimientos de otras personas todavía no dicen nada: en esta articulación se conocen los de { $count } persona, y hacen falta los de { $needed }.
       *[other] Los movimientos de otras personas todavía no dicen nada: en esta articulación se conocen los de { $count } personas, y hacen falta los de { $needed }.
    }
calibration-prior-unlike = Los movimientos de otras personas no tienen nada en común entre sí: añada más personas.
calibration-prior-small = Las señales son demasiado pequeñas: expréselas en una unidad menor.
calibration-prior-still = De los sensores que se conocen de otras personas, ninguno se mueve en esta: grabe diez segundos de movimiento libre.
calibration-not-confirmed = El movimiento se aprendió de otras personas, y el propio todavía no lo ha confirmado ({ $joints }): repita cada movimiento una vez en la página { rail-calibrate } y practique de nuevo.
# Why a prior may not leave the clinic: this one and the next.
calibration-prior-few-new =
    { $count ->
        [one] en total hay { $count } persona, y son menos de { $least } las que todavía no están en ninguna publicación: use la publicación anterior, y haga otra cuando se hayan añadido al menos { $least } personas, para que no se pueda reconocer a nadie restando una de la otra
       *[other] en total hay { $count } personas, y son menos de { $least } las que todavía no están en ninguna publicación: use la publicación anterior, y haga otra cuando se hayan añadido al menos { $least } personas, para que no se pueda reconocer a nadie restando una de la otra
    }
calibration-prior-few-released =
    { $count ->
        [one] en total hay { $count } persona, y de una clínica solo pueden salir sumas de al menos { $least }: añada más personas
       *[other] en total hay { $count } personas, y de una clínica solo pueden salir sumas de al menos { $least }: añada más personas
    }

## The earlier calibration, fitted to how the shirt sits today. $joint is as in "left elbow".

calibration-fit-rate = La camiseta no envía con la frecuencia con la que se calibró: calibre de nuevo.
calibration-fit-mirrored = Respecto a cuando se calibró, la camiseta está del revés o en el otro lado ({ $joint }): póngala como entonces y repita el movimiento libre. O siga con los movimientos siguientes, que hacen una calibración nueva.
calibration-fit-turned = Respecto a cuando se calibró, la camiseta está girada ({ $joint }) el equivalente a { $places } de { $sensors } sensores: póngala como entonces y repita el movimiento libre. O siga con los movimientos siguientes, que hacen una calibración nueva.

## A change of the calibration that is proposed after trials. $applied and $refused are lists of joints.

calibration-proposal =
    { $trials ->
        [one] Lo que cambiaría tras el último ensayo: { $applied }.
       *[other] Lo que cambiaría tras los { $trials } últimos ensayos: { $applied }.
    }
calibration-proposal-some =
    { $trials ->
        [one] Lo que cambiaría tras el último ensayo: { $applied }. Lo que se rechaza: { $refused }.
       *[other] Lo que cambiaría tras los { $trials } últimos ensayos: { $applied }. Lo que se rechaza: { $refused }.
    }
calibration-proposal-refused =
    { $trials ->
        [one] Tras el último ensayo no cambia nada: se rechaza lo que haría falta ({ $refused }).
       *[other] Tras los { $trials } últimos ensayos no cambia nada: se rechaza lo que haría falta ({ $refused }).
    }
calibration-proposal-none =
    { $trials ->
        [one] Tras el último ensayo, la calibración se ajusta tan bien como antes y queda como está.
       *[other] Tras los { $trials } últimos ensayos, la calibración se ajusta tan bien como antes y queda como está.
    }
calibration-proposal-no-trial = Todavía no se ha hecho ningún ensayo.

## Why the calibration of one joint changes, and how; or why it does not. "It" is the joint.

calibration-loss-noise = Su ruido en reposo se ha acercado al valor desde el que cuenta, así que puede actuar por sí sola.
calibration-loss-missed = El { $percent } % del tiempo de sus movimientos no cuenta, aunque su ruido en reposo es bajo.
calibration-loss-weaker = Sus movimientos son un { $percent } % más débiles que en los primeros ensayos.
calibration-loss-stronger = Sus movimientos son un { $percent } % más fuertes que en los primeros ensayos.
calibration-loss-direction = El { $percent } % de su movimiento va en una dirección distinta de la que sirve para conducir.
calibration-loss-silent = Un sensor estuvo fuera de su rango durante el { $percent } % del último ensayo, y en ese tiempo no contó nada.
calibration-change-no-trial = No se ha hecho ningún ensayo desde el último cambio de la calibración.
calibration-change-none = La calibración se le ajusta tan bien como antes.
calibration-change-sensor = El sensor { $sensor } está averiado o al final de su rango: revise la camiseta y después calibre de nuevo.
calibration-change-felt = El paciente notaría un cambio del { $percent } %, y a partir del { $limit } % se rechaza: calibre de nuevo esta articulación.
calibration-change-at-end = La calibración ya no puede seguirla más: calibre de nuevo esta articulación.
calibration-change-unclear = Su movimiento principal solo es claro en un { $percent } %, menos del { $least } %.
calibration-change-away = Quedaría a { $degrees }° de la calibración: calibre de nuevo esta articulación.
calibration-change-cross-talk = Respondería más a otras articulaciones (antes { $before } %, después { $after } %).
calibration-change-range = El rango en el que se confía en sus sensores se adapta a la camiseta.
calibration-change-turned = Calibración girada { $degrees }°.
calibration-change-turned-part = Calibración girada { $degrees }° de los { $proposed }° que piden sus movimientos.
calibration-change-from = { tune-from } { $after } % / s en lugar de { $before } % / s.
calibration-change-full = { tune-full } { $after } % / s en lugar de { $before } % / s.
# A sentence that says why follows.
calibration-change-unturned = La dirección queda como está.

## The suggested movements to drive with.

calibration-suggested = Sugerencia: { $gestures }.
# In the list above: a joint whose movement back is the gesture.
calibration-gesture-back = { $joint } al volver
calibration-suggested-one =
    Su señal es { $signal ->
        [strong] fuerte
        [fair] aceptable
       *[weak] débil
    }.
calibration-suggested-unprompted =
    El más débil de estos movimientos tiene una señal { $signal ->
        [strong] fuerte
        [fair] aceptable
       *[weak] débil
    }; no se pidió ningún movimiento, así que no se sabe qué se mueve a la vez.
calibration-suggested-several =
    El más débil de estos movimientos tiene una señal { $signal ->
        [strong] fuerte
        [fair] aceptable
       *[weak] débil
    }; mientras se hace uno, aparece de media un { $percent } % de la activación de otro.
calibration-suggested-without = { $joint }: no se incluye, porque se activa junto con otra articulación ({ $partner }): mientras se mueve una de las dos, aparece hasta un { $percent } % de la activación de la otra.
calibration-suggested-hits = Se deberían reconocer al menos { $hits } de 100 movimientos.
calibration-suggested-false = En reposo se esperan { $rate } activaciones falsas por minuto entre todos; { $seconds } s de reposo solo demuestran que son menos de { $bound } de cada uno (95 %).
calibration-suggested-hardly-false = En reposo se esperan menos de { $rate } activaciones falsas por minuto entre todos; { $seconds } s de reposo solo demuestran que son menos de { $bound } de cada uno (95 %).
calibration-recordings-gone = Las grabaciones de esta calibración no están aquí, así que solo se ordenan los movimientos de ida, no los de vuelta, según las cifras de la propia calibración: calibre de nuevo para verlos todos.
