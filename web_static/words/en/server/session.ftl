### A visit of a patient: the open session, its equipment, its calibration, its trials and drives, and the adaptation of
### the calibration.

## The open session

visit-nobody = No session is open: choose a patient on the Patients page first.
visit-not-calibrated = Nothing is calibrated yet: calibrate first, and tap “{ result-accept }”.
visit-shirt-silent = The shirt sends no signals: the Shirt page says what arrives from it.
visit-calibrated-unworn = The patient's calibration is one of a shirt that nobody wore: calibrate in the worn shirt first.
visit-calibrated-in-another = The patient was calibrated in another shirt: calibrate in this one first.
visit-calibrated-at-another-rate = The shirt sends at another rate than it was calibrated at: calibrate again first.
visit-code-wrong = This code is wrong, used or older than { $minutes } minutes: ask for a new one from the clinician's page.

# $now and $page are whole sentences: which session is open now, and what the page shows.
visit-another-session = { $now } { $page }
visit-session-ended = The session was ended on another screen, and no session is open now.
# $code is the code of a patient, $time a time of day.
visit-session-opened = { $code } was opened on another screen at { $time }.
visit-session-opened-by = { $code } was opened on another screen by { $person } at { $time }.
visit-page-of-no-session = What this page shows belongs to no session and can no longer be sent: load the page again.
# $code is the code of a patient.
visit-page-of-session = What this page shows belongs to { $code } and can no longer be sent: load the page again.

## What must end first

visit-busy =
    { $running ->
        [trial] A trial is running. End it first, then try again.
        [drive] The real chair is armed. End the drive first, then try again.
        [step] A calibration step is running. Wait for its end or stop the recording, then try again.
       *[test] The two-minute test is running. End it first, then try again.
    }
visit-already-recorded =
    { $start ->
        [trial] Something is being recorded already: end it first, then start a trial.
        [drive] Something is being recorded already: end it first, then arm the chair.
       *[test] Something is being recorded already: end it first, then start the two-minute test.
    }
visit-recording = Something is being recorded already: wait for its end, or stop the recording first.
visit-no-trial = No trial is running: start one first.
visit-trial-still-measured = The trial is still being measured: look at it again in a moment.
visit-no-drive = The chair is not being driven: arm it first.
visit-drive-still-closing = The recording is still being closed: look at the drive again in a moment.
visit-no-test = No two-minute test is running: start one first.
visit-test-still-measured = The two-minute test is still being measured: look at it again in a moment.

## Recordings

visit-ticks-lost =
    { $count ->
        [one] { $count } turn of the control loop was lost while recording: close other programs, then repeat this step.
       *[other] { $count } turns of the control loop were lost while recording: close other programs, then repeat this step.
    }
visit-recording-without-plan = The recording does not hold the floor plan of its trial: it cannot be measured again.
visit-recording-without-parameters = The recording does not say with what parameters it was driven: it cannot be judged.

## Equipment

visit-no-shirt = No shirt yet: choose one on the Shirt page.
# $name is the name of a sensor.
visit-no-sensor = This shirt has no sensor '{ $name }': choose one of its lamps.
visit-layout-unreadable = The shirt's layout cannot be read: choose another shirt.
visit-no-file =
    { $kind ->
        [key] There is no file '{ $name }' here: pair the shirt first (bodydrive shirt pair).
       *[file] There is no file '{ $name }' here: bring it with 'Add a file' first.
    }
visit-keys-used-up = Every number of a shirt's key was used: begin with a new folder for the clinic.
# Of the phones that are paired as sensors.
visit-no-phone = There is no phone { $number }: look at the list again.
visit-phones-most = All { $most } numbers of phones are taken: unpair one first.
visit-chair-virtual = The virtual chair: nothing moves but the picture.
visit-chair-not-open = The chair is not open: choose it again.
# $name is the name of a chair.
visit-chair-not-open-named = { $name } is not open: choose it again.
visit-chair-silent = The chair does not answer: check its power and the network.
visit-chair-unknown-fault = The chair reports a fault that this program does not know.

## Calibration

visit-shirt-changed = The shirt is another one than when this calibration began: begin the calibration anew.
# $step is the name of a step in the program.
visit-no-step = There is no step '{ $step }' in this calibration: choose one of the list.
visit-step-recorded = A step is being recorded: wait for its end, or stop the recording first.
visit-step-not-recorded = This step is not being recorded, or no longer: start it, or choose another.
visit-no-short-calibration = Only a camera that sees head, trunk and shoulders has a short calibration: begin the whole one.
visit-step-needed = Rest and free movement cannot be skipped: the calibration is made of them.
visit-step-interrupted = The program ended during this step: repeat it.
visit-step-process-ended = The control process ended during this step: repeat it.
visit-step-nothing-recorded = Nothing was recorded for three seconds: look at the Shirt page, then repeat this step.
visit-step-lossy = Only { $share } % of the shirt's signals arrived: check its battery and transmitter, then repeat this step.
visit-step-silent = The shirt was silent for { $seconds } seconds: check its transmitter, then repeat this step.
# $joint is the name of a joint, $reason one or more whole sentences on its movement.
visit-no-joint-moves = No joint moves clearly enough. { $joint }: { $reason }
visit-drive-now-too-early = Do Rest and Move freely first. Driving at once needs four other people who are known in this shirt.
visit-fit-too-early = Do Rest and Move freely first. Fitting needs an earlier calibration of this patient in this shirt.
visit-fitting = It is being worked out.
visit-fit-interrupted = The fit was interrupted: repeat any step, and it is done again.
visit-controls-changed = The controls were changed meanwhile: try again.
visit-calibration-without-shirt = There is no shirt: choose one on the Shirt page, then begin the calibration anew.
visit-no-result = There is no result yet: do every step first.
# $joint and $joints are names of joints in the program.
visit-no-map = There is no calibration for '{ $joint }': choose one of { $joints }.
visit-guided-not-better = The calibration learnt from the cues is not better for this joint: keep the standard one.
visit-prior-not-better = There is no better calibration from other people for this joint: keep the present one.
visit-ring-not-turned = At this joint the shirt sits as on other people: there is nothing to choose.

## Adaptation of the calibration

visit-adapt-off = This patient's calibration stays as it is: look now, or choose that changes are suggested.
visit-adapt-suggest = When a trial on the virtual chair shows that the calibration fits less well, this page shows what would change.
visit-adapt-auto = When a trial on the virtual chair shows that the calibration fits less well, this page shows what changes.
visit-adapt-not-now = You left it as it is: it is looked at again after the next trial.
visit-adapt-no-trials = Nothing was driven with this calibration yet: drive a trial on the virtual chair, then look again.
visit-adapt-left-off = Somebody drives: it is looked at again after the trial.
visit-adapt-switched = The calibration no longer adapts by itself: look at the proposal, then decide.
visit-adapt-stale = The controls or the trials were changed since this was proposed: look again, then decide.
visit-adapt-gone = This proposal no longer exists: look again, then decide.
visit-adapt-real-chair = A real chair is chosen, and nothing is adapted there: choose the virtual one first.
visit-adapt-not-still = The chair is armed or moves: end the trial or drive, then apply.
visit-adapt-large = The patient would feel it: 5 % or more. So it waits until somebody looks at it and applies it.
visit-adapt-restarting = The control process is being restarted: wait a moment, then try again.
visit-adapt-stopped = A stop is still in force: take it back first, then apply.
