### Texts of the calibration: steps, cues, result.

calibrate-no-shirt = No shirt yet
calibrate-no-shirt-lead = The calibration learns from the signals of the shirt: choose the shirt first.
calibrate-no-shirt-go = Choose a shirt
calibrate-step = Step { $step } of { $steps }
calibrate-repetition = repetition { $repetition } of { $all }
calibrate-steps = The steps of the calibration
calibrate-step-waiting = not done yet
calibrate-step-running = is being recorded
calibrate-step-done = done
calibrate-step-skipped = skipped
calibrate-step-failed = has to be repeated
calibrate-start = Start
calibrate-again = Repeat this step
calibrate-cancel = Stop recording
calibrate-skip = Skip this movement
calibrate-next = Next
calibrate-auto = Go on by itself after each step
calibrate-ready-self = The simulated person does as the circle says: tap { $button }.
calibrate-ready-visitor = You move the simulated body: hold the pads or keys as the circle says. When you are ready, tap { $button }.
calibrate-ready-patient = When the patient is ready, tap { $button }.
calibrate-done = Done. Go on, or repeat it.
calibrate-poor = This step was recorded, but the chair could not be driven well with it. Repeat it, or go on anyway.
calibrate-going-on = Well done. Going on in a moment…
calibrate-now = Ready to drive
calibrate-now-lead =
    { $count ->
        [one] { $count } other person has moved in this shirt. Until this person's own movements are known, theirs are used, on the virtual chair only. Each movement that follows improves the calibration, one joint at a time, now or later.
       *[other] { $count } other people have moved in this shirt. Until this person's own movements are known, theirs are used, on the virtual chair only. Each movement that follows improves the calibration, one joint at a time, now or later.
    }
calibrate-now-go = Drive now
calibrate-earlier = There is a calibration of { $day } (version { $version }). Do Rest and Move freely: then it can be used again, fitted to how the shirt sits today. One joint of it cannot be repeated alone, because the shirt was put on anew: a new calibration takes every step.
calibrate-earlier-lead = The calibration of { $day } (version { $version }) can be used again: it is fitted to how the shirt sits today, and the controls stay as they are. The movements that follow here make a new calibration instead, which takes every step.
calibrate-earlier-go = Drive with this calibration
calibrate-short = Short calibration
calibrate-whole = Whole calibration
calibrate-short-good = The calibration is good enough. Sit still, then start the trial.
calibrate-wait = Wait
calibrate-fitting = Working out what each movement looks like…
cue-ready = Get ready
cue-rest = Rest
cue-free = Move freely
cue-return = Slowly back
cue-move = Move
cue-move-elbow = Bend
cue-move-wrist = Bend
cue-move-shoulder = Push
cue-seconds = { $seconds } s
cue-next-ready = Next: get ready
cue-next-rest = Next: rest
cue-next-free = Next: move freely
cue-next-return = Next: slowly back
cue-next-move = Next: move
cue-next-move-elbow = Next: bend
cue-next-move-wrist = Next: bend
cue-next-move-shoulder = Next: push
cue-next-end = Next: the end of this step
cue-trace = The shirt's signals, the last 10 seconds
result-title = What this body can do
result-lead = Each card shows how clear the main movement of a joint is, and how well that movement is expected to work. The marks show the 80 to 90 % of the 2008 study.
result-repeat = Repeat
result-evr = Clear main movement: { $percent }
result-signal = Signal: { $word }
result-repeats = Repeats { $word }
signal-strong = strong
signal-fair = fair
signal-weak = weak
repeats-well = well
repeats-fairly = fairly
repeats-poorly = poorly
result-from-others = From other people
result-from-both = From other people and own movement
result-from-own = Own movement
result-from-others-lead =
    { $count ->
        [one] Learnt from the movements of { $count } other person.
       *[other] Learnt from the movements of { $count } other people.
    }
