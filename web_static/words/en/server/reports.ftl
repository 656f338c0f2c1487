### Texts of reports (PDF and HTML) of a session or of a patient's course of sessions, and refusals to make one.

# Refusals

report-no-session-yet = This patient has no session yet: open one first, then make the report.
report-no-session = This patient has no session { $session }: choose one that was opened.
report-no-language = --language { $language } is not offered: give one of { $languages }.
# $refusal is a sentence: the patient has not consented to sharing outside the clinic.
report-needs-consent = { $refusal } A copy for the patient needs no consent.

# Head of the document

report-of-course =
    { $count ->
        [one] Course of { $count } session
       *[other] Course of { $count } sessions
    }
report-of-session = Session { $session }
report-made = { $clinic }, report of { $moment }
report-source = Source:
report-no-source = No trial counted, so there is no source of signals.

# Headings and labels

report-goal = Goal
report-goals-between = Goals of the sessions between
report-trials = Trials
report-no-trial = No trial counted.
report-tests = Two-minute tests
report-drives = Drives of real chairs
report-condition = Condition
report-scales = Scales
report-no-scale = No scale was entered.
report-sessions = Sessions
report-notes = Notes
report-comments = Comments on trials
report-signature = Signature
# Below the line on which somebody signs on paper.
report-signature-line = Name, date, signature

# Facts: names and values

report-fact-reader = Made for
report-fact-reader-patient = Copy for the patient
report-fact-when = When
# $first and $last are days.
report-days = { $first } to { $last }
# $begun is a day with a time of day, $ended a time of the same day.
report-when-ended = { $begun } to { $ended }
report-when-open = { $begun }, still open
report-fact-opened = Opened by
report-fact-opened-unknown = not recorded
report-fact-trials = Trials
report-trials-counted =
    { $count ->
        [one] { $count } trial counted
       *[other] { $count } trials counted
    }
report-trials-left-out =
    { $count ->
        [one] { $count } trial counted, { $left } left out ({ $reasons })
       *[other] { $count } trials counted, { $left } left out ({ $reasons })
    }
# A reason for which a trial was left out.
report-trial-not-measured = could not be measured
report-fact-imported = Imported
# Sessions that were held in another clinic: from $first to $last, of that clinic, imported by a person on a day.
report-imported =
    { $count ->
        [one] Session { $first } from { $clinic }, by { $person }, { $day }
       *[other] Sessions { $first } to { $last } from { $clinic }, by { $person }, { $day }
    }
report-fact-software = Software
# $recorded are the versions of the program with which the sessions were recorded.
report-software = bodydrive { $version }; recorded with { $recorded }
report-software-unknown = bodydrive { $version }; at the time of the session: not recorded
report-fact-fingerprint = Fingerprint of the controls (SHA-256)
report-fingerprint-none = none: nothing was driven
report-fact-head = Head of the log
# The rows of the clinic's log, and the check sum of the newest one.
report-head =
    { $count ->
        [one] { $count } row, { $hash }
       *[other] { $count } rows, { $hash }
    }
report-head-unknown = not recorded

# What people wrote

report-no-goal = No goal was written down.
report-no-note = No notes.
report-note = { $written }, { $person }
report-note-revised = { $written }, { $person }, revised { $revised }
# $remark is the head of a note or of a comment: who wrote it, and when.
report-remark-of-session = Session { $session }, { $remark }
# $plan is the title of the floor plan, $time a moment of the trial.
report-comment = { $plan }, trial { $number }, at { $time } s: { $person }, { $written }
report-comment-revised = { $plan }, trial { $number }, at { $time } s: { $person }, { $written }, revised { $revised }
report-comments-left-out =
    { $count ->
        [one] { $count } comment on earlier trials is not shown.
       *[other] { $count } comments on earlier trials are not shown.
    }
report-signed = Signed off by { $person }, { $moment }.
report-signed-all = All sessions are signed off, the last by { $person }, { $moment }.

