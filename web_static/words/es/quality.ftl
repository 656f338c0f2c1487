### Texts of the quality of control: the card of one trial, its course over trials, the warnings.

quality-title = Calidad del control
quality-details = Detalles: calidad del control
quality-none = La grabación de este ensayo no muestra si la calibración se ajustó bien.
quality-lead = Cómo se ajustó la calibración a los movimientos de este ensayo.
quality-joint = Articulación
quality-map-angle-deg = Ángulo con la calibración
quality-evr = Movimiento principal claro
quality-null-space-share = Movimiento sin efecto
quality-cross-talk = Se mueve a la vez
quality-activations = Movimientos que contaron
quality-activations-per-metre = Movimientos por metro
quality-span-share = Rango usado
quality-rest-rate = Temblor en reposo
quality-means-map-angle-deg = entre la dirección principal de este ensayo y la de la calibración
quality-means-evr = proporción del movimiento en una sola dirección
quality-means-null-space-share = proporción del movimiento que nunca llega al control
quality-means-cross-talk = proporción del efecto debida a movimientos distintos del más fuerte
quality-means-activations-per-metre = movimientos que contaron, por cada metro recorrido
quality-means-span-share = respecto al rango calibrado
quality-means-rest-rate = proporción del movimiento completo por segundo, cuando la articulación estaba más quieta
quality-worst = Para varias articulaciones juntas, cada cifra es la de la articulación que peor se ajusta.
quality-guided = { $joints }: aquí no se usa la calibración estándar. Aun así, estas cifras son de la calibración estándar. Indican cómo se mueve la articulación, no cómo controla la silla.
quality-bad = Sensores que no fueron fiables parte del tiempo: { $sensors }.
quality-bad-one = { $name } ({ $share } del tiempo)
quality-still = Una articulación sin cifras se movió menos de 2 s.
quality-over = Calidad del control a lo largo de los ensayos
quality-choose = Cifra
quality-choose-joint = Articulación
quality-all-joints = Todas las articulaciones: la que peor se ajusta
quality-trial = ensayo
quality-empty = Ningún ensayo muestra aquí si la calibración se ajustó bien.
quality-session = sesión { $number }
quality-map = calibración { $number }
quality-warnings =
    { $count ->
        [one] Una cosa que revisar
       *[other] { $count } cosas que revisar
    }
quality-do = Qué hacer:
quality-kind-sensor = sensor: { $joints }
quality-kind-map = calibración: { $joints }
quality-kind-noise = temblor o ruido: { $joints }
quality-kind-span = movimiento más pequeño: { $joints }
quality-go-sensor = Ir a la camiseta
quality-go-map = Ir a la calibración
quality-go-noise = Ir a los controles
quality-go-span = Ir a la calibración
