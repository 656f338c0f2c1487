### Texts of the verdicts on changes.

verdict-range = de { $low } a { $high }
verdict-title = ¿Mejora o variabilidad?
verdict-column = Valoración
verdict-noise = Variabilidad
verdict-familiarisation = Este es uno de los tres primeros ensayos de esta tarea. Son de familiarización y no se comparan.
verdict-means = La variabilidad es cuánto difieren entre sí los ensayos de esta persona en esta tarea sin que haya un cambio. Una valoración necesita cinco ensayos de la tarea en total. Entre una sesión y la siguiente necesita además sesiones anteriores, o los ensayos de otras tres personas de la clínica en esta tarea.
verdict-chance = Solo tienen valoración las tres medidas principales de una tarea y la frecuencia con que se alcanzó la meta. Si no ha cambiado nada, alrededor de una página de cada veinte indica mejora o empeoramiento por azar.
verdict-missed = Entre sesiones, un ensayo que no alcanzó la meta se considera igual o peor que el peor 10 % de los ensayos anteriores que la alcanzaron.
verdict-unpublished = No se ha publicado el cambio mínimo detectable de estas medidas de la conducción de sillas de ruedas.
verdict-sessions =
    Sesión { $later } ({ $laterDay }, { $laterTrials ->
        [one] { $laterTrials } ensayo
       *[other] { $laterTrials } ensayos
    }) frente a la sesión { $earlier } ({ $earlierDay }, { $earlierTrials ->
        [one] { $earlierTrials } ensayo
       *[other] { $earlierTrials } ensayos
    })
verdict-session = Sesión { $number }
verdict-all = Todas las medidas
verdict-counts =
    { $count ->
        [one] De los { $all } ensayos de esta tarea se puede comparar { $count }: los tres primeros son de familiarización.
       *[other] De los { $all } ensayos de esta tarea se pueden comparar { $count }: los tres primeros son de familiarización.
    }
verdict-counts-none = Todavía no se puede comparar ningún ensayo de esta tarea (hechos: { $all }): los tres primeros son de familiarización.
verdict-needed = Una valoración necesita { $count } ensayos comparables, sumando los de dos sesiones: repita esta tarea.
verdict-few =
    { $count ->
        [one] Hasta ahora se puede comparar { $count } ensayo; se necesitan { $needed }.
       *[other] Hasta ahora se pueden comparar { $count } ensayos; se necesitan { $needed }.
    }
verdict-few-sessions = Se pueden comparar { $count } ensayos, que son suficientes. Para comparar sesiones hace falta una sesión más, o los ensayos de otras tres personas de la clínica en esta tarea.
verdict-compare = Comparar sesiones