# Tables of sessions and of outcome scales

report-sessions-session = Session
report-sessions-date = Date
report-sessions-opened = Opened by
report-sessions-trials = Trials
report-sessions-discarded = Left out
report-sessions-signed = Signed off by
report-scales-scale = Scale
report-scales-total = Total
report-scales-totals = Totals, the oldest first
report-scales-day = Day

# Condition: the calibration, the controls and their settings

report-condition-none = Nothing was driven, so there is no condition to report.
report-condition-others =
    { $count ->
        [one] The newest set is shown; { $count } other set was driven with, too.
       *[other] The newest set is shown; { $count } other sets were driven with, too.
    }
report-fact-calibration = Calibration
# $origin is how this version of the calibration came about, $parent the version that it was made from (0: none),
# $methods how it was calibrated, $source what was worn, or saw the movements.
report-calibration =
    Version { $version }{ $origin ->
        [adaptation] , adapted
        [donning] , fitted to how the shirt sat
        [back] , an earlier one taken back
       *[calibration] { "" }
    }{ $parent ->
        [0] { "" }
       *[other] { " " }{ $origin ->
            [back] in place of
           *[other] from
        } version { $parent }
    }, { $methods }{ $source ->
        [camera] , with a camera
        [phones] , with phones
        [slimevr] , with trackers
        [bluetooth] , with Bluetooth sensors
        [brainflow] , with a board (BrainFlow)
        [lsl] , with signals over LSL
        [simulated] , of a simulated shirt
        [unknown] , source not recorded
       *[worn] { "" }
    }
report-method-pca = standard
report-method-guided = learnt from the cues
report-method-prior = learnt from other people
report-fact-modes = How it drives
report-modes =
    Forward and back: { $forward ->
        [acceleration] keeps its speed
        [velocity] follows the movement
       *[unknown] not recorded
    }. Turning: { $turning ->
        [acceleration] keeps turning
        [velocity] follows the movement
       *[unknown] not recorded
    }
report-fact-set = Set
report-fact-stops = Stops by itself after
report-stops = { $time } s
report-stops-turning = { $time } s, turning { $turning } s
report-fact-speeds = Speeds
report-speeds = Forward { $forward }, back { $reverse } m/s, turning { $turn } °/s
report-fact-damping = Tremor damping
report-damping = { $frequency } Hz
report-setting-unknown = not recorded
report-controls-control = Control
report-controls-movement = Movement
report-controls-from = Counts from
report-controls-full = Full at
report-controls-gain = Gain
report-control-faster = Faster
report-control-slower = Slower
report-control-left = Turn left
report-control-right = Turn right
report-control-stop = Stop
# A movement of a joint, for example "Right wrist, going back, held".
report-movement =
    { $joint }{ $direction ->
        [back] , going back
       *[forth] { "" }
    }{ $feature ->
        [displacement] , held
       *[rate] { "" }
    }
report-share = { $share } %
# A share of the person's full movement in each second.
report-share-rate = { $share } % / s

# Drives of real chairs

report-drives-drive = Drive
report-drives-chair = Chair
report-drives-begun = Begun
report-drives-lasted = Lasted
report-drives-distance = Distance driven
report-drives-end = End
report-drives-session = Session
report-drives-count = Drives
report-drives-chairs = Chairs
report-drives-faults = Ended by a stop or fault
report-drive-ended = ended by hand
report-drive-fault = ended by a stop or fault
report-drive-goes-on = goes on
report-drive-end-unknown = not recorded
report-drive-minutes = { $minutes } min { $seconds } s
report-drive-seconds = { $seconds } s
report-drive-distance = { $distance } m
report-drive-distance-unknown = not reported by the chair

# A task: its measures, trajectories and learning curve

report-measures-measure = Measure
report-measures-now = Now
report-measures-band = Noise
report-measures-verdict = Verdict
report-nothing-before = nothing to compare with
report-task-trials =
    { $count ->
        [one] { $count } trial counted; the goal was reached in { $reached }.
       *[other] { $count } trials counted; the goal was reached in { $reached }.
    }
