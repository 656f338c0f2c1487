### Learning curves: what became of a measure over a person's trials, and the statistics behind it. $subject is a measure
### within a sentence, such as "the area off the path"; "it" is the measure.

learning-few = No hay suficientes ensayos para una curva de aprendizaje: ensayos que alcanzaron la meta: { $count }, y hacen falta al menos { $least }.

## The head of a sentence, before a colon. $sessions is 0 where it is not known in how many sessions the trials were driven.

learning-head-better =
    { $sessions ->
        [0] Mejor, más allá de la variabilidad, en { $trials } ensayos
        [one] Mejor, más allá de la variabilidad, en { $trials } ensayos de { $sessions } sesión
       *[other] Mejor, más allá de la variabilidad, en { $trials } ensayos de { $sessions } sesiones
    }
learning-head-worse =
    { $sessions ->
        [0] Peor, más allá de la variabilidad, en { $trials } ensayos
        [one] Peor, más allá de la variabilidad, en { $trials } ensayos de { $sessions } sesión
       *[other] Peor, más allá de la variabilidad, en { $trials } ensayos de { $sessions } sesiones
    }
learning-head-within =
    { $sessions ->
        [0] Dentro de la variabilidad en { $trials } ensayos
        [one] Dentro de la variabilidad en { $trials } ensayos de { $sessions } sesión
       *[other] Dentro de la variabilidad en { $trials } ensayos de { $sessions } sesiones
    }
learning-head-few =
    { $sessions ->
        [0] Muy pocas sesiones para distinguir un cambio de la variabilidad, con { $trials } ensayos
        [one] Muy pocas sesiones para distinguir un cambio de la variabilidad, con { $trials } ensayos de { $sessions } sesión
       *[other] Muy pocas sesiones para distinguir un cambio de la variabilidad, con { $trials } ensayos de { $sessions } sesiones
    }
# Of a measure that is not judged.
learning-head-number =
    { $sessions ->
        [0] En { $trials } ensayos
        [one] En { $trials } ensayos de { $sessions } sesión
       *[other] En { $trials } ensayos de { $sessions } sesiones
    }

## The sentence behind the head, and those that follow it.

learning-level = { $head }: { $subject } fue de aproximadamente { $level }.
learning-change =
    { $how ->
        [fell] { $head }: { $subject } bajó.
       *[rose] { $head }: { $subject } subió.
    }
learning-change-by =
    { $how ->
        [fell] { $head }: { $subject } bajó aproximadamente { $amount }, de { $first } a { $last }.
       *[rose] { $head }: { $subject } subió aproximadamente { $amount }, de { $first } a { $last }.
    }
learning-goes-on = Sigue cambiando, en pasos cada vez menores.
learning-not-level-yet = Todavía no se ha estabilizado.
learning-levels-off = Se estabiliza en aproximadamente { $level }.
learning-caution = { $count } ensayos son pocos: esto todavía puede cambiar.

## What changed within sessions, and over the pause from one to the next.

learning-sessions-noise = Ni el cambio durante una sesión ni el cambio en la pausa hasta la siguiente superan la variabilidad (media de { $sessions } sesiones).
learning-within =
    { $how ->
        [noise] Durante una sesión quedó dentro de la variabilidad
        [fell] Durante una sesión bajó aproximadamente { $amount }
       *[rose] Durante una sesión subió aproximadamente { $amount }
    }
learning-between =
    { $how ->
        [noise] en la pausa hasta la siguiente quedó dentro de la variabilidad
        [fell] en la pausa hasta la siguiente bajó aproximadamente { $amount }
       *[rose] en la pausa hasta la siguiente subió aproximadamente { $amount }
    }
# $within and $between are the two above.
learning-sessions = { $within } y { $between } (media de { $sessions } sesiones).
learning-sessions-perhaps-kept = { $within } y { $between } (media de { $sessions } sesiones): se conservó lo ganado, hasta donde se puede saber.
learning-sessions-kept = { $within } y { $between } (media de { $sessions } sesiones): se conservó lo ganado.
learning-sessions-part-kept = { $within } y { $between } (media de { $sessions } sesiones): se conservó alrededor del { $percent } % de lo ganado.
learning-sessions-lost = { $within } y { $between } (media de { $sessions } sesiones): no se conservó nada de lo ganado.

## Statistics, in the details.

learning-medians =
    { $how ->
        [fell] Según las medianas de los { $edge } primeros y los { $edge } últimos de { $trials } ensayos, { $subject } bajó de { $first } a { $last }.
        [rose] Según las medianas de los { $edge } primeros y los { $edge } últimos de { $trials } ensayos, { $subject } subió de { $first } a { $last }.
       *[went] Según las medianas de los { $edge } primeros y los { $edge } últimos de { $trials } ensayos, { $subject } pasó de { $first } a { $last }.
    }
learning-p-small =
    { $sessions ->
        [one] El último tercio de los ensayos frente al primero, con la variabilidad propia de esta persona como referencia: p < 0,001; un cambio tiene p < { $level }.
       *[other] El último tercio de las sesiones frente al primero, o la sesión más reciente frente a las anteriores, con la variabilidad propia de esta persona como referencia: p < 0,001; un cambio tiene p < { $level }.
    }
learning-p =
    { $sessions ->
        [one] El último tercio de los ensayos frente al primero, con la variabilidad propia de esta persona como referencia: p = { $p }; un cambio tiene p < { $level }.
       *[other] El último tercio de las sesiones frente al primero, o la sesión más reciente frente a las anteriores, con la variabilidad propia de esta persona como referencia: p = { $p }; un cambio tiene p < { $level }.
    }
learning-slope =
    { $how ->
        [falls] De un ensayo al siguiente baja { $step } de mediana.
       *[rises] De un ensayo al siguiente sube { $step } de mediana.
    }
learning-form-level = Ninguna curva describe estos ensayos mejor que una línea constante.
learning-form-power = Una ley de potencia describe estos ensayos mejor que una exponencial: al principio pasos grandes, después cada vez menores.
learning-form-open = La curva que mejor describe estos ensayos es una exponencial, que en ellos todavía no se ha estabilizado.
learning-form-constant = La curva que mejor describe estos ensayos es una exponencial, que se estabiliza en { $level }, con una constante de aprendizaje de { $trials } ensayos (95 %: de { $low } a { $high }).
learning-form-few = La curva que mejor describe estos ensayos es una exponencial, que se estabiliza en { $level }; la rapidez se indica a partir de { $least } ensayos.
learning-form-fast = La curva que mejor describe estos ensayos es una exponencial, que se estabiliza en { $level } ya en los primeros ensayos.
# $within and $between are the two below.
learning-statistics = { $within }, y { $between }.
learning-statistics-within =
    { $how ->
        [noise] De media en { $sessions } sesiones, durante una sesión cambió en { $change } (dentro de la variabilidad; 99 %: de { $low } a { $high })
        [fell] De media en { $sessions } sesiones, durante una sesión bajó { $change } (99 %: de { $low } a { $high })
       *[rose] De media en { $sessions } sesiones, durante una sesión subió { $change } (99 %: de { $low } a { $high })
    }
learning-statistics-between =
    { $how ->
        [noise] desde sus últimos ensayos hasta los primeros de la siguiente cambió en { $change } (dentro de la variabilidad; 99 %: de { $low } a { $high })
        [fell] desde sus últimos ensayos hasta los primeros de la siguiente bajó { $change } (99 %: de { $low } a { $high })
       *[rose] desde sus últimos ensayos hasta los primeros de la siguiente subió { $change } (99 %: de { $low } a { $high })
    }
