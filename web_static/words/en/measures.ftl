### Words beside the measures of a trial.

measure-of = of { $count }
measure-details = Details: what these are called in publications
measure-details-words = The distance driven is Dist of the 2008 study, and the area off the path is E_diff. Two loops around one place in opposite directions cancel each other in E_diff; the distance driven counts both. Smoothness is the spectral arc length (SPARC), and the second measure of smoothness is the log dimensionless jerk. In both, a value nearer to zero is smoother. A usual distance or error is the root mean square (rms).
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
interruption-left-out = All measures cover only the time in which the chair was permitted to move.
interruption-ask = This trial counts only after you tap “Count it”.
interruption-column = Interruptions
interruption-none = none
