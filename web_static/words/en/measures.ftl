### Words beside the measures of a trial.

measure-of = of { $count }
measure-details = Details: what these are called in publications
measure-details-words = The distance driven is Dist of the 2008 study, the area off the path its E_diff: two loops around one place in opposite directions cancel in it, and the distance driven counts both. Smoothness is the spectral arc length (SPARC), the other measure of it the log dimensionless jerk: nearer to zero is smoother. A usual distance or error is the root of the mean square (rms).
interruption-halts =
    { $count ->
        [one] Halted once, { $seconds } s
       *[other] Halted { $count } times, { $seconds } s
    }
interruption-pauses =
    { $count ->
        [one] Paused once for the screen, { $seconds } s
       *[other] Paused { $count } times for the screen, { $seconds } s
    }
interruption-person-stops =
    { $count ->
        [one] Stopped once by a person, { $seconds } s
       *[other] Stopped { $count } times by a person, { $seconds } s
    }
interruption-left-out = All measures are of the time in which the chair was permitted to move.
interruption-ask = This trial counts when you say so.
interruption-column = Interruptions
interruption-none = none
