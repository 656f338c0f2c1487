### Faults: why motion was refused or ended, and what a person does next. The first texts of each are for the
### clinician, those with -patient for the patient, who reads no technical details.

# The next step of a fault after which Continue goes on with the trial or the drive.
remedy-continue = { $remedy } Then tap Continue.

fault-none = Nothing is wrong.
fault-none-remedy = Go on.
fault-none-patient = The chair was stopped.

fault-stop-tablet = Stop was pressed on the screen.
fault-stop-tablet-remedy = Look around.
fault-stop-tablet-patient = Stop was pressed on a clinician's page.

fault-stop-gesture = The patient made the stop gesture.
fault-stop-gesture-remedy = Ask the patient.
fault-stop-gesture-patient = You stopped the chair.

fault-stop-key = Stop was pressed on the keyboard.
fault-stop-key-remedy = Look around.
fault-stop-key-patient = Stop was pressed on a clinician's page.

fault-not-neutral = The body was not at rest within 5 seconds.
fault-not-neutral-remedy = Ask the patient to rest, or raise “Counts from” of the active movement in Controls.
fault-not-neutral-patient = Your body was not at rest yet: let your arms hang.

fault-shirt-silent = The shirt stopped sending, or its signals come too late.
fault-shirt-silent-remedy = Check its battery and cable, and look at the Shirt page.
fault-shirt-silent-patient = The shirt sent nothing any more.

fault-shirt-lossy = More than a tenth of the shirt's signals were lost.
fault-shirt-lossy-remedy = Bring the shirt's transmitter closer.
fault-shirt-lossy-patient = Signals of the shirt were lost.

fault-channels-bad = Sensors of two movements gave impossible values.
fault-channels-bad-remedy = See the lamps on the Shirt page; repeat the calibration without the bad sensors.
fault-channels-bad-patient = Some sensors of the shirt need a look.

fault-web-silent = The program sent nothing to the control process.
fault-web-silent-remedy = Wait for the page to return, then start again.
fault-web-silent-patient = The program was interrupted.

fault-screen-lost = The screen that started the drive sent nothing for 0.3 s: it was out of reach or overloaded, or its page was closed.
fault-screen-lost-remedy = See that this screen is connected and shows the page.
fault-screen-lost-patient = Your clinician's screen was out of reach.

fault-screen-hidden = The page that started the drive was hidden or left.
fault-screen-hidden-remedy = Bring it to the front and leave it there.
fault-screen-hidden-patient = Your clinician's page was out of view.

fault-screen-slow = The page that started the drive stood still for too long, and Stop could not be pressed on it.
fault-screen-slow-remedy = Close other pages and programs on that screen, or make its window smaller.
fault-screen-slow-patient = Your clinician's screen was too slow.

fault-bad-number = A command was not a number.
fault-bad-number-remedy = Do not drive; repeat the calibration and report this.
fault-bad-number-patient = The program made a mistake.

fault-loop-late = The control loop stood still for too long.
fault-loop-late-remedy = Close other programs on this machine.
fault-loop-late-patient = The program was too slow.

fault-recording-lost = The recording could not be written.
fault-recording-lost-remedy = Free some disk space, then start a new trial.
fault-recording-lost-patient = The drive could not be recorded.

fault-control-lost = The control process ended, and the chair stands.
fault-control-lost-remedy = A new one is starting, disarmed; then start again.
fault-control-lost-patient = A part of the program ended.

fault-stop-chair = The chair's own stop switch was pressed, its own joystick was moved, or the chair reports a fault.
fault-stop-chair-remedy = Look around, release the switch and the joystick.
fault-stop-chair-patient = The chair was stopped by its own switch or joystick, or has a fault.

fault-chair-silent = The chair no longer answers; it stops by itself.
fault-chair-silent-remedy = Check the chair's power and the network.
fault-chair-silent-patient = The chair was out of reach.

fault-chair-disarmed = The chair disarmed itself: too few commands reached it in time.
fault-chair-disarmed-remedy = Bring the chair nearer to the network.
fault-chair-disarmed-patient = The chair was out of reach.

fault-chair-not-ready = The chair did not become ready within 5 seconds.
fault-chair-not-ready-remedy = See on the Real chair page what the chair says.
fault-chair-not-ready-patient = The chair was not ready in time.

fault-shirt-rate = The shirt sends more or fewer frames a second than is set for it.
fault-shirt-rate-remedy = Set “{ shirtdev-rate }” on the Shirt page to its true rate, and calibrate again.
fault-shirt-rate-patient = The shirt has to be set anew.

fault-no-movement = The signals changed as no body moves: by jumps, as evenly as a machine, or in all joints alike.
fault-no-movement-remedy = See that the shirt's plugs are firm and its cable hangs free, let the patient rest.
fault-no-movement-patient = The signals did not come from your movement: let your arms hang.

fault-brake-bad = A sensor of the movement that brakes or stops gave impossible values.
fault-brake-bad-remedy = See the lamps on the Shirt page; repeat the calibration without the bad sensors.
fault-brake-bad-patient = Some sensors of the shirt need a look.

fault-picture-lost = A screen lost the picture that the patient drives by.
fault-picture-lost-remedy = Wait until the picture is back, or choose the drawn plan.
fault-picture-lost-patient = The picture was lost.

## Who acts next, for the patient, while the chair stands.

fault-waits-clinician = We wait for your clinician to look and to go on.
fault-waits-program = We wait for the program: it starts again by itself.
fault-waits-shirt = We wait for the shirt: your clinician looks after it.
fault-waits-begin = We wait for your clinician to begin.
fault-waits-moment = We wait for the program: it needs a moment.
fault-waits-movements = You drive: the chair waits for your movements.
fault-waits-rest = Let your arms hang: the chair waits until your body is at rest.
