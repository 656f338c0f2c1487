### Texts of the quality of control: the card of one trial, its course over trials, the warnings.

quality-title = Quality of control
quality-details = Details: quality of control
quality-none = The recording of this trial does not show how well the calibration fitted.
quality-lead = How well the calibration fitted what was moved in this trial.
quality-joint = Joint
quality-map-angle-deg = Angle to the calibration
quality-evr = Clear main movement
quality-null-space-share = Movement without effect
quality-cross-talk = Moves along with it
quality-activations = Movements that counted
quality-activations-per-metre = Movements per metre
quality-span-share = Range used
quality-rest-rate = Trembling at rest
quality-means-map-angle-deg = between the main direction of this trial and that of the calibration
quality-means-evr = share of the movement that lies in one direction
quality-means-null-space-share = share of the movement that never reaches the control
quality-means-cross-talk = share of the effect that belongs to other movements than the strongest
quality-means-activations-per-metre = movements that counted, for each metre driven
quality-means-span-share = of the range that was calibrated
quality-means-rest-rate = share of the full movement per second, where the joint was stillest
quality-worst = For several joints together, each figure is that of the joint that fits worst.
quality-guided = { $joints }: the standard calibration is not in use here. These figures are still those of the standard calibration. They show how the joint moves, not how it controls the chair.
quality-bad = Sensors that were unreliable part of the time: { $sensors }.
quality-bad-one = { $name } ({ $share } of the time)
quality-still = A joint without figures moved for less than 2 s.
quality-over = Quality of control over trials
quality-choose = Figure
quality-choose-joint = Joint
quality-all-joints = All joints: the one that fits worst
quality-trial = trial
quality-empty = No trial here shows how well the calibration fitted.
quality-session = session { $number }
quality-map = calibration { $number }
quality-warnings =
    { $count ->
        [one] One thing to look at
       *[other] { $count } things to look at
    }
quality-do = What to do:
quality-kind-sensor = sensor: { $joints }
quality-kind-map = calibration: { $joints }
quality-kind-noise = trembling or noise: { $joints }
quality-kind-span = smaller movement: { $joints }
quality-go-sensor = To the shirt
quality-go-map = To the calibration
quality-go-noise = To the controls
quality-go-span = To the calibration
