### What is said about trials: verdicts, warnings of control quality, events and interruptions.

## A verdict in a table: how a measure changed.

verdict-word-better = better than noise
verdict-word-within = within noise
verdict-word-worse = worse than noise
verdict-word-few-trials = too few trials
verdict-word-few-tests = too few tests
# There is no verdict.
verdict-word-none = –

## A measure that has become worse over sessions.

verdict-worse = Worse than this person's own noise since session { $session }. What to do: check the fit of the shirt and the warnings of control quality, ask about pain, sleep and medication, and calibrate again. If the next two sessions are as bad, talk to the physician.
verdict-goal-missed = The goal is missed more often than by this person's own noise since session { $session }. What to do: check the fit of the shirt and the warnings of control quality, ask about pain, sleep and medication, and calibrate again. If the next two sessions are as bad, talk to the physician.

## Warnings of control quality, each with advice. $joint is a name such as "Left elbow".

# The joints of a warning, as in "Left elbow and Right elbow".
warning-joints = { $joints }
warning-few-trials =
    Few trials: whether movements get smaller is told from { $least_trials } trials of one task in one session, or from { $least_sessions } sessions on. So far: { $trials ->
        [one] { $trials } trial in the last session
       *[other] { $trials } trials in the last session
    }, { $sessions ->
        [one] { $sessions } session in all.
       *[other] { $sessions } sessions in all.
    }
warning-shirt = The shirt does not sit as it was calibrated: { $count } sensors ({ $joints }) lay outside their calibrated range in trial { $trial }, and what these joints did had no effect.
warning-shirt-advice = Set the shirt straight. When it was put on again, fit the calibration to it on the { rail-calibrate } page.
warning-sensor-silent = { $joint }: sensor { $sensor } gave no signal for { $percent } % of trial { $trial }; meanwhile what this joint did had no effect.
warning-sensor-range = { $joint }: sensor { $sensor } lay outside its calibrated range for { $percent } % of trial { $trial }; meanwhile what this joint did had no effect.
warning-sensor-advice = Look at it on the { rail-shirt } page, set the shirt straight and push the plug in fully. If it stays so, choose “{ sensor-unused }” there and calibrate again.
warning-turned = { $joint }: the movement has turned by { $degrees }° against the first trials with this calibration.
warning-turned-advice = Was the shirt put on again, or has it slipped? Set it straight, or calibrate again.
warning-off-map = { $joint }: the movement lies { $degrees }° off the calibration, and { $percent } % of it never reaches the control.
warning-off-map-advice = Repeat this joint's free movement and prompts as the person moves it while driving.
warning-unclear = { $joint }: the main movement is clear to only { $percent } %, less than in the first trials.
warning-unclear-advice = Ask the person to move this joint one way only; if that does not help, calibrate again.
# Behind one of the three advices above.
warning-other-map = Another calibration than the standard one drives this joint: look whether it is still right.
warning-trembles = { $joint }: at rest it trembles with { $percent } % / s of the full movement, and it counts from { $counts_from } % / s, so that it may act by itself: let it count from { $better_from } % / s.
warning-trembles-advice = Look for tremor, a tired patient or a loose plug. Then raise its “{ tune-from }” on the { rail-controls } page, or lower “{ speed-cutoff }”: lower damps more.
warning-noise = { $joint }: the noise at rest has grown to { $ratio } times that of the first trials.
# Rest is a step of the calibration.
warning-noise-advice = Look for tremor, a tired patient or a loose plug on the { rail-shirt } page. When it stays, repeat the step “{ calibration-rest }” of the calibration, so that the movement counts only above the noise.
warning-smaller = { $joint }: the movement has become { $percent } % smaller over { $sessions } sessions.
warning-smaller-advice = Ask about strength and pain. When it stays, calibrate again, so that “{ tune-full }” is what the person can reach now, and note the range of motion in the record.
warning-tired = { $joint }: the movement has become { $percent } % smaller within this session.
warning-tired-advice = The person may be tired: let them rest, or end the session. Do not calibrate on a tired movement.

## Events of a trial on its time line.

timeline-checking = The check for rest began.
timeline-armed = Motion was permitted.
timeline-disarmed = Motion was permitted no more.
timeline-contact = The chair touched something.
timeline-goal = The goal was reached.

## A recording that cannot be shown. $damage is one or more whole sentences.

trial-recording-no-place = The recording of this trial names no place: choose another trial.
trial-recording-empty = The recording of this trial holds nothing: choose another trial.
trial-recording-damaged = The recording of this trial holds nothing. { $damage }

## What interrupted a trial, how often, and for how long.

interruption-halted =
    { $times ->
        [one] halted once, { $seconds } s
       *[other] halted { $times } times, { $seconds } s
    }
interruption-paused =
    { $times ->
        [one] paused once, { $seconds } s
       *[other] paused { $times } times, { $seconds } s
    }
interruption-stopped =
    { $times ->
        [one] stopped by a person once, { $seconds } s
       *[other] stopped by a person { $times } times, { $seconds } s
    }
# Of the three above.
interruptions-several = { $before }; { $after }
interruptions-asked = the machine interrupted it ({ $interruptions }), and nobody has said yet that it counts
