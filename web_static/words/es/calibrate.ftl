### Texts of the calibration: steps, cues, result.

calibrate-no-shirt = Todavía no hay camiseta
calibrate-no-shirt-lead = La calibración aprende de las señales de la camiseta: elija primero la camiseta.
calibrate-no-shirt-go = Elegir camiseta
calibrate-step = Paso { $step } de { $steps }
calibrate-repetition = repetición { $repetition } de { $all }
calibrate-steps = Los pasos de la calibración
calibrate-step-waiting = pendiente
calibrate-step-running = se está grabando
calibrate-step-done = hecho
calibrate-step-skipped = omitido
calibrate-step-failed = hay que repetirlo
calibrate-start = Empezar
calibrate-again = Repetir este paso
calibrate-cancel = Parar grabación
calibrate-skip = Omitir este movimiento
calibrate-next = Siguiente
calibrate-auto = Seguir automáticamente después de cada paso
calibrate-ready-self = La persona simulada sigue las indicaciones del círculo: toque “{ $button }”.
calibrate-ready-visitor = Usted mueve el cuerpo simulado: mantenga pulsados los botones o las teclas como indica el círculo. Cuando esté listo, toque “{ $button }”.
calibrate-ready-patient = Cuando el paciente esté listo, toque “{ $button }”.
calibrate-done = Hecho. Siga adelante o repita el paso.
calibrate-poor = Se ha grabado, pero no serviría para conducir bien: repita el paso o siga así.
calibrate-going-on = Muy bien. El siguiente paso empieza en un momento…
calibrate-now = Todo listo para conducir
calibrate-now-lead =
    { $count ->
        [one] { $count } persona más se ha movido con esta camiseta. En la silla virtual se usan sus movimientos en lugar de los de esta persona. Los movimientos siguientes mejoran la calibración, articulación por articulación, ahora o más tarde.
       *[other] Otras { $count } personas se han movido con esta camiseta. En la silla virtual se usan sus movimientos en lugar de los de esta persona. Los movimientos siguientes mejoran la calibración, articulación por articulación, ahora o más tarde.
    }
calibrate-now-go = Conducir ya
calibrate-earlier = Hay una calibración del { $day } (versión { $version }). Haga los pasos Reposo y Movimiento libre: después se puede volver a usar, ajustada a la colocación de la camiseta de hoy. No se puede repetir una sola articulación, porque la camiseta se ha puesto de nuevo. Una calibración nueva requiere todos los pasos.
calibrate-earlier-lead = La calibración del { $day } (versión { $version }) se puede volver a usar. Se ajusta a la colocación de la camiseta de hoy y los controles quedan como están. Los movimientos siguientes, en cambio, hacen una calibración nueva, que requiere todos los pasos.
calibrate-earlier-go = Conducir con esta calibración
calibrate-short = Calibración corta
calibrate-whole = Calibración completa
calibrate-short-good = La calibración es bastante buena. No se mueva y empiece el ensayo.
calibrate-wait = Espere
calibrate-fitting = Se está calculando la forma de cada movimiento…
cue-ready = Prepárese
cue-rest = Reposo
cue-free = Movimiento libre
cue-return = Vuelva despacio
cue-move = Mueva
cue-move-elbow = Doble
cue-move-wrist = Doble
cue-move-shoulder = Empuje
cue-seconds = { $seconds } s
cue-next-ready = Después: prepárese
cue-next-rest = Después: reposo
cue-next-free = Después: movimiento libre
cue-next-return = Después: vuelva despacio
cue-next-move = Después: mueva
cue-next-move-elbow = Después: doble
cue-next-move-wrist = Después: doble
cue-next-move-shoulder = Después: empuje
cue-next-end = Después: el final de este paso
cue-trace = Las señales de la camiseta, últimos 10 segundos
result-title = Lo que puede hacer este cuerpo
result-lead = Cada tarjeta muestra la claridad del movimiento principal de una articulación y el funcionamiento que se espera de él. Las marcas indican el 80 al 90 % del estudio de 2008.
result-repeat = Repetir
result-evr = Movimiento principal claro: { $percent }
result-signal = Señal: { $word }
result-repeats = Se repite { $word }
signal-strong = fuerte
signal-fair = aceptable
signal-weak = débil
repeats-well = bien
repeats-fairly = regular
repeats-poorly = mal
result-from-others = De otras personas
result-from-both = De otras personas y movimiento propio
result-from-own = Movimiento propio
result-from-others-lead =
    { $count ->
        [one] Aprendido de { $count } persona más.
       *[other] Aprendido de otras { $count } personas.
    }
