### Grades of a calibration: how well the movement of one joint can be used, and what to do. "It" is the joint.

# As in "Signal: strong".
grade-signal-strong = fuerte
grade-signal-fair = aceptable
grade-signal-weak = débil
# As in "Repeats well".
grade-repeats-well = bien
grade-repeats-fairly = regular
grade-repeats-poorly = mal
# $signal is one of the three words above.
grade-good = Movimiento principal claro: { $percent } %. Señal: { $signal }.
grade-good-repeats = Se repite { $how }.
grade-unprompted = Su movimiento no se pidió, así que no se sabe en qué dirección cuenta: pídalo.
grade-directed = Su movimiento no se pidió: la dirección en la que cuenta se conoce por otras personas.
grade-no-movement = El movimiento no sobresale del ruido: repítalo más amplio y más rápido.
# $rating is "repeat" where the movement has to be repeated, "usable" where it need not.
grade-signal =
    { $rating ->
        [repeat] Su movimiento es solo { $ratio } veces el ruido: mantenga primero un reposo total y repítalo después más amplio.
       *[usable] Su movimiento es solo { $ratio } veces el ruido: uno más amplio o más rápido sería más seguro.
    }
grade-clear =
    { $rating ->
        [repeat] El movimiento principal solo es claro en un { $percent } %, menos del 80 % habitual: repita el movimiento libre moviendo esta articulación en una sola dirección.
       *[usable] El movimiento principal solo es claro en un { $percent } %, menos del 80 % habitual: use un solo movimiento de esta articulación.
    }
grade-no-rest = No se grabó ningún reposo: como ruido vale el del medio segundo más quieto.
grade-agreement = Los movimientos pedidos van en ambas direcciones (el { $percent } %, en una): repítalos al ritmo de la indicación.
grade-small-prompts = Los movimientos pedidos solo recorren el { $percent } % del rango del movimiento libre: repítalos más amplios y al ritmo de la indicación.
grade-uneven =
    { $rating ->
        [repeat] Las repeticiones difieren en un { $percent } %: hágalas de nuevo, más iguales entre sí.
       *[usable] Las repeticiones difieren en un { $percent } %: con repeticiones más iguales se conduciría con más regularidad.
    }
grade-angle = El movimiento pedido está a { $degrees }° del libre: se usa la dirección pedida, compruébela en “{ try-title }”.
grade-cross-talk = { $joint } también responde, con un { $percent } % de su propia activación: mueva solo esta articulación, o no asigne las dos.
grade-span-of-prompts = En el movimiento libre se movió poco en esta dirección: el rango es el de los movimientos pedidos.
grade-one-sensor = Solo queda uno de sus sensores: revise los demás en la página { rail-shirt }.
grade-sensors-out = Sensores excluidos: { $count } de { $every }.
