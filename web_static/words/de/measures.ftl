### Wörter neben den Messwerten eines Durchgangs.

measure-of = von { $count }
measure-details = Details: wie diese in Veröffentlichungen heißen
measure-details-words = Der gefahrene Weg heißt in der Studie von 2008 Dist, die Fläche neben der Strecke E_diff. Zwei Schleifen um dieselbe Stelle in Gegenrichtung heben sich in E_diff auf, der gefahrene Weg zählt beide. Die Gleichmäßigkeit ist die spektrale Bogenlänge (SPARC), das zweite Maß dafür der Logarithmus des dimensionslosen Rucks. Näher bei null ist gleichmäßiger. Ein üblicher Abstand oder Fehler ist der quadratische Mittelwert (RMS).
interruption-halts =
    { $count ->
        [one] Einmal angehalten, { $seconds } s
       *[other] { $count }-mal angehalten, { $seconds } s
    }
interruption-pauses =
    { $count ->
        [one] Einmal Pause wegen des Bildschirms, { $seconds } s
       *[other] { $count }-mal Pause wegen des Bildschirms, { $seconds } s
    }
interruption-person-stops =
    { $count ->
        [one] Einmal von einer Person gestoppt, { $seconds } s
       *[other] { $count }-mal von einer Person gestoppt, { $seconds } s
    }
interruption-left-out = Alle Messwerte gelten für die Zeit, in der der Rollstuhl fahren durfte.
interruption-ask = Dieser Durchgang zählt erst, wenn Sie auf „Zählen lassen“ tippen.
interruption-column = Unterbrechungen
interruption-none = keine
