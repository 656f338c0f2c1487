### Texts of the record of a session, of a patient's sessions and consents, and of two sessions side by side.

rail-session = Sessions
record-title = Session { $number } of { $code }
record-sessions = Sessions of { $code }
record-sessions-lead = Open a session for its record, or tick two to see them side by side.
record-sessions-none = There is no session yet. The first one begins when you start a session on the Patients page.
record-link = Sessions and consents
record-link-label = Sessions and consents of { $code }
record-back = All sessions
record-story = Story
record-story-label = Story of session { $number }
record-story-title = Story of session { $number } of { $code }
record-story-record = Record
origin-words = From { $clinic }; imported by { $person }, { $moment }
record-began = Began { $moment }
record-began-by = Began { $moment } by { $person }
record-version = Software { $version }
record-version-none = Software not recorded
record-state-open = Open now
record-state-ended = Not signed off
record-state-signed = Signed off
record-only-read = You may read this record and change nothing.
record-goal = Goal, in the patient's words
record-goal-none = No goal was written.
record-goal-hint = What the patient wants to reach in this session.
record-goal-save = Save the goal
record-goal-saved = The goal was saved.
record-notes = Notes
record-notes-none = No note was written.
record-note-new = New note
record-note-add = Add the note
record-note-revise = Revise
record-note-revise-label = Revise the note of { $person }, { $moment }
record-note-save = Save the revision
record-note-text = Text of the note
record-note-by = { $person }, { $moment }
record-note-revised = { $person }, revised { $moment }
record-note-history =
    { $count ->
        [one] { $count } earlier text
       *[other] { $count } earlier texts
    }
record-scales = Outcome scales
record-scales-none = No scale was entered.
record-scale-name = Scale
record-scale-name-hint = For example SCIM III or WST 5.0.
record-scale-total = Total
record-scale-total-hint = The total only; the items of most forms are licensed.
record-scale-total-missing = Enter the total as a number.
record-scale-day = Date
record-scale-add = Add the scale
record-scale-remove = Remove
record-scale-remove-label = Remove { $name }, { $day }
record-driven = What was driven
record-driven-none = Nothing was driven in this session.
record-driven-trial = { $plan }, trial { $number }
record-driven-counts = counts
record-driven-discarded = discarded: { $reason }
record-driven-drives =
    { $count ->
        [one] { $count } drive of a real chair
       *[other] { $count } drives of a real chair
    }
record-tests = Two-minute tests
record-driven-task = Trial
record-driven-kept = Counts
record-sets = Calibration and controls
record-set = Calibration { $version } with the set “{ $title }”
record-details = Details
record-set-hash = Fingerprint of the set: { $hash }
record-sign = Sign-off
record-sign-lead = A sign-off locks goal, notes, scales and trials of this session. Only an owner can unlock them.
record-sign-ends = This session is still open; it ends with the sign-off.
record-sign-go = Sign off
record-sign-sure = Sign off as { $person }?
record-sign-yes = Yes, sign off
record-signed = Signed off by { $person }, { $moment }.
record-signed-past = Signed off by { $person }, { $moment }; unlocked by { $owner }, { $unlocked }: { $reason }
record-signed-done = The session is signed off.
record-unlock = Unlock
record-unlock-reason = Why it is unlocked
record-unlock-reason-hint = The reason stays in the history and in the log.
record-unlock-yes = Unlock the session
record-compare = Compare the two
record-compare-pick = Compare session { $number }
record-compare-choose =
    { $count ->
        [one] Tick one more session.
       *[other] Tick two sessions.
    }
record-compare-title = Two sessions side by side
record-compare-lead = { $code }: session { $earlier } and session { $later }
record-compare-nothing = Nothing was driven in either session.
record-compare-trials = Trials of session { $number }: driven { $driven }, counting { $counted }, compared { $compared }.
record-compare-tests = Session { $number }: complete tests: { $complete }.
record-compare-tests-newest = The newest complete one of each stands here.
record-compare-none = No trial of this task can be compared: the first three are for getting used to it. Drive it again in another session.
record-compare-range = ({ $low } to { $high })
record-compare-spread = Each figure is the median; half of the trials lie within the range in brackets.
record-compare-task = { $plan }: { $path }
record-compare-changed = What changed in calibration and controls
record-compare-same = Calibration and controls are the same.
record-compare-unknown = The controls cannot be compared: in one of the two sessions nothing was driven, or another version of the program saved them.
record-compare-maps = Calibration { $earlier } in session { $first }, calibration { $later } in session { $second }.
consent-title = Consents
consent-lead = Each is off until the patient gives it, and can be withdrawn at any time.
consent-recording = Recording
consent-recording-hint = Signals and trials are recorded with a worn shirt or a camera, whose picture is neither recorded nor sent. Practice with the simulated shirt needs no consent.
consent-clinic-prior = Use for other patients of the clinic
consent-clinic-prior-hint = The patient's trials help to tell a change from noise. The patient's movements help new patients to drive sooner. Nobody can be recognised in them. When the consent is withdrawn, both are removed.
consent-sharing = Sharing outside
consent-sharing-hint = Records may leave the clinic as a report, a share link or an export.
consent-given = Given { $day }
consent-by = Given { $day }, entered by { $person }
consent-off = Not given
consent-day = Day of consent
consent-give = Enter consent
consent-give-label = Enter consent: { $consent }
consent-withdraw = Withdraw
consent-withdraw-label = Withdraw the consent: { $consent }
consent-history = History
consent-past = { $day } to { $withdrawn }, withdrawn by { $person }
consent-needed = { $code } has not consented to recording.
consent-needed-why = With a worn shirt nothing is recorded without it: ask the patient, and enter the consent.
consent-needed-go = Enter consent
