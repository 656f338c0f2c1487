### Texts of the review of one trial and of two side by side.

compare-column = Comparar
compare-pick = Comparar el ensayo { $number }
compare-go = Comparar dos ensayos
compare-chosen = Se han elegido el ensayo { $first } y el ensayo { $second }.
compare-choose =
    { $count ->
        [one] Marque un ensayo más.
       *[other] Marque dos ensayos de la lista.
    }
compare-title = Dos ensayos lado a lado
compare-trial = Ensayo { $number }
compare-difference = Diferencia
compare-measures = Medidas
compare-plan = Las dos trayectorias sobre el recorrido
compare-now = { $along } m a lo largo del recorrido, { $v } m/s, a { $across } m de él
compare-now-spot = { $v } m/s
compare-along = a lo largo del recorrido (m)
compare-speed = Velocidad a lo largo del recorrido
compare-speed-axis = velocidad (m/s)
compare-across = Distancia al recorrido, a lo largo de él
compare-across-axis = distancia al recorrido (m), izquierda positiva
compare-start = Ambos empiezan cuando la silla podía moverse.
compare-other-path = Estos dos ensayos no se hicieron en el mismo recorrido. Por eso solo se muestran sus medidas lado a lado, y las diferencias dicen poco.
compare-no-recording = No hay reproducción: { $why }
compare-pairs = Elija dos ensayos en Revisar.
compare-verdict = Valoración del ensayo { $number }
compare-used = Los ensayos de familiarización con la tarea no se comparan: { $numbers }.
compare-no-measures = No se midió ninguno de los dos.
replay-title = Volver a verlo
replay-play = Reproducir
replay-pause = Pausa
replay-speed = Velocidad de reproducción
replay-slider = Momento del ensayo
replay-at = { $t } de { $end } segundos
replay-keys = Las flechas avanzan o retroceden un segundo; con Mayús, diez. P reproduce y pausa. La barra espaciadora es STOP, como en todas partes.
replay-plan = Desde arriba
replay-events = Qué ocurrió
replay-charts = Señales, movimientos y comandos
replay-charts-lead = Toque cualquier gráfico para ir a ese momento. En las zonas grises la silla no podía moverse.
replay-chart = { $title } a lo largo del tiempo
replay-chair = Silla
replay-v = velocidad
replay-omega = velocidad de giro
replay-commands = Comandos
replay-activations = Cuánto cuenta cada movimiento
replay-rates = Movimiento por segundo
replay-scores = Amplitud del movimiento
replay-command-speed = Velocidad
replay-command-turning = Giro
replay-unit-full = 1 es el máximo
replay-unit-rate = proporción del movimiento completo por segundo
replay-unit-share = proporción del movimiento completo
replay-signals = Señales: { $shown } de { $of } sensores
replay-joint = Sensores de
replay-none = No hay reproducción de este ensayo.
replay-look = Volver a verlo
replay-picture = Imagen de la reproducción
replay-picture-off = La reproducción en 3D está desactivada: { $why }
replay-picture-loading = La imagen está en camino…
replay-picture-webgl = Esta pantalla no puede dibujar la vista 3D (su navegador no ofrece WebGL 2), así que la reproducción se muestra en el plano dibujado.
replay-picture-context = el navegador ha desactivado los gráficos de esta página. Elija Plano o espere a que vuelvan.
replay-picture-again = Mostrarla en 3D
