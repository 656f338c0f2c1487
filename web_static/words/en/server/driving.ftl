### Why a command to the chair, the shirt or the head tracker is refused; why the chair cannot be armed; the state of
### what is connected; why a recorded drive cannot be computed again.

## Arming

drives-during-test = The two-minute test is running, in which no chair moves: end it first, then arm.
drives-not-calibrated = There is nothing to drive with: calibrate first.
drives-controls-changed = The controls, or the chair's document, were changed meanwhile: load the controls again, then arm.
# $happened and $remedy are whole sentences on the stop that is still in force: what happened, and what to do.
drives-latched = { $happened } { $remedy } Take the stop back first.
drives-speed-without-brake = With these controls the chair would keep a speed that no movement can slow: on the Controls page, bind a movement to the opposite direction or to Stop, or choose “Follows the movement”.
drives-posture-without-brake = With these controls a sensor that sticks while a posture is held could drive the chair on, and no movement could stop it: on the Controls page, bind movements of other joints to Stop, or choose “Moving” in place of “Holding”.
# $problem says what became of the key of the pairing, without a full stop.
drives-shirt-unpaired = The shirt is no longer paired: { $problem }.
# $problem says what became of the key of the pairing, without a full stop.
drives-chair-unpaired = The chair is no longer paired: { $problem }.
drives-only-recorded = A real chair drives only while it is recorded: begin a drive first.
# $state is a whole sentence: the state of the chair.
drives-switch-pressed = { $state } Look around, release the switch and the joystick, then arm again.
drives-switch-unproved = With “Keeps its speed” or “Keeps turning” a chair goes on by itself, so a real one needs its stop switch: press and release it once to show that it works, or choose “Follows the movement” on the Controls page.
drives-virtual-chair-chosen = The virtual chair is chosen: choose a real one first.
drives-not-practised = This set was never practised on the virtual chair of this clinic: finish a trial with it first, and let it count.
drives-show-the-switch = With “Keeps its speed” or “Keeps turning” a chair goes on by itself: press and release its stop switch once to show that it works, or choose “Follows the movement” on the Controls page.
drives-wait-for-process = The control process is being restarted: wait a moment.
# $name is the name of a chair.
drives-chair-silent = { $name } does not answer: check its power and the network.
# $name is the name of a chair.
drives-stop-switch-pressed = The stop switch of { $name } is pressed: look around, then release it.

## Refused commands

# $commands lists the names of all commands.
drives-no-command = There is no command '{ $name }': use one of { $commands }.
# $problem is a sentence without its full stop: what is wrong, and what to do.
drives-problem = { $problem }.
drives-opening = Another device is being opened: wait a moment, then try again.
drives-wrong-sender = This sender sends no frames of this shirt: look at the Shirt page which sender does.
drives-keys-move-nobody = The keys move nobody in this shirt: choose “You” as the body first.
drives-no-tablet = No tablet is used as the head tracker: choose it on the Shirt page first.
drives-no-camera = The camera is not the shirt in use: choose it on the Shirt page first.
drives-no-pose = The head tracker has not said where the head looks: wait for its first pose.
drives-run-ending = The recording is being ended: begin a new one, then arm.
drives-another-stop = There was another stop meanwhile: look around, then tap Continue again.
drives-recording = Something is being recorded already: end it first.
drives-armed = The chair is armed: end the drive first.
drives-no-body = Only the simulated shirt has a body to choose: choose the simulated shirt first.
drives-limits-while-moving = Limits are raised only while the chair stands and nobody moves: end the drive first.
drives-dial-while-moving = The dial is turned up only while the chair stands and the patient is at rest.
drives-plan-on-real-chair = A real chair drives in no floor plan: choose the virtual chair first.
drives-other-sensors = These controls were made for a shirt with other sensors: calibrate with this shirt.
# $cutoff is in Hz; $least and $rate are frames a second.
drives-cutoff-too-high = Tremor damping of { $cutoff } Hz needs more than { $least } frames a second, and this shirt sends { $rate }: set a lower one on the Controls page.
drives-still-stopping = The chair is still coming to a stop: try again in a moment.
drives-not-recording = Nothing is being recorded: begin a run first.
# $problem is the reason that the operating system gives.
drives-cannot-record = The recording cannot be begun ({ $problem }): free some disk space.
drives-disk-full = Only { $free } MB are free on the disk of the recordings, and nothing may be lost of a drive: make that { $needed } MB, then begin again.

