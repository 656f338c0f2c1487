### Texts of the two-minute test before driving.

rail-interface-test = Two-minute test
test-lead = Targets appear on a cross, and the patient moves a dot into each of them with the movements of the controls. No chair moves meanwhile. It shows how well the movements work today, before anybody drives.
test-cross = Cross with a target and a dot: up is faster, down is slower, left and right are turning
test-before = The dot stands in the middle. The patient rests, and the test begins three seconds after Start.
test-wait = The test begins.
test-phase-ready = Rest. The first target comes in a moment.
test-phase-running = Bring the dot into the target, and keep it there for a second.
test-phase-over = Finished. The result is being worked out.
test-count =
    { $count ->
        [one] { $count } target reached
       *[other] { $count } targets reached
    }
test-start = Start the test
test-end-it = End the test
test-drive = To driving
test-result = Test { $number }
test-session = Session { $number }
test-number = Test
test-reached = { $acquired } targets reached, { $missed } missed within { $seconds } s.
test-so-far =
    { $count ->
        [one] { $count } target was reached before the test ended, after { $seconds } s.
       *[other] { $count } targets were reached before the test ended, after { $seconds } s.
    }
test-end-by-hand = This test was ended early, so it does not count.
test-end-stopped = This test was stopped, so it does not count.
test-end-fault = This test was interrupted, because the shirt or the program fell silent. It does not count.
test-end-complete = The recording of this test cannot be read, so it has no figures.
test-details = More figures, and what they mean
test-ways = Ways to the targets by direction
test-ways-way = Way
test-ways-acquired = Reached
test-ways-missed = Missed
test-ways-time = Time
test-way-ahead = Up (faster)
test-way-back = Down (slower)
test-way-left = Left
test-way-right = Right
test-publications = In publications: acquisition rate, throughput after ISO 9241-411 with the effective width, first-entry time, dial-in time, path efficiency.
test-curve = Over the tests
test-one = From the second test on, a curve and a comparison stand here.
test-against = Newest against test { $number }
test-noise = Noise is how much this person's own tests differ without a change. A verdict needs five complete tests. Tests of different sources, such as a simulated and a worn shirt, are never compared.
test-workload = How demanding was it?
test-workload-lead = Six questions for the patient, from 0 to 100. Each may be left out.
test-workload-mental = Thinking: how much thought did it need?
test-workload-physical = Body: how strenuous was it?
test-workload-temporal = Time: how hurried did it feel?
test-workload-performance = Success: how well did it go?
test-workload-effort = Effort: how hard did you have to work?
test-workload-frustration = Mood: how annoyed or discouraged were you?
test-workload-low-other = Very low
test-workload-high-other = Very high
test-workload-low-performance = Perfectly
test-workload-high-performance = Not at all
test-workload-none = No answer
test-workload-leave-out = Leave out
test-workload-clear = Leave out: { $question }
test-workload-save = Save the answers
test-workload-saved = Saved.
test-workload-sum = Workload (mean of the six): { $value } of 100.
test-workload-of = test { $number }: { $value }
patient-test-ready = Rest. A target comes in a moment.
patient-test-running = Bring the dot into the target.
patient-test-over = Finished. Rest a little.
drive-place-test = Two-minute test
drive-place-test-state = How well the movements work today
