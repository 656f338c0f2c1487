### Texts about studies with simulated people: refusals, tables, sentences on the results, and labels of the figures.

## Refusals

study-folder-is-file = { $folder } es un archivo y no una carpeta: indique otro lugar
# --overwrite: an option of the command, not translated.
study-folder-not-empty = { $folder } no está vacía: indique otra carpeta, o sustitúyala con --overwrite
study-no-prior = con el programa no viene ningún prior para la camiseta simulada: cree uno con `make shipped FILE=prior`

## Several people, each with their own seed (a number from which a simulated person is made)

# measure: the name of a measure, as in “Area off the path”. first, last: its median with its unit, or study-none-reached.
study-over-seeds = { $measure }, mediana: { $first } en el ensayo 1, { $last } en el ensayo { $trials }; de { $seeds } personas, bajó en { $falls }, subió en { $rises } y quedó dentro de la variabilidad en { $no_trend }; el mayor cambio está entre los { $early } primeros ensayos en { $early_steps }.
study-over-seeds-step = { $measure }, mediana: { $first } en el ensayo 1, { $last } en el ensayo { $trials }; de { $seeds } personas, bajó en { $falls }, subió en { $rises } y quedó dentro de la variabilidad en { $no_trend }; el mayor cambio está entre los { $early } primeros ensayos en { $early_steps }, y el de la mediana, a partir del ensayo { $step }.
study-none-reached = nadie alcanzó la meta
study-left-out = Ensayos que no alcanzaron la meta a tiempo: { $missed } de { $count }; estas cifras no los incluyen.

## A fixed and an adapted map

study-area-title = Área fuera del recorrido, m²
# Titles of columns. fixed, adapted: medians with the fixed and the adapted map; reached: how many trials reached the goal
# with each; both drove: how many people always reached the goal with both, relative there: the difference for these;
# 95 %: an interval.
study-column-session = sesión
study-column-seed = semilla
study-column-fixed = fija
study-column-adapted = adaptada
study-column-reached-fixed = meta, fija
study-column-reached-adapted = meta, adaptada
study-column-both-drove = con ambas
study-column-relative = relativa
study-column-relative-there = relativa ahí
study-column-interval = 95 %
study-session = sesión { $session }
# The bounds of an interval, in percent.
study-interval = { $low } a { $high }
# relative: a difference in percent; interval: a text study-interval, or a dash.
study-later-sessions = Todos los ensayos desde la sesión 2: media de { $fixed } m² con la calibración fija, { $adapted } m² con la adaptada: { $relative } (95 %: { $interval }); alcanzó la meta el { $reached_fixed } % y el { $reached_adapted } %.
study-last-session = Mediana de las semillas ({ $seeds }) en la última sesión: { $relative } (95 %: { $interval }). Propuestas por persona: mediana { $median }, máximo { $most }. Cambios aplicados: { $steps }; mayor cambio percibido: { $felt_change } %, mayor giro de la calibración: { $turn } grados, inversiones de signo: { $flips }.

## The two-minute test

study-test-title = Prueba de dos minutos, medianas de las personas
# Titles of columns. first entry: seconds until the target is entered first; dial-in: from then until it is held.
study-test-targets = dianas/min
study-test-missed = falladas
study-test-first-entry = primera entrada, s
study-test-dial-in = ajuste, s
study-test-straightness = rectitud
study-test-throughput = rendimiento, bit/s (10 a 90 %)
study-test-area = área fuera del recorrido, m²
study-test-reached = meta
study-spread = ({ $low } a { $high })
# between, within: a number from −1 to 1, or a dash.
study-rank-correlation = Correlación de rangos del rendimiento con el área fuera del recorrido en los ensayos de la misma sesión: entre personas { $between }, dentro de cada persona { $within }.

## Figures. Dist is the symbol of the distance driven; letter: of a panel of the figure.

study-panel-trial = ({ $letter }) Ensayo { $number }
study-panel-all = ({ $letter }) Todos los ensayos ({ $count })
study-panel-people = ({ $letter }) Ensayo { $number }, { $count } personas
study-panel-dist = ({ $letter }) Dist: distancia recorrida
study-panel-area = ({ $letter }) { $symbol }: área entre la trayectoria y el recorrido
study-prescribed-path = recorrido indicado, { $length } m (● salida, ■ meta)
study-trajectory = trayectoria
study-path-length = longitud del recorrido
study-one-person = una persona
study-middle-half = mitad central
study-median = mediana de { $count }
study-band = banda del 95 %
study-learning-curve = curva de aprendizaje
study-trial = ensayo