## Devices

drives-no-shirt = No shirt is connected: choose one on the Shirt page.
drives-no-tracker = No head tracker is connected: the view looks straight ahead.
drives-tracker-failed = The head tracker failed ({ $problem }): choose it again.
drives-shirt-failed = The shirt failed ({ $problem }): choose it again.
drives-virtual-chair =
    { $dynamics ->
        [wheelchair] The virtual chair, which moves like a real one.
       *[unicycle] The virtual chair, which answers at once.
    }
drives-others-hang =
    { $device ->
        [shirt] The shirt is not opened, for { $count } earlier attempts to open a device have not ended: start bodydrive again.
        [body] The body is not opened, for { $count } earlier attempts to open a device have not ended: start bodydrive again.
        [chair] The chair is not opened, for { $count } earlier attempts to open a device have not ended: start bodydrive again.
       *[tracker] The head tracker is not opened, for { $count } earlier attempts to open a device have not ended: start bodydrive again.
    }
drives-opening-slow =
    { $device ->
        [shirt] The shirt did not open within { $seconds } seconds: check its settings.
        [body] The body did not open within { $seconds } seconds: check its settings.
        [chair] The chair did not open within { $seconds } seconds: check its settings.
       *[tracker] The head tracker did not open within { $seconds } seconds: check its settings.
    }
# $library is the name of a Python package.
drives-library-missing =
    { $device ->
        [shirt] The shirt needs the library '{ $library }', which is not installed: install it, then choose it again.
        [body] The body needs the library '{ $library }', which is not installed: install it, then choose it again.
        [chair] The chair needs the library '{ $library }', which is not installed: install it, then choose it again.
       *[tracker] The head tracker needs the library '{ $library }', which is not installed: install it, then choose it again.
    }
# $error is the name of an error in the program's code.
drives-cannot-open =
    { $device ->
        [shirt] The shirt cannot be opened ({ $error }): check its settings.
        [body] The body cannot be opened ({ $error }): check its settings.
        [chair] The chair cannot be opened ({ $error }): check its settings.
       *[tracker] The head tracker cannot be opened ({ $error }): check its settings.
    }
# $error is the name of an error in the program's code, $message is what it says.
drives-cannot-open-message =
    { $device ->
        [shirt] The shirt cannot be opened ({ $error }: { $message }): check its settings.
        [body] The body cannot be opened ({ $error }: { $message }): check its settings.
        [chair] The chair cannot be opened ({ $error }: { $message }): check its settings.
       *[tracker] The head tracker cannot be opened ({ $error }: { $message }): check its settings.
    }
# $action is the name of a command, $error is the name of an error in the program's code, $message is what it says.
drives-defect = The program has a fault, and '{ $action }' was not done ({ $error }: { $message }): please report it.

## The control process

drives-not-a-command = This is no command: send one JSON object a line, with a whole number 'id' and a word 'do'.
drives-no-reason = The control process refused without saying why.
# $command is the name of a command.
drives-process-silent = The control process did not answer '{ $command }' within { $seconds } seconds.
drives-process-ended = The control process has ended, and a new one starts: try again in a moment.
drives-process-not-started = The control process did not start: look for its message on the console.
drives-process-restarting = The control process is being restarted, and the chair stands: try again in a moment.
drives-process-no-answer = The control process did not answer, and the chair stands: try again.

## A recorded drive, computed again

drives-replay-no-frame = the recording holds no frame of the shirt: choose another one
drives-replay-empty = the recording holds nothing: choose another one
# Two counts of channels.
drives-replay-channels = the recording has { $recorded } channels and the profile { $expected }: use the profile of the same shirt
# $stated is what stands in the file run.json; the others are in Hz.
drives-replay-rate = run.json gives the sample rate as { $stated }, which must be { $slowest } to { $fastest } Hz: correct it
# Begins a sentence on what is wrong: a field of the file run.json of the recording.
drives-replay-part = run.json, { $part }
