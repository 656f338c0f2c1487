### Words beside the measures of a trial.

measure-of = de { $count }
measure-details = Detalles: cómo se llaman en las publicaciones
measure-details-words = La distancia recorrida es Dist del estudio de 2008 y el área fuera del recorrido es E_diff. En esta última, dos bucles de sentido opuesto alrededor de un mismo punto se anulan; la distancia recorrida cuenta ambos. La fluidez es la longitud de arco espectral (SPARC); la otra medida de la fluidez es el logaritmo del jerk adimensional. Un valor más próximo a cero indica más fluidez. La distancia o el error habituales son la media cuadrática (rms).
interruption-halts =
    { $count ->
        [one] { $count } detención, { $seconds } s
       *[other] { $count } detenciones, { $seconds } s
    }
interruption-pauses =
    { $count ->
        [one] { $count } pausa por la pantalla, { $seconds } s
       *[other] { $count } pausas por la pantalla, { $seconds } s
    }
interruption-person-stops =
    { $count ->
        [one] { $count } parada por una persona, { $seconds } s
       *[other] { $count } paradas por una persona, { $seconds } s
    }
interruption-left-out = Todas las medidas corresponden al tiempo en que la silla podía moverse.
interruption-ask = Este ensayo solo cuenta si toca “Contarlo”.
interruption-column = Interrupciones
interruption-none = ninguna
