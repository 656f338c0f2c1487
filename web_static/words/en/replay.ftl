### Texts of the review of one trial and of two side by side.

compare-column = Compare
compare-pick = Compare trial { $number }
compare-go = Compare two trials
compare-chosen = Trial { $first } and trial { $second } are chosen.
compare-choose =
    { $count ->
        [one] Tick one more trial.
       *[other] Tick two trials of the list.
    }
compare-title = Two trials side by side
compare-trial = Trial { $number }
compare-difference = Difference
compare-measures = Measures
compare-plan = Both trajectories over the path
compare-now = { $along } m along the path, { $v } m/s, { $across } m from it
compare-now-spot = { $v } m/s
compare-along = along the path (m)
compare-speed = Speed along the path
compare-speed-axis = speed (m/s)
compare-across = Distance from the path, along it
compare-across-axis = distance from the path (m), left positive
compare-start = Both replays begin when the chair was first permitted to move.
compare-other-path = These two were not driven on the same path, so only their measures stand side by side, and differences say little.
compare-no-recording = There is no replay: { $why }
compare-pairs = Choose two trials in Review.
compare-verdict = Verdict on trial { $number }
compare-used = A trial for getting used to the task is not compared: trial { $numbers }.
compare-no-measures = Neither of the two was measured.
replay-title = Look at it again
replay-play = Play
replay-pause = Pause
replay-speed = Speed of the replay
replay-slider = Moment of the trial
replay-at = { $t } of { $end } seconds
replay-keys = Arrow keys go by a second, with Shift by ten; P plays and pauses. The space bar is Stop, as everywhere.
replay-plan = From above
replay-events = What happened
replay-charts = Signals, movements and commands
replay-charts-lead = Tap on any chart to go to that moment. Where it is grey, motion was not permitted.
replay-chart = { $title } over time
replay-chair = Chair
replay-v = speed
replay-omega = turn rate
replay-commands = Commands
replay-activations = How strongly each movement counts
replay-rates = Movement per second
replay-scores = Extent of the movement
replay-command-speed = Speed
replay-command-turning = Turning
replay-unit-full = 1 is full
replay-unit-rate = share of the full movement per second
replay-unit-share = share of the full movement
replay-signals = Signals: { $shown } of { $of } sensors
replay-joint = Sensors of
replay-none = There is no replay of this trial.
replay-look = Look at it again
replay-picture = Picture of the replay
replay-picture-off = The replay in 3D is off: { $why }
replay-picture-loading = The picture is coming…
replay-picture-webgl = This screen cannot draw the 3D view (its browser offers no WebGL 2), so the replay is shown in the drawn plan.
replay-picture-context = the browser has switched off the graphics of this page. Choose Plan, or wait until they are back.
replay-picture-again = Show it in 3D
