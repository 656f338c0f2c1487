### Texts of the real chair: choosing it, arming it, driving it, and the speed dial.

which-virtual = Virtual chair
which-feel = How it feels
which-feel-unicycle = Answers at once
which-feel-unicycle-hint = As in the published study.
which-feel-wheelchair = Like a real chair
which-feel-wheelchair-hint = It answers late, its castors must turn first, and its driven wheels slip a little.
which-real = Real chair
which-real-go = Drive “{ $name }”…
which-none = None is paired here yet.
which-none-go = Pair one
which-none-ask = None is paired here yet; an owner pairs one in Settings.
chair-title = Drive “{ $name }”
chair-lead = Go through the three cards, then arm. The patient sits in the chair, and somebody stands at its stop switch.
chair-lead-simulated = Go through the three cards, then arm. Somebody stands at the chair's stop switch.
chair-virtual = Use the virtual chair
chair-card = The chair
chair-state-disarmed = Disarmed
chair-state-checking = Waits for rest
chair-state-armed = Armed
chair-state-fault = Not ready
chair-state-silent = No answer
chair-battery = Battery
chair-battery-unknown = not reported
chair-switch = Stop switch
chair-switch-pressed = pressed
chair-switch-released = not pressed
chair-age = Last answer
chair-age-value = { $age } s ago
chair-now = just now
chair-never = never
chair-drives = Current speed
chair-measured = Measured
chair-commanded = Commanded
chair-drives-value = { $v } m/s, { $omega } °/s
chair-simulated = A demonstration: the simulated body can drive this chair, so nobody must sit in it.
chair-switch-why = Release the chair's stop switch: while it is pressed, nothing drives.
chair-joystick-why = Let go of the chair's own joystick: while it is moved, the chair obeys it and nothing else.
apply-card = Settings that will apply
apply-set = Set
apply-change = Change this set
apply-forward-back = Forward and back
apply-turning = Turning
apply-level-clinic = the clinic's limit
apply-level-chair = the chair's limit
apply-level-dial = with the speed dial at { $share }
apply-more = Accelerations, damping, fingerprint
apply-hash = Fingerprint
apply-hash-hint = Sets with the same fingerprint drive the chair in the same way.
apply-crawls = This chair has no chair document: it drives at most 0.3 m/s, whatever these settings say. Measure its joystick first.
apply-document = Chair document
apply-document-hint = The first digits of the fingerprint of the file that says how fast this chair's joystick drives it.
apply-cruise = Stops by itself after
apply-cruise-value = { $time } s without a movement
apply-turn-cruise = Stops turning by itself after
apply-turn-cruise-value = { $time } s without a movement
apply-practised = Practised
apply-practised-trials =
    { $count ->
        [one] { $count } trial on the virtual chair, { $when }
       *[other] { $count } trials on the virtual chair, last { $when }
    }
apply-differs = What is different from “{ $title }” ({ $hash }), which was practised last:
apply-unpractised = Nobody has driven the virtual chair of this clinic with this set yet.
apply-practise = Practise it now
differs-change = { $what }: { $before } → { $now }.
differs-title = The set's name: “{ $before }” → “{ $now }”.
differs-profile = The calibration is another one.
differs-order = The movements and numbers are the same, but saved in another order.
differs-gesture-added = { $gesture }: a new movement.
differs-gesture-removed = { $gesture }: no longer used.
differs-gesture-joint = { $gesture }: now made with another joint.
differs-gesture-direction = { $gesture }: now counts in the other direction.
differs-gesture-from = { $gesture } counts from: { $before } → { $now }.
differs-gesture-full = { $gesture } full at: { $before } → { $now }.
differs-gesture-moving = moving
differs-gesture-holding = holding
differs-how-u1-acceleration = keeps its speed
differs-how-u1-velocity = follows the movement
differs-how-u2-acceleration = keeps turning
differs-how-u2-velocity = follows the movement
differs-gain = { $gestures }, gain { $gain }
differs-nothing = nothing
neutral-card = At rest
neutral-lead = Before the chair moves, every movement must stay below its mark for half a second.
neutral-rest = The body is at rest.
neutral-moves = Moving: { $gestures }.
neutral-no-shirt = The shirt is silent, so nothing is known of the body: look at it on the Shirt page.
neutral-stop = Stop gesture: { $gestures }, together.
neutral-no-stop = No stop gesture is bound: the patient cannot stop the chair with the body. Bind one on the Controls page.
arm-go = Arm
arm-busy = Arming…
arm-ready = Nothing is missing. After Arm the patient drives.
arm-missing =
    { $count ->
        [one] One thing is missing:
       *[other] { $count } things are missing:
    }
arm-missing-short =
    { $count ->
        [one] One thing is missing, see above.
       *[other] { $count } things are missing, see above.
    }
arm-lost = This page has no connection to the program: wait until it is back.
arm-fault = A stop or fault is still in force: take the stop back in the strip above.
arm-front = Keep this page in front while the chair drives: when it is hidden or out of reach, the chair stops.
driving-title = Driving “{ $name }”
driving-checking = Rest…
driving-checking-why = Let the arms hang. The chair is ready when the body is at rest.
driving-armed = Driving
driving-armed-why = The patient drives. STOP, the space bar and the stop gesture stop the chair.
driving-disarmed = Disarmed
driving-disarmed-why = The chair stands.
driving-speed = Speed
driving-reverse = backwards
driving-turn-left = turning left, { $turn } °/s
driving-turn-right = turning right, { $turn } °/s
driving-straight = straight on
driving-stands = stands
driving-end = End drive
driving-ending = Ending…
driving-movements = Movements
driving-commands = Commands
driving-paused = The drive waits for Continue and a new moment of rest. Without Continue, the drive ends in { $left }
driven-title = The drive is over
driven-distance = Distance
driven-time = Time
driven-end = How it ended
driven-end-by-hand = Ended by hand
driven-end-fault = Ended by a stop or fault
driven-end-time-out = The time is over
driven-end-lost = The control process ended
driven-hash = Driven with the set of fingerprint { $hash }.
driven-again = Back to the chair
driven-gone = This drive is not in the list any more: go back to the chair.
dial-title = Speed dial
dial-label = Speed dial, share of the speeds
dial-up-to = up to { $speed } m/s
dial-hint = A lower value applies at once. A higher value applies when the chair stands and the body is at rest.
