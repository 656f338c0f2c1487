### Texts of the page that a share link opens.

share-heading = Shared records
share-title = Records of { $code }
share-pin = PIN of this link
share-pin-words = The clinic told it to you separately.
share-open = Open
share-until = This link can be opened until { $day }. What it shows is confidential.
share-no-link = This address is not complete: open the whole link that the clinic sent.
share-failed = The clinic's machine does not answer: try again later.
share-session = Session { $number }
share-goal = Goal
share-signed = Signed off
share-unsigned = Not signed off
# What a trial was driven with.
share-source-simulated = simulated
share-source-camera = camera
share-source-phones = phones
share-source-slimevr = trackers
share-source-bluetooth = Bluetooth sensors
share-source-brainflow = board
share-source-lsl = LSL
share-task = { $plan }: { $path }
share-trajectories =
    { $count ->
        [one] Prescribed path (dashed) and { $count } trajectory
       *[other] Prescribed path (dashed) and { $count } trajectories
    }
share-curve = Area off the path (m²), trial by trial
share-values = { $first } in the first trial, { $newest } in the newest.
share-verdicts = Newest session against the one before
share-no-area = No trial reached the goal, so there is no area off the path: it can be compared only for the whole path.
share-no-verdict = Too few trials for a verdict.
share-event-begin = Session began
share-event-calibration =
    { $count ->
        [one] Calibration: { $count } recording
       *[other] Calibration: { $count } recordings
    }
share-event-map = Calibration, version { $version }
share-event-parameters = Controls saved: { $text }
share-event-trial = Trial { $number }, { $text }: { $end }
share-event-test = Two-minute test { $number }
share-event-stop = Stop
share-event-drive = Drive of the chair
share-event-note = Note
share-event-comment = Comment on trial { $number } at { $t } s
share-event-sign-off = Signed off
share-event-unlock = Unlocked
share-event-end = Session ended