# Of these trials, $used were for getting used to the task.
report-task-trials-used =
    { $count ->
        [one] { $count } trial counted, { $used } of them to get used to the task; the goal was reached in { $reached }.
       *[other] { $count } trials counted, { $used } of them to get used to the task; the goal was reached in { $reached }.
    }
# $trials are trials with what interrupted them.
report-interrupted = Interrupted: { $trials }.
report-interrupted-more = Interrupted: { $trials } and { $more } more.
report-interrupted-trial = trial { $number } ({ $interruption })
report-compared =
    Session { $later } ({ $second ->
        [one] { $second } trial
       *[other] { $second } trials
    }) against session { $earlier } ({ $first ->
        [one] { $first } trial
       *[other] { $first } trials
    }).
report-compared-none = There is no earlier session with trials of this task to compare with.
# For those who do not see the drawing. $before, $now are levels of the measure with their unit, $noise a range.
report-band = { $measure }: { $before }, now { $now }; within noise from { $noise }.
# A range of a measure; a unit may follow.
report-range = { $low } to { $high }
# plan: title of a floor plan or scene; path: title of one of its paths.
report-task-title = { $plan }: { $path }
report-trajectories-title = Trajectories over the path
# $others are the trajectories that those of session $newest are compared with; $chosen is 0 when all are drawn.
report-trajectories =
    { $count ->
        [one] { $count } trajectory
       *[other] { $count } trajectories
    } of session { $newest } (orange){ $others ->
        [none] { "" }
        [sessions] { " " }over { $before } of earlier sessions (grey)
       *[session] { " " }over { $before } of session { $earlier } (grey)
    }{ $chosen ->
        [0] { "" }
       *[other] , chosen evenly of { $chosen } trials
    }{ $lost ->
        [0] { "" }
        [one] ; { $lost } recording cannot be read
       *[other] ; { $lost } recordings cannot be read
    }.
report-curve-title = Learning curve: { $measure } in every trial
report-curve-words =
    { $count ->
        [one] { $count } trial; session { $session } is orange. Rings: to get used to the task. S: a session begins.
       *[other] { $count } trials; session { $session } is orange. Rings: to get used to the task. S: a session begins.
    }
# For those who do not see the drawing.
report-curve-of =
    { $count ->
        [one] { $measure } over { $count } trial.
       *[other] { $measure } over { $count } trials.
    }
# Below the axis of a learning curve, between two numbers of trials.
report-curve-axis = trial
report-scale-bar = { $length } m

# Two-minute tests

report-tests-test = Test
report-tests-complete =
    { $count ->
        [one] { $count } complete test.
       *[other] { $count } complete tests.
    }
report-tests-complete-until =
    { $count ->
        [one] { $count } complete test up to session { $session }.
       *[other] { $count } complete tests up to session { $session }.
    }
report-tests-left-out =
    { $count ->
        [one] { $count } test is not shown.
       *[other] { $count } tests are not shown.
    }
report-test-of-session = { $number }, session { $session }
# Two tests by their numbers.
report-test-against = { $later } against { $earlier }
report-test-ended = ended early: does not count
report-test-stopped = stopped: does not count
report-test-interrupted = interrupted: does not count
report-test-unreadable = its recording cannot be read

# Foot of the document

report-explanation = Noise is how much this person’s own trials of the task differ without a change; where nothing changed, about one page in twenty says otherwise by chance. A trial that missed the goal counts as no better than the worst tenth of those before it that reached it. The first three trials of a task are for getting used to it and are not compared. No minimal detectable change has been published for these measures of wheelchair driving.
# $characters are numbers of characters with their English names.
report-missing-characters = No font here has these characters, so their numbers stand in their place: { $characters }.
report-missing-characters-more = No font here has these characters, so their numbers stand in their place: { $characters } and { $more } more.
report-character-nameless = without a name