result-expected-hits = About { $value } of 100 movements are recognised (± { $uncertainty }).
result-expected-false = At rest this movement is recognised by mistake about { $value } times a minute (± { $uncertainty }).
result-expected-prompted = The repetitions of this movement make the first figure more certain (± { $uncertainty }). They also show how often it is recognised by mistake at rest.
result-expected-hits-none = It is not known yet how many of 100 movements are recognised: the free movement had none in this direction.
result-expected-false-none = It is not known yet how often this movement is recognised by mistake at rest: it must be repeated first.
result-expected-own-hits = About { $value } of 100 movements are recognised. So few repetitions prove only that at least { $bound } are.
result-expected-own-false = At rest this movement is recognised by mistake { $value } times a minute. So short a rest proves only that it is fewer than { $bound } times.
result-expected-none = It is not known yet how well this movement works: it must be repeated first.
result-sits-shifted = The shirt is turned on the { $joint }: by { $count } of { $sensors } sensors.
result-sits-mirrored = The shirt is inside out or on the other side at the { $joint }.
result-sits-lead = This calibration takes that into account. You can leave it so, or put the shirt right as the picture shows and begin the calibration anew. If you are sure that it sits right, say so.
result-sits-right = It sits right
result-sits-right-label = It sits right at the { $joint }: calibrate the shirt as it is worn
result-sits-left = The shirt looks turned at the { $joint }. The calibration does not correct for that, because you said that the shirt sits right.
result-sits-follow = Treat it as turned
result-sits-follow-label = Treat it as turned at the { $joint }, and correct for that
result-sits-picture-mirrored = The sensors of one side of the { $joint } lie on the other side: turn the shirt the right side out, or put it on the other arm
result-sits-side-front = front
result-sits-side-back = back
result-sits-side-outside = outer side
result-sits-side-inside = inner side
result-sits-picture = Turn the shirt round the { $joint } by { $count } of its { $sensors } sensors
result-details = Details
result-details-signal = Its full movement stands { $value } times above the noise at rest (signal to noise).
result-details-repeats = The peaks of the repetitions lie within { $percent } of each other.
result-details-evr = Share of the signal in one direction (explained variance ratio, EVR): { $percent }.
result-again = Repeat this joint
result-again-label = Repeat this joint: { $joint }
result-maps-pca = Standard
result-maps-guided = Learnt from the cues
result-maps-choose = { $joint }: which calibration to use
result-maps-better = Another calibration is available
result-maps-in-use-guided = The calibration learnt from the cues is in use
result-maps-in-use-prior = The calibration learnt from other people is in use
result-maps-prior = Learnt from other people
result-maps-lead-prior =
    { $count ->
        [one] Each figure is of { $count } repetition of this person. It had no part in the calibration that was learnt from other people.
       *[other] Each figure is of { $count } repetitions of this person. Each repetition was tried with a calibration in which it had no part.
    }
result-maps-lead-guided =
    { $count ->
        [one] Both were learnt from this calibration. Each figure is of the { $count } repetition that was kept apart.
       *[other] Both were learnt from this calibration. Each figure is of { $count } repetitions that were kept apart.
    }
result-maps-in-phase = Share of the effect that comes during the asked movement
result-maps-hit = Share of the asked movement's time in which it has an effect
result-maps-false = Effects at rest, times a minute
result-maps-kept-guided = The calibration learnt from the cues is not offered: it would not be better for this joint.
result-maps-kept-prior = The calibration learnt from other people is not offered: it would not be better for this joint.
result-maps-details = The standard calibration is the main direction of the movement (PCA), the other a linear map guided by the cues.
result-bar = { $joint }: clear main movement { $percent }; the study had 80 to 90 %
result-cross = When one movement is made, what else counts
result-cross-lead = 1.00 is the strength of the asked movement. The other numbers should be small.
result-cross-asked = asked: { $joint }
result-left-out =
    { $count ->
        [one] { $count } sensor left out: { $which }
       *[other] { $count } sensors left out: { $which }
    }
result-left-out-none = All sensors are in use.
result-accept = Use this calibration
result-accepted = This calibration is in use.
result-go-on = Go on to the controls
result-others-lead =
    { $count ->
        [one] { $count } movement has not been recorded yet. Until then, other people's calibrations are used for it. Drive now, or record the movement first.
       *[other] { $count } movements have not been recorded yet. Until then, other people's calibrations are used for them. Drive now, or record the movements first.
    }
result-missing = The result comes when every step is done.
result-missing-lead =
    { $count ->
        [one] One step is missing.
       *[other] { $count } steps are missing.
    }
result-restart = Begin anew
result-restart-ask = Begin the calibration anew? What was recorded so far no longer counts.
result-restarted = The calibration begins anew.
