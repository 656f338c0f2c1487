### Texts of the drive page: choosing a path, driving, a trial that is over.

drive-none-title = Nothing to drive with yet
drive-none-lead = First the calibration: it learns which movements this body can make.
drive-none-go = Calibrate
drive-no-path = This floor plan has no path “{ $path }” any more: choose another task.
drive-title = Where to?
drive-why-first = A first task: the corridors of the published study. The chair is put on the start.
drive-why-again = The task that was driven last. The chair is put on the start.
drive-why-next-level = The last three trials reached the goal without contact, and none was worse than noise: this is one level harder.
drive-why-chosen = The task that you chose. The chair is put on the start.
drive-choose = Choose another
drive-choose-title = Choose a task
drive-choose-lead = Choose a kind of task, then how difficult it is to be, then the task.
drive-choose-groups = Kinds of tasks
drive-group-first = First steps
drive-group-corridors = Corridors
drive-group-doors = Doors
drive-group-obstacles = Obstacles
drive-group-following = Following
drive-group-outdoors = Outdoors
drive-group-own = Own plans
drive-own-none = This clinic has no floor plan of its own yet.
drive-own-go = Draw or import a floor plan
drive-places = What else belongs to driving
drive-place-chair = Chair
drive-place-chair-unicycle = Virtual, answers at once
drive-place-chair-wheelchair = Virtual, like a real chair
drive-place-chair-lead = Practise with the virtual chair, or drive a real one.
drive-place-screen = The patient's screen
drive-place-screen-lead = A second screen for the patient: the view, large cues and the speed. Nothing on it can be changed.
drive-place-plans = Floor plans
drive-place-plans-state = Draw or import one
drive-screens =
    { $count ->
        [one] { $count } paired
       *[other] { $count } paired
    }
drive-screens-bad =
    { $count ->
        [one] { $count } paired, without a picture
       *[other] { $count } paired, not all with a picture
    }
drive-screens-away =
    { $count ->
        [one] { $count } paired, not connected
       *[other] { $count } paired, not all connected
    }
drive-screens-none = None is paired
drive-done = Back to the task
drive-level = How difficult “{ $plan }” is
drive-no-shirt = A trial needs a shirt: none is chosen yet.
drive-no-shirt-go = Choose a shirt
drive-obstacle-shirt = To the shirt
drive-obstacle-calibrate = Calibrate
drive-obstacle-controls = To the controls
drive-start = Start trial
drive-start-plan = Start in the drawn plan
drive-length = { $length } m
drive-size = { $width } × { $height } m
drive-body-person-practised = A practised simulated person drives.
drive-body-person-novice = An inexperienced simulated person drives.
drive-body-visitor = You drive with the pads or keys.
drive-body-recorded = The recorded movements of a person drive the chair. They do not follow the path.
drive-body-patient = The patient drives.
drive-body-change = Change
drive-camera = Move it yourself with this camera
drive-camera-hint = It records your movements, no picture, and deletes them at the end.
drive-plan-label = Plan of { $plan } with the path “{ $path }”
task-path = Follow the line
task-follow = Follow
task-turn = Turn
task-back = Backwards
task-course = Course
trial-stage = { $stage } of { $stages } · { $title }
trial-turned = { $left }° to go
trial-turned-over = { $left }° too far
trial-spot = { $distance } m off the spot
trial-behind-near = { $distance } m behind: too near
trial-behind-right = { $distance } m behind: just right
trial-behind-far = { $distance } m behind: too far
trial-name = Trial { $number } · { $plan }
trial-done = { $done } of { $length } m
trial-off = { $distance } m off the path
trial-contacts =
    { $count ->
        [one] { $count } contact
       *[other] { $count } contacts
    }
trial-above = From above
trial-above-line = Blue line: it is white on the floor
trial-speed = Speed
trial-views = View
trial-view-eye = Eye
trial-view-chase = Chase
trial-view-top = Top
trial-view-free = Free
trial-view-plan = Plan
trial-view-surface = The picture: drag to turn, pinch or wheel to come nearer, two fingers or Shift to move
trial-view-free-group = Free view
trial-view-free-left = Turn left
trial-view-free-right = Turn right
trial-view-free-up = Higher
trial-view-free-down = Lower
trial-view-free-nearer = Nearer
trial-view-free-farther = Farther
trial-view-settings = The eye’s settings
trial-view-fov-deg = Field of view
trial-view-eye-height = Eye height
trial-view-roll-share = Tilt of the head
trial-view-roll-share-why = How much of the tilt the picture shows. No tilt is the most comfortable.
trial-view-reduced = This screen asks for reduced motion: the picture does not tilt.
trial-view-head = Head tracker
trial-view-head-why = Look where the head looks.
trial-view-head-on = Follow
trial-view-pace = { $rate } pictures a second, { $age } ms old
trial-view-pace-slow = { $rate } pictures a second, { $age } ms old. The picture is slow on this screen: close other pages, or use a smaller window.
trial-plots = Plots
trial-end = End trial
trial-ending = Measuring…
trial-ending-why = The trial is over. Its result comes here by itself; a long trial takes longer.
trial-moment = One moment…
trial-moment-why = The picture is being prepared.
trial-rest = Rest…
trial-rest-why = Let the arms hang. The chair is ready when the body is at rest.
trial-go = Go
trial-frame = 3D view of the chair in the building
trial-pause = Paused
trial-pause-why = The chair stands, and the clock is paused. Both go on by themselves when the screen has been fast enough for a second.
trial-pause-screen-lost = The screen that started the trial is out of reach, or too slow.
trial-pause-screen-hidden = The page that started the trial is hidden, or was left.
trial-pause-screen-slow = The screen that started the trial draws too slowly.
trial-pause-left = Otherwise the trial ends in { $left }
trial-pause-often = This screen is too slow for the 3D view. The drawn plan needs less.
trial-paused = The trial waits for Continue. Without it, the trial ends in { $left }
over-goal = Goal reached
over-time-out = The time is over
over-by-hand = Ended by hand
over-fault = Ended by a stop or fault
over-null = Trial
over-lead = Trial { $number } · { $plan } · { $path } · { $when }
over-driven = Trajectory over the path
over-no-trajectory = The recording of this trial is missing, so there is no trajectory. Its measures stay.
over-no-measures = This trial was too short to be measured. Drive a little further next time.
over-not-reached = The goal was not reached, so this trial cannot be compared with others.
over-way = The chair reached { $done } m of the { $length } m of the path.
over-not-done = The task was not completed, so its time cannot be compared with other trials.
over-stages = Stage by stage
over-stage-done = done
over-stage-open = not done
over-table = Compared with the trials before
over-measures = All measures of this trial
over-measure = Measure
over-this = This trial
over-previous = Trial { $number }
over-best = Best so far
over-path-length = path { $length } m
over-discard = Discard…
over-discard-title = Why does this trial not count?
over-discard-interrupted = It was interrupted
over-discard-sensor = A sensor gave trouble
over-discard-practice = It was only practice
over-discard-other = Another reason
over-discard-go = Discard this trial
over-discarded = Does not count: { $reason }
over-discarded-toast = Trial { $number } does not count any more.
over-keep = Let it count again
over-count = Count it
over-counted-toast = Trial { $number } counts.
over-next = Next trial
over-harder = One level harder
over-other = Another task
