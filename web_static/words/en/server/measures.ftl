### Measures of trials and of the two-minute test: their names, and what they measure.

# A level, as in "1.23 m²": $unit stands in no catalogue, because units are written alike in every language.
measure-with-unit = { $figure } { $unit }
measure-degrees = { $figure }°
# A difference of two shares, as in "fell by about 12 percentage points". $count is that number, $figure how it is written.
measure-points =
    { $count ->
        [one] { $figure } percentage point
       *[other] { $figure } percentage points
    }
measure-number = { $figure }

## Measures of a trial. The message that ends in "-subject" is the measure within a sentence, as in "Within noise over 12
## trials: the area off the path was about 1.23 m²." The one that ends in "-definition" says for exports what is measured.

measure-stages-done = Stages done
measure-stages-done-subject = the number of stages done
measure-stages-done-definition = Number of stages done
measure-follow-error-rms = Usual error of the distance to the leader
measure-follow-error-rms-subject = the usual error of the distance to the leader
measure-follow-error-rms-definition = Root mean square error of the distance to the leader
measure-follow-error-max = Largest error of the distance to the leader
measure-follow-error-max-subject = the largest error of the distance to the leader
measure-follow-near = Share of time near the asked distance
measure-follow-near-subject = the share of time near the asked distance
measure-heading-error-deg = Angle off the asked heading
measure-heading-error-deg-subject = the angle off the asked heading
measure-heading-error-deg-definition = Error of the heading
measure-turn-drift = Moved off the spot
measure-turn-drift-subject = the way off the spot
measure-turn-drift-definition = Largest distance from the place of the turn
measure-cones-touched = Cones touched
measure-cones-touched-subject = the number of cones touched
measure-cones-touched-definition = Number of cones touched
measure-gap-clearance = Narrowest clearance in a gap
measure-gap-clearance-subject = the narrowest clearance in a gap
measure-gap-clearance-definition = Smallest clearance in gaps
measure-door-contacts = Contacts with door or gap
measure-door-contacts-subject = the number of contacts with a door or gap
measure-door-contacts-definition = Number of contacts at doors
measure-e-diff = Area off the path
measure-e-diff-subject = the area off the path
measure-e-diff-definition = Area between trajectory and path
measure-dist = Distance driven
measure-dist-subject = the distance driven
measure-time = Time
measure-time-subject = the time for a trial
measure-time-definition = Time to the goal
measure-dist-ratio = Distance over path length
measure-dist-ratio-subject = the distance driven over the length of the path
measure-dist-ratio-definition = Distance driven over the length of the path
measure-cross-track-rms = Usual distance from the path
measure-cross-track-rms-subject = the usual distance from the path
measure-cross-track-rms-definition = Root mean square distance to the path
measure-cross-track-max = Largest distance from the path
measure-cross-track-max-subject = the largest distance from the path
measure-mean-speed = Mean speed
measure-mean-speed-subject = the mean speed
measure-stops = Standstills
measure-stops-subject = the number of standstills
measure-stops-definition = Number of standstills
measure-collisions = Contacts
measure-collisions-subject = the number of contacts with walls and obstacles
measure-collisions-definition = Number of collisions
measure-contact-time = Time in contact
measure-contact-time-subject = the time in contact with walls and obstacles
measure-contact-time-definition = Time in contact with walls and obstacles
measure-turn-reversals = Changes of turning
measure-turn-reversals-subject = the number of changes between left and right turns
measure-turn-reversals-definition = Number of reversals of the turning command
measure-pulses-per-metre = Commands per metre
measure-pulses-per-metre-subject = the number of commands per metre
measure-pulses-per-metre-definition = Number of commands per metre
measure-sparc = Smoothness
measure-sparc-subject = the smoothness of the speed (higher is smoother)
measure-sparc-definition = Smoothness: spectral arc length
measure-ldlj = Smoothness, another measure
measure-ldlj-subject = another measure of the smoothness of the speed (higher is smoother)
measure-ldlj-definition = Smoothness: logarithmic dimensionless jerk

## What interrupted a trial.

measure-halts = Halts by the machine
measure-halts-definition = Number of halts by the machine; no other measure includes their time
measure-halt-time = Time halted by the machine
measure-pauses = Pauses for the screen
measure-pauses-definition = Number of pauses because of the screen
measure-pause-time = Time paused for the screen
measure-pause-time-definition = Time paused because of the screen
measure-person-stops = Stops by a person
measure-person-stops-definition = Number of stops by a person
measure-person-stop-time = Time stopped by a person

## What the measures of a trial are of.

measure-path-length = Length of the path
measure-cross-track-mean = Mean distance from the path, left positive
measure-stages = Stages
measure-cones = Cones
measure-gaps = Gaps

## Measures of the two-minute test, in which a dot is moved from target to target.

measure-acquisitions-per-minute = Targets per minute
measure-acquisitions-per-minute-definition = Two-minute test: targets per minute
measure-acquisitions-per-minute-meaning = How many targets were reached and kept for a second, for each minute of the test.
measure-throughput = Speed and precision together
measure-throughput-definition = Two-minute test: throughput (ISO 9241-411, effective width)
measure-throughput-meaning = How much information the movements carry: who is twice as fast at the same precision has twice as much. Higher is better; it is not given for fewer than eight targets.
measure-first-entry = Time to a target
measure-first-entry-definition = Two-minute test: time to the first entry into a target
measure-first-entry-meaning = From the appearance of a target until the dot is in it for the first time: the mean of the targets reached.
measure-dial-in = Time to settle in a target
measure-dial-in-definition = Two-minute test: time from the first entry to the last one
measure-dial-in-meaning = From the first entry into a target until the dot stays in it: 0 when the dot leaves no target again.
measure-path-efficiency = Straightness of the way
measure-path-efficiency-definition = Two-minute test: straight way divided by the way of the cursor
measure-path-efficiency-meaning = The straight way over the way that the dot took: 100 % is straight.

## Names beside the measures.

measure-reached = Goal reached
measure-workload = Workload, 0 to 100

## Errors in a table of a trajectory, and in recordings. The name of a file may stand before the sentence. $column is the
## name of a column, such as x.

measure-no-rows = the trajectory has no rows: record a trial first
measure-not-finite = { $column } has no finite number in row { $row }: correct it
measure-time-backwards = t goes backwards in row { $row }: put the rows in the order of time
measure-lengths = { $column } has { $rows } rows and t has { $times }: give them equal length
measure-no-number = '{ $name }' is no number
measure-quality-no-frames = the recording holds no frames of this shirt while motion was permitted: drive a trial first
measure-quality-gestures = the recording holds other gestures than its parameters: it cannot be judged, drive again
measure-forecast-channels = the recording has { $recorded } channels and the profile { $channels }: use the profile of the same shirt