result-expected-hits = De 100 movimientos, se reconocen unos { $value } (± { $uncertainty }).
result-expected-false = En reposo, este movimiento se reconoce por error unas { $value } veces por minuto (± { $uncertainty }).
result-expected-prompted = Con las repeticiones de este movimiento, la primera cifra es más segura (± { $uncertainty }). También se sabe entonces con qué frecuencia se reconoce por error en reposo.
result-expected-hits-none = Todavía no se sabe cuántos de 100 movimientos se reconocen: en el movimiento libre no hubo ninguno en esta dirección.
result-expected-false-none = Todavía no se sabe con qué frecuencia se reconoce este movimiento por error en reposo: antes hay que repetirlo.
result-expected-own-hits = De 100 movimientos, se reconocen unos { $value }. Con tan pocas repeticiones solo se puede asegurar que son al menos { $bound }.
result-expected-own-false = En reposo, este movimiento se reconoce por error { $value } veces por minuto. Con un reposo tan corto solo se puede asegurar que son menos de { $bound }.
result-expected-none = Se sabrá si funciona bien cuando se haya repetido este movimiento.
result-sits-shifted = La camiseta está girada ({ $joint }) el equivalente a { $count } de { $sensors } sensores.
result-sits-mirrored = La camiseta está del revés o en el otro lado ({ $joint }).
result-sits-lead = Esta calibración lo tiene en cuenta. Puede dejarla así, o colocar bien la camiseta como muestra la imagen y empezar de nuevo la calibración. Si está seguro de que está bien colocada, indíquelo.
result-sits-right = Bien colocada
result-sits-right-label = Está bien colocada ({ $joint }): calibrar la camiseta tal como está puesta
result-sits-left = La camiseta parece girada ({ $joint }), pero se usa tal como está puesta porque usted indicó que está bien colocada.
result-sits-follow = Considerarla girada
result-sits-follow-label = Considerarla girada ({ $joint }) y compensarlo
result-sits-picture-mirrored = Los sensores de un lado están en el otro lado ({ $joint }): ponga la camiseta del derecho o póngala en el otro brazo
result-sits-side-front = delante
result-sits-side-back = detrás
result-sits-side-outside = lado externo
result-sits-side-inside = lado interno
result-sits-picture = Gire la camiseta ({ $joint }) el equivalente a { $count } de sus { $sensors } sensores
result-details = Detalles
result-details-signal = El movimiento completo es { $value } veces el ruido en reposo (relación señal-ruido).
result-details-repeats = Los picos de las repeticiones difieren entre sí menos de un { $percent }.
result-details-evr = Proporción de la señal en una sola dirección (proporción de varianza explicada, EVR): { $percent }.
result-again = Repetir articulación
result-again-label = Repetir esta articulación: { $joint }
result-maps-pca = Estándar
result-maps-guided = Aprendida de las indicaciones
result-maps-choose = { $joint }: con qué calibración se conduce
result-maps-better = Se puede conducir con otra calibración
result-maps-in-use-guided = Se conduce con la calibración aprendida de las indicaciones
result-maps-in-use-prior = Se conduce con la calibración aprendida de otras personas
result-maps-prior = Aprendida de otras personas
result-maps-lead-prior =
    { $count ->
        [one] Cada cifra procede de { $count } repetición de esta persona. Lo aprendido de otras personas se completó sin ella.
       *[other] Cada cifra procede de { $count } repeticiones de esta persona. Lo aprendido de otras personas se completó cada vez sin la repetición con la que se comprobó.
    }
result-maps-lead-guided =
    { $count ->
        [one] Ambas se aprendieron de esta calibración. Cada cifra procede de { $count } repetición que se reservó.
       *[other] Ambas se aprendieron de esta calibración. Cada cifra procede de { $count } repeticiones que se reservaron.
    }
result-maps-in-phase = Proporción del efecto que coincide con el movimiento pedido
result-maps-hit = Proporción del tiempo del movimiento pedido en que actúa
result-maps-false = Actúa en reposo, veces por minuto
result-maps-kept-guided = No se ofrece la calibración aprendida de las indicaciones: no sería mejor para esta articulación.
result-maps-kept-prior = No se ofrece la calibración aprendida de otras personas: no sería mejor para esta articulación.
result-maps-details = La calibración estándar es la dirección principal del movimiento (PCA); la otra es una proyección lineal guiada por las indicaciones.
result-bar = { $joint }: movimiento principal claro { $percent }; en el estudio, del 80 al 90 %
result-cross = Al hacer un movimiento, qué más cuenta
result-cross-lead = 1,00 indica cuánto cuenta el movimiento pedido. Es bueno que los demás números sean pequeños.
result-cross-asked = se pide: { $joint }
result-left-out =
    { $count ->
        [one] { $count } sensor excluido: { $which }
       *[other] { $count } sensores excluidos: { $which }
    }
result-left-out-none = Se usan todos los sensores.
result-accept = Usar esta calibración
result-accepted = Esta calibración está en uso.
result-go-on = Seguir a los controles
result-others-lead =
    { $count ->
        [one] { $count } movimiento todavía no se ha grabado. Hasta entonces se usan para él calibraciones de otras personas. Conduzca ya o grabe antes el movimiento.
       *[other] { $count } movimientos todavía no se han grabado. Hasta entonces se usan para ellos calibraciones de otras personas. Conduzca ya o grabe antes los movimientos.
    }
result-missing = El resultado aparece cuando se han hecho todos los pasos.
result-missing-lead =
    { $count ->
        [one] Falta un paso.
       *[other] Faltan { $count } pasos.
    }
result-restart = Empezar de nuevo
result-restart-ask = ¿Empezar de nuevo la calibración? Lo grabado hasta ahora dejará de contar.
result-restarted = La calibración empieza de nuevo.
