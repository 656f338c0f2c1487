### Texts of the shirt page: source, body, sensors.

shirt-title = The shirt
shirt-words-count = { $good } of { $all } sensors are good.
shirt-lost =
    { $count ->
        [one] { $count } frame was lost.
       *[other] { $count } frames were lost.
    }
shirt-none = There is no shirt yet: choose where the movements come from.
# Stands beside the sensors; the lamps are those of the joint that moves.
shirt-wiggle = Move one joint: its lamps light up.
shirt-moves = Moves now: { $joint }.
source-none = No shirt yet: choose one.
source-worn = Somebody’s own movements
source-practice = Practice only (simulated)
shirt-calibrate = Calibrate
shirt-drive = Go on to drive
shirt-front = Front
shirt-back = Back
shirt-sensors = Sensors
shirt-sensors-hint = Tap a lamp to see its signal.
shirt-sensors-label = Sensors on the body. Arrow keys go from one to the next.
shirt-right = right
shirt-left = left
shirt-legend = What the lamps mean
sensor-joint = at the { $joint }
sensor-unused = Do not use this sensor
sensor-unused-hint = The next calibration leaves it out.
sensor-noise = noise { $noise }
sensor-now = now { $value }
sensor-trace = Signal of { $name }, the last 10 seconds
quality-good = Good
quality-near = Near its limit
quality-railed = At its limit
quality-flat = Flat
quality-noisy = Noisy
quality-nan = Impossible values
quality-estimated = Estimated
quality-unused = Not used
quality-silent = Silent
quality-good-words = It follows the body.
quality-near-words = It comes close to the end of its range: see whether the shirt sits too tight there.
quality-railed-words = It stays at the end of its range: loosen the shirt there, or leave this sensor out.
quality-flat-words = It does not change at all: check its connector, or leave it out.
quality-noisy-words = It jitters more than its neighbours: check its connector.
quality-nan-words = It gives impossible values: check its cable, or leave it out.
quality-estimated-words = It is broken. Its value is estimated from its neighbours, so that movements still work: check its cable.
quality-unused-words = You left it out. The next calibration will not use it.
quality-silent-words = Nothing comes from it: check that the shirt is on and connected.
traces-title = Live signals by joint
traces-label =
    { $count ->
        [one] { $joint }, { $count } sensor
       *[other] { $joint }, { $count } sensors
    }
head-title = Head tracker
head-none = None
head-none-hint = The view looks straight ahead.
head-none-now = None: the view looks straight ahead.
head-opentrack = opentrack
head-opentrack-hint = Its output “UDP over network”, sent to this machine.
head-opentrack-now = opentrack on port { $port }.
head-freepie = FreePIE
head-freepie-hint = Or a phone that sends like it, by UDP.
head-freepie-now = FreePIE on port { $port }.
head-flock-of-birds = Flock of Birds
head-flock-of-birds-hint = Ascension’s magnetic tracker on a serial line.
head-flock-of-birds-now = Flock of Birds on { $device }.
head-tablet = A tablet’s own sensor
head-tablet-hint = Held or fixed in front of the eyes; its page must be open.
head-tablet-now = A tablet’s own sensor.
head-tablet-start = Use this tablet
head-tablet-waiting = Waiting for the sensor…
head-tablet-tells = This tablet reports its direction now.
head-tablet-none = This machine has no such sensor: open this page on a tablet or phone.
head-tablet-denied = The browser does not permit the sensor: permit motion for this page in its settings.
head-tablet-insecure = Browsers give the sensor only to pages over https: open this page that way, or on this machine itself.
head-recorded = A recorded head
head-recorded-hint = A file with t, yaw_deg, pitch_deg and roll_deg.
head-recorded-now = Recorded head { $file }.
head-simulator = Simulated head
head-simulator-hint = It looks around by itself.
head-simulator-now = Simulated head.
head-device = Serial line
head-baud = Baud
head-address = Address
head-address-hint = Only a group of units needs the address. Leave it empty for a single unit.
head-ahead = Set as straight ahead
head-ahead-done = The direction of the head is now straight ahead.
source-title = Where do the movements come from?
# $what begins with a small letter where the language permits it: “a USB cable”.
source-needs = Needs { $what }.
source-costs = Costs { $what }.
source-takes = Takes { $what }.
# Above the reason that is found, and what to do about it.
source-nothing = Nothing arrives?
source-heed = Something is not right
source-change = Change
source-use = Use this
source-unit = { $value } { $unit }
source-file = File
source-no-file = No file of this kind is here yet: add one below.
source-host = Listen on
source-port = Port
source-layout-wrong = { $file }: this is not a JSON document; choose a shirt layout.
source-layout-saved = Saved layout
source-layout-kept = As it is now
source-key-none = None
# No sensor.
source-sensor-none = None
sender-now = Its frames come from { $shirt }.
sender-other = Another sender, { $other }, also sends frames. They are not used, because the shirt is the sender at { $shirt }. Use the new sender only when the patient’s shirt was changed or started again.
sender-use = Use the new sender
sender-used = The shirt is now the sender at { $sender }.
source-add = Add a file
source-add-hint = CSV or Parquet, at most 64 MB.
source-import = Import a recording
source-import-hint = Of another program: the page says what the file holds before it is used.
source-added = { $file } was added.
source-adding = Adding { $file }…
source-file-option = { $name } ({ $size })
body-title = Simulated body
body-person-practised = Simulated person, practised
body-person-practised-hint = Drives alone, and well.
body-person-novice = Simulated person, inexperienced
body-person-novice-hint = Drives alone, and makes a beginner's mistakes.
body-visitor = You
body-visitor-hint = Keys, the pads on the screen, or a gamepad move the elbows and shoulders inside the shirt.
body-recorded = A recorded body
body-recorded-hint = Joint rotations of a real person, from a file.
body-recorded-now = Recorded body: { $file }
body-yours = You move this body
pads-right-elbow = Right elbow
pads-left-elbow = Left elbow
pads-right-shoulder = Right shoulder
pads-left-shoulder = Left shoulder
pads-bend = bend
pads-forward = forward
pads-keys-right-elbow = W  ↑
pads-keys-left-elbow = S  ↓
pads-keys-right-shoulder = A  ←
pads-keys-left-shoulder = D  →
pads-note = Hold to move, let go to come back. Both elbows together are the stop gesture.
pads-gamepad = Gamepad: triggers bend the elbows, sticks push the shoulders forward.
pads-group = Pads that move the body inside the shirt
