### Texts of the command line, `bodydrive COMMAND ...`: what it prints, and what it says of bad input.
### Words that begin with --, and words in capitals behind them, are typed on the command line: they are not translated.

## Every command

# A name of the reader's own, such as a file or a joint, and a sentence on it.
cli-named = { $name }: { $text }
cli-file-failed = { $file } cannot be read or written ({ $reason }): see to it and try again
cli-output-failed = the output cannot be read or written ({ $reason }): see to it and try again
# $problem is a sentence of the library that reads the command line, $command is such as: bodydrive score
cli-see-help = { $problem }: see { $command } --help
cli-out-was-read = --out { $file } is a file that was read for this: choose another place
cli-out-unwritable = --out { $file } cannot be written ({ $reason }): choose another place
cli-out-no-folder = --out { $folder }: { $file } is a file and not a folder, choose another place
cli-out-forbidden = --out { $folder }: nothing may be written in { $parent }, choose another place
cli-out-no-file = --out { $file } is no ordinary file: choose another place
cli-file-written = { $file } is written.
cli-source = Source: { $source }
cli-no-clinic = There is no clinic in { $folder }: give its folder with --state.
cli-no-set-up = The clinic in { $folder } is not set up yet: open its pages first.
cli-folder-unwritable = { $folder } cannot be written: choose another folder with --state.
cli-folder-in-use = The clinic in { $folder } is open already: end the other program, or choose another with --state.
cli-other-version = The program that runs is another version than this command: give the command of that version, or end that program first.
cli-others-can-read =
    { $count ->
        [one] Other people on this computer can read { $count } file of the clinic, { $file }: give it to this account, or move the clinic to a disk that keeps rights.
       *[other] Other people on this computer can read { $count } files of the clinic, the first is { $file }: give them to this account, or move the clinic to a disk that keeps rights.
    }
# The name of a clinic that a command makes.
cli-clinic-name = Clinic
cli-no-such-patient = There is no patient with the code '{ $code }': see the list of patients.
cli-yes = yes
cli-no = no
# Of a measured value, in a table.
cli-unknown = not known

## about

cli-about-compiled = bodydrive { $version }, built with its calculations compiled (the numbers are the same either way, bit for bit)
cli-about-plain = bodydrive { $version }, built as plain Python (the numbers are the same either way, bit for bit)
cli-about-held = Its own files hold the work of others; the texts of the licences are in THIRD_PARTY_NOTICES.txt:
cli-about-no-licence = no licence stated
# Of a package, in the place of its version.
cli-about-missing = not installed
cli-about-not-installed = bodydrive is not installed for this Python, so its packages are unknown: install its wheel.

## chair and shirt: pairing. The key is shown as a QR code above these sentences.

# The chair whose options were wrong.
cli-the-chair = the chair
cli-chair-paired = { $name } at { $host }:{ $port } is paired. Its key lies in { $file } and in the code above.
# A command follows.
cli-chair-next = On the chair, write what the code says into a file { $file } that only its owner can read, and start there:
cli-shirt-paired = The shirt is paired. Its key lies in { $path } and in the code above; choose { $file } on the Shirt page.
# A command follows.
cli-shirt-next =
    The shirt's firmware needs what the code says. To try it, write that into a file { $file } that only its owner
    can read, on any machine, and start there:

## chair: the rehearsal without one, and its record

cli-rehearsal-title = Rehearsal without a chair
cli-rehearsal-about = { $who }, { $date }; bodydrive { $version }, output { $output }, key { $key }.
cli-rehearsal-no-chair = The chair was emulated. What a real chair does when its cable is pulled or the receiver ends is not shown by this: try it with raised wheels.
cli-rehearsal-signed = { $file } is signed. SHA-256: { $digest }. HMAC: { $tag }.
cli-rehearsal-end = { $kept } of { $steps } steps were kept. The record is { $file }.
cli-rehearsal-no-output = --output { $output } cannot be emulated: give one of { $outputs }
cli-rehearsal-no-who = the record needs --who, a name in one line of at most { $most } letters: give it
cli-rehearsal-no-json = --out { $file } does not end in .json: give such a name
cli-rehearsal-no-receiver = the receiver does not start ({ $reason }): correct what it names
cli-rehearsal-false = { $file } is not a record that was signed with this key, or was changed since: give the right file and key
cli-rehearsal-genuine = { $file } is as it was signed with this key.
cli-rehearsal-step =
    { $step ->
        [paired] The receiver starts with the chair's key.
        [armed] The chair is armed.
        [driven] It is driven forwards.
        [stopped] Stop is pressed.
        [switch] While it drives, the chair's switch is pressed.
        [silence] While it drives, commands end, as when the network's cable is pulled.
        [hand] While it drives, somebody moves the chair's own joystick.
        [cable] While it drives, the chair's cable is pulled.
        [plugged] The cable is plugged in again.
       *[killed] While it drives, the receiver's process is killed.
    }
cli-rehearsal-must =
    { $step ->
        [paired] It must answer.
        [armed] It must accept that.
        [driven] Its wheels must turn.
        [stopped] Its wheels must stand.
        [switch] Its wheels must stand.
        [silence] Its wheels must stand.
        [hand] Its wheels must stand.
        [cable] The receiver must report the fault and command no more speed.
        [plugged] The wheels must stand, and the chair be disarmed.
       *[killed] The clinic must see that it is silent.
    }
cli-rehearsal-result =
    { $how ->
        [kept] KEPT: { $took } of { $limit } ms.
        [late] NOT KEPT: { $took } ms in place of { $limit }.
       *[never] NOT KEPT: it did not happen ({ $limit } ms).
    }

## decode

cli-decode-suffix = --out { $file }: its name must end in .parquet or .csv
cli-decode-done = { $frames } frames, { $seconds } s, decoded into { $out }
cli-profile-unreadable = --profile { $file } cannot be read ({ $reason }): give the file that calibrate wrote
cli-profile-no-json = --profile { $file } is not a JSON document: give the file that calibrate wrote
cli-range-dead-zone = --dead-zone { $value }: give full movements per second from { $least } to { $most }
cli-range-cutoff = --cutoff { $value }: give Hz from { $least } to { $most }
# The options that were wrong together.
cli-dead-zone-or-cutoff = --dead-zone or --cutoff

## floorplan

cli-plan-suffix = --out { $file }: its name must end in .json
# The options of the command, which were wrong.
cli-the-options = the options
cli-plan-no-room = { $file }: a chair fits nowhere in it, draw a path on a layer PATH, or check the unit
cli-plan-made = { $title }: { $walls } wall pieces, a path of { $length } m, written to { $out }
# $plans are names, with commas between them
cli-plan-fine = { $file }: fine ({ $plans })

## log

cli-log-unreadable = The log in { $file } cannot be read ({ $reason }): give another --state.

## people

# Whether somebody can sign in: a person's state in a list.
cli-person-state-active = active
cli-person-state-invited = invited
cli-person-state-disabled = disabled
# Behind a reviewer, in a list: the codes of the patients whom the reviewer may see.
cli-person-patients = patients: { $codes }
cli-person-no-patients = patients: none
cli-no-role = --role { $role } is no role: give owner, clinician or reviewer.
cli-name-unusable = This name cannot be used: give 1 to 80 visible characters.
cli-no-patient-option = --patient { $code }: there is no patient of this code, see the Patients page.
cli-person-is-disabled = { $name } is disabled: pages that { $name } has open end within 5 seconds.
cli-person-is-enabled = { $name } can sign in again, with the password of before.
# The link follows. $time is a day with a time of day.
cli-invitation = { $name } chooses a password with this link, once, until { $time }:
cli-not-running = The program does not run now: start it with `bodydrive serve`, then open the link at its address.

## demo and serve: addresses, ports, certificates

cli-no-address = '{ $host }' is no address of this machine: leave --host out, or give one of its own.
cli-port-busy = Port { $port } of { $host } is busy: end the program that uses it, or choose another port with --port (with make: PORT={ $next }).
cli-port-of-system = Port { $port } is for the system: choose one above 1023 with --port.
cli-proxy-no-address = --behind-proxy '{ $text }' is no address: write one such as 127.0.0.1, or 10.1.2.0/24.
cli-proxy-too-large = --behind-proxy { $text } has too many addresses to be believed: give that of the proxy.
cli-no-public-name = --name '{ $text }' is no name: write one such as clinic.example.org.
cli-not-encrypted = Other machines reach { $host }, and without https everybody on the way could read and change what they send: use 'bodydrive serve --lan', or leave --host out.
cli-proxy-needs-name = --behind-proxy and --name belong together: give the proxy's address, and its name.
cli-proxy-or-lan = A proxy is the only way in: use either --lan or --behind-proxy.
cli-one-host = Without --lan there is one address only: name --host once, or leave it out.
cli-certificate-needs-lan = A certificate is for other machines: use --certificate and --key together with --lan.
cli-certificate-needs-key = A certificate needs its key: name both, with --certificate FILE --key FILE.
# A QR code and an address follow.
cli-scan = On a tablet, scan this code, or open the address below it:
# A QR code and an address follow.
cli-scan-again = This machine's address has changed. On a tablet, scan this code, or open the address below it:
cli-demo-opened = A demonstration, kept nowhere. Ctrl-C ends it.
cli-serve-opened = The clinic in { $folder }. Ctrl-C ends it.
cli-setup-code = Set-up code, for the first owner, within { $minutes } minutes: { $code }
cli-control-process-failed = The control process cannot be started ({ $reason }): close other programs, then try again.
cli-control-process-ended = The control process did not start, so there is nothing to show: look at the messages above and try again.
# $kind is the name of an error in Python, $problem what it says
cli-not-started = The program did not start, because of { $kind }: { $problem }. Correct this if you can, then start it again; otherwise report this line.
# The name of the clinic of `bodydrive demo`.
cli-demo-clinic = Demonstration
# What is noted about the two patients of `bodydrive demo`.
cli-demo-calibrated = A demonstration patient: nobody real. Calibrated in the simulated shirt.
cli-demo-newcomer = A demonstration patient: nobody real. Never calibrated: drives by what others taught.

## service

cli-service-account = A unit of your own runs as you: leave --account out, or add --system.
cli-service-root = The clinic must not run as root: name its account with --account.
cli-service-state = Name the folder of the clinic with --state: a unit of the system has no home folder.
cli-service-letters = The folder or the account has a letter that a unit cannot carry: choose another one.

## check

cli-check-begins = Measuring for { $seconds } s, as the control loop would run ...

## replay

cli-replay-speed = --speed { $speed }: give a number between { $least } and { $most }
cli-replay-begins = Sending { $name } to { $to }: { $channels } channels at { $rate } Hz, { $seconds } s. Ctrl-C ends it.
cli-replay-loops = Sending { $name } to { $to }: { $channels } channels at { $rate } Hz, { $seconds } s again and again. Ctrl-C ends it.
cli-replay-failed = --to { $to }: nothing can be sent there ({ $reason }), give another address
cli-replay-stopped = Stopped: { $frames } frames sent.
cli-replay-ended = The recording has ended: { $frames } frames sent.
cli-replay-address = --to { $to }: write a host and a port, such as { $example }
cli-replay-no-host = --to { $to }: there is no host of this name, correct it

## score

cli-score-radius = --goal-radius { $radius }: give metres above 0 and at most { $most }
cli-score-places = { $file }: x and y must be metres, at most { $most } from 0: correct them
cli-score-too-long = { $file }: it lasts { $seconds } s, more than a day: give t in seconds, of one trial
cli-score-rows = { $file }: its rows are usually { $seconds } s apart: give t in seconds, not in milliseconds
cli-score-speed = { $file }: its mean speed is { $speed } m/s: give x and y in metres, and t in seconds
cli-score-slow = { $file }: its mean speed is { $speed } m/s with rows { $seconds } s apart: give t in seconds, not in milliseconds
cli-score-loops = Two loops around one place in opposite directions cancel in the area; the distance driven counts both.

## signals. column, unit, role, ... are titles of a table.

cli-signals-title-column = column
cli-signals-title-unit = unit
cli-signals-title-role = holds
cli-signals-title-joint = joint
cli-signals-title-least = least
cli-signals-title-most = most
cli-signals-title-missing = missing
cli-signals-role =
    { $role ->
        [time] time
        [channel] channel
        [other-time] another time
        [counter] counter
        [text] words
        [empty] nothing
        [constant] one value
       *[unused] not used
    }
cli-signals-summary =
    { $channels ->
        [one] { $rows } samples, { $seconds } s, at { $rate } Hz, { $channels } channel.
       *[other] { $rows } samples, { $seconds } s, at { $rate } Hz, { $channels } channels.
    }
# names: of streams or sheets.
cli-signals-parts = Parts that can be read alone with --part: { $names }.
cli-signals-suffix = --out { $file }: its name must end in .parquet
cli-signals-rate = --rate { $rate }: give Hz from { $least } to { $most }
cli-signals-unit = --unit { $unit }: give one of { $known }
cli-signals-channels = --channels { $channels }: give different names of columns with commas between them
# problem: a sentence without a full stop.
cli-signals-correct = { $problem } (or say it with --time, --unit or --rate; bodydrive signals show tells what a file holds)

## study

cli-study-seeds = --seed { $seed } leaves no room for --seeds { $seeds }: the largest seed is { $largest }
cli-study-learning = --no-learning goes without --adapt: over sessions the person is chosen with --person
cli-study-interface = --interface-test goes without --adapt and --no-learning: choose one of them
cli-study-map = --map { $map } goes with --adapt: say how the calibration adapts, or leave it out
cli-study-path = --path { $path }: it has no line to measure from, choose a path that is driven along
cli-study-foreign = --out { $folder } holds '{ $file }', which is no part of a study: name a new or empty folder
# $names are names of floor plans, with commas between them
cli-study-no-plan = --floorplan '{ $plan }': there is no such floor plan: use { $names } or a JSON file
# A sentence on the floor plan, the path or the folder that was named, which begins with the name where it needs one.
cli-study-bad-plan = --floorplan { $problem }
cli-study-bad-path = --path: { $problem }
cli-study-bad-out = --out { $problem }
cli-study-figures = --format { $format }: figures need the library matplotlib, install it with pip install 'bodydrive[figures]', or leave them out with --format none
# One trial of a simulated person: the area between the driven and the prescribed path.
cli-study-trial = trial { $number } of { $trials }: distance driven { $distance } m, area off the path { $area } m², { $seconds } s
cli-study-trial-missed = trial { $number } of { $trials }: distance driven { $distance } m, area off the path { $area } m², { $seconds } s, goal not reached
# $seed stands for a simulated person, $mode is off or what --adapt was given
cli-study-session-trial = seed { $seed }, { $mode }, session { $session }, trial { $trial }: area off the path { $area } m²
cli-study-session-trial-missed = seed { $seed }, { $mode }, session { $session }, trial { $trial }: area off the path { $area } m², goal not reached
cli-study-seed-trials =
    { $count ->
        [one] seed { $seed }: { $count } trial driven
       *[other] seed { $seed }: { $count } trials driven
    }
cli-study-seed-sessions =
    { $count ->
        [one] seed { $seed }: { $count } session
       *[other] seed { $seed }: { $count } sessions
    }
cli-study-trials-done =
    { $count ->
        [one] { $count } trial in { $seconds } s, written to { $out }
       *[other] { $count } trials in { $seconds } s, written to { $out }
    }
cli-study-tests-done =
    { $count ->
        [one] { $count } two-minute test in { $seconds } s, written to { $out }
       *[other] { $count } two-minute tests in { $seconds } s, written to { $out }
    }

## calibrate: a table with one line for each joint. A title of a column stays short.

cli-joints-joint = joint
# How clear the main movement is, in percent.
cli-joints-clear = clear
cli-joints-span = span
# How many of 100 movements reach half of full.
cli-joints-hits = hits of 100
# How often the gesture acts while the person rests.
cli-joints-at-rest = at rest a minute
# From which speed of the movement the gesture counts.
cli-joints-counts-from = counts from
cli-joints-full-at = full at
cli-joints-calibration = calibration
# Calibrations, in the last column: the standard one, one learnt from the cues, one learnt from other people.
cli-map-standard = standard
cli-map-cues = cues
cli-map-people = people
# A share of the full movement per second.
cli-calibrate-rate = { $share } % / s
# $least is the least figure that the repetitions show
cli-at-least = { $figure } (at least { $least })
cli-at-most = { $figure } (at most { $most })
# An expected figure with its standard deviation.
cli-forecast = { $value } ± { $uncertainty }
cli-calibrate-clear-means = Clear: share of the signal that lies in the main movement. Span: of the full movement, in the signals' own unit.
cli-calibrate-expected-means = Hits of 100: movements that are expected to reach half of full. At rest a minute: how often the gesture is expected to act while the person rests.
# $reason has no full stop
cli-channel-left-out = Channel { $channel } is left out: { $reason }.
cli-calibrate-out = The profile is in { $out }
# Titles of the columns of gestures: all of them together as one score, the strength of the signal, how well the
# movement repeats, how much moves along with it, the effort, false activations a minute, the share of cues answered.
cli-gesture = gesture
cli-gestures-score = score
cli-gestures-signal = signal
cli-gestures-repeats = repeats
cli-gestures-along = along
cli-gestures-effort = effort
cli-gestures-false = false/min
cli-gestures-answered = answered
# What gestures are suggested for.
cli-control-faster = faster
cli-control-slower = slower
cli-control-left = turn left
cli-control-right = turn right
cli-control-stop = stop
# $source says what the calibration was learnt from. $hits and $false are such as: 93 ± 6.6
cli-prior-joint = { $joint }: { $source } ({ $people } people, { $repetitions } own repetitions); expected hits of 100 movements: { $hits }; expected false activations a minute: { $false }
cli-prior-joint-dropped = { $joint }: { $source } ({ $people } people, { $repetitions } own repetitions); expected hits of 100 movements: { $hits }; expected false activations a minute: { $false }; channels that hardly move: { $channels }
# A ring is a band of sensors around an arm.
cli-ring-as-others = Ring { $ring }: it sits as on other people.
cli-ring-turned =
    { $places ->
        [one] Ring { $ring }: it is turned by { $places } place against other people; the calibration allows for that.
       *[other] Ring { $ring }: it is turned by { $places } places against other people; the calibration allows for that.
    }
cli-ring-mirrored =
    { $places ->
        [one] Ring { $ring }: it is mirrored and turned by { $places } place against other people; the calibration allows for that.
       *[other] Ring { $ring }: it is mirrored and turned by { $places } places against other people; the calibration allows for that.
    }
cli-map-guided-missing = --map guided, { $joint }: { $reason }
cli-map-prior-missing = --map prior, { $joint }: { $reason }
cli-map-needs-prior = --map prior: other people's movements are in a prior, give it with --prior
# $reason is a sentence
cli-map-fallback = { $joint }: { $reason } It keeps the standard calibration.
cli-map-guided-not-better = { $joint }: what was learnt from the cues is not better on the held-out repetitions. Use --map best to keep the standard calibration there.
cli-map-prior-worse = { $joint }: what was learnt from other people is worse on the held-out repetitions. Use --map best to leave it out there.
cli-compare-title = On prompted repetitions that were kept apart, the standard calibration and the one learnt from the cues:
# Titles of columns, each over two figures: of the standard calibration and of the one learnt from the cues.
cli-compared-in-phase = in phase
cli-compared-time-driven = time driven
cli-compared-false = false per min
# Whether the calibration learnt from the cues is offered: yes or no.
cli-compare-offered = offered
cli-no-seconds = --{ $option } { $value }: give a number of seconds
cli-nothing-there = --{ $start } { $first } --{ $end } { $last }: nothing of { $signals } lies there, it goes from { $begins } to { $ends } s
cli-prior-problem = --prior { $file }: { $problem }

## prior: what is known of other people in the same shirt. An own prior has an entry for each person; a release has sums over people only, and may leave the clinic.

cli-prior-one-table-each = there are { $recordings } recordings and { $tables } tables of prompts: give one for each
cli-prior-add-to-release = { $prior } is a release, which holds sums over people: add to the clinic's own prior
cli-prior-added =
    { $people ->
        [one] { $person } added with { $strokes } strokes in { $prior }, which now holds { $people } person
       *[other] { $person } added with { $strokes } strokes in { $prior }, which now holds { $people } people
    }
cli-prior-replaced =
    { $people ->
        [one] { $person } replaced with { $strokes } strokes in { $prior }, which now holds { $people } person
       *[other] { $person } replaced with { $strokes } strokes in { $prior }, which now holds { $people } people
    }
cli-prior-nobody = { $prior }: there is no person '{ $person }' in it
cli-prior-removed = { $person } removed from { $prior }
cli-prior-own =
    { $people ->
        [one] { $prior }: own prior, an entry per person, { $people } person in '{ $layout }'
       *[other] { $prior }: own prior, an entry per person, { $people } people in '{ $layout }'
    }
cli-prior-release = { $prior }: release, sums only, { $people } people in '{ $layout }'
# Titles of columns.
cli-prior-movement = joint and gesture
cli-prior-column-people = people
cli-prior-column-seconds = seconds
cli-prior-column-strokes = strokes
cli-prior-column-rate = rate of strokes
cli-prior-ranges = ranges of the channels, signal units
# The prompted movement of a joint.
cli-prior-prompted = { $joint }, prompted
cli-prior-rate-means = Rate of strokes: mean and deviation in a movement, as shares of the rate that counts as full
cli-prior-ring =
    { $people ->
        [one] Ring { $ring }: how it sits is known of { $people } person
       *[other] Ring { $ring }: how it sits is known of { $people } people
    }
cli-prior-too-few = Too few to drive with: { $people } people are needed for a joint
cli-prior-twice = { $prior } stands there twice: name each prior once
cli-prior-merged =
    { $people ->
        [one] { $people } person in { $out }
       *[other] { $people } people in { $out }
    }
cli-prior-released = { $people } people in { $out }
# $names are names of joints, with commas between them
cli-prior-left-out = Left out are joints with fewer than eight people who are in no release yet: { $names }
cli-prior-exported =
    { $people ->
        [one] { $people } person in { $out }, with an entry each: it must not leave the clinic.
       *[other] { $people } people in { $out }, with an entry each: it must not leave the clinic.
    }
cli-prior-sums =
    { $people ->
        [one] { $people } person in { $out }: sums only, which may leave the clinic.
       *[other] { $people } people in { $out }: sums only, which may leave the clinic.
    }
cli-prior-sums-without =
    { $people ->
        [one] { $people } person in { $out }: sums only, which may leave the clinic. Left out are joints with fewer than eight people who are in no release yet: { $names }.
       *[other] { $people } people in { $out }: sums only, which may leave the clinic. Left out are joints with fewer than eight people who are in no release yet: { $names }.
    }
cli-prior-import-release = { $prior } is a release, which holds sums and no entries of people: use it with `calibrate --prior`, and import the clinic's own prior
cli-prior-switched-off = The clinic has switched off that calibrations help later patients: see Settings
cli-prior-no-patient = { $prior }: there is no patient '{ $code }' in the clinic; nobody was imported
# In quotation marks: a consent, as the page of the patient calls it.
cli-prior-no-consent = { $prior }: the patient '{ $code }' has not consented to “{ consent-clinic-prior }”; nobody was imported
cli-prior-imported =
    { $people ->
        [one] { $people } person imported from { $prior }
       *[other] { $people } people imported from { $prior }
    }
cli-prior-nobody-shares =
    { $people ->
        [one] The { $people } person known in '{ $layout }' has not consented to “{ consent-sharing }”: ask, and note it on the page of the patient
       *[other] Nobody of the { $people } people known in '{ $layout }' has consented to “{ consent-sharing }”: ask them, and note it on the page of the patient
    }
cli-prior-nobody-known = Nobody is known in '{ $layout }': calibrate patients in it who have consented to “{ consent-clinic-prior }”
cli-prior-code = A patient's code has characters that a prior cannot name: use letters, digits, dots and dashes only
cli-prior-no-release = Of those who have consented to “{ consent-sharing }”: { $problem }
cli-prior-was-read = { $file } is a file that was read for this: give the prior another name
cli-prior-unwritable = { $file } cannot be written ({ $reason }): choose another place
cli-prior-person = --person { $person }: give 1 to 64 letters, digits, dots or dashes

## backup and restore. $time is a day with a time of day.

cli-backup-made =
    { $name }: { $files } files, { $size } MB, { $keys ->
        [with] with the keys of chairs, shirts and clinic
       *[without] without the keys of chairs, shirts and clinic
    }, { $encrypted ->
        [yes] encrypted
       *[no] not encrypted
    }. It was read back, and every hash is right.
cli-backup-hash = Hash of all: { $hash }
cli-backup-no-erased = There is no file { $file }: name the list of erased patients, or leave --erased out.
cli-backup-clinic-open = The clinic in { $folder } is open: restore into an empty folder.
cli-restored-with-keys = The clinic of { $time } UTC is in { $folder }: { $files } files, { $size } MB, every one equal by hash. The keys of chairs, shirts and clinic were in it.
cli-restored-without-keys = The clinic of { $time } UTC is in { $folder }: { $files } files, { $size } MB, every one equal by hash. It held no keys: pair chairs and shirts anew.
cli-restored-erased =
    { $count ->
        [one] { $count } patient who was erased since stays erased.
       *[other] { $count } patients who were erased since stay erased.
    }
cli-backup-whole = { $name } is whole: { $files } files of { $time } UTC, every hash is right.
cli-backup-is-folder = { $folder } is a folder of backups: name one of its files; the newest is { $newest }.
cli-no-backup = There is no backup { $file }: name a file.
cli-passphrase-needed = This needs a passphrase: put it into the environment variable { $variable }.
# A question; a colon follows.
cli-passphrase = Passphrase
cli-passphrase-short = This passphrase is too short: take { $least } characters or more.
# The progress of making a backup, in two steps.
cli-backup-step-store = Copying: { $done } of { $total } MB
cli-backup-step-verify = Reading back: { $done } of { $total } MB
cli-backup-unlogged = The clinic is of another version than this command, so its log does not name this backup.

## report, export, archive, incident

cli-report-suffix = --out { $file } ends neither with .pdf nor with .html: give one of these.
# $problem says in a sentence or two that the patient has not consented, and that a copy for the patient needs no consent
cli-report-for-patient = { $problem } For such a copy, add --for-patient.
cli-export-format = --format { $format }: give one of { $formats }.
cli-export-step = Recording { $done } of { $total }
cli-archive-made = { $file } is written. Its hash is { $hash }.
cli-archive-imported = The patient { $code } is imported. Sessions: { $sessions }. Finished and kept trials: { $trials }.
cli-archive-replaced = The patient { $code } is replaced. Sessions: { $sessions }. Finished and kept trials: { $trials }. The patient as it was is kept for 30 days in { $file }.
cli-archive-again = The patient { $code } was imported from this archive before: nothing was changed.
cli-incident-key = --public-key belongs to --check: leave it out, or check an incident file.
cli-incident-no-folder = There is no folder { $folder }: make it, or choose another place.
# $start and $end are days with a time of day.
cli-incident-right = { $name }: { $files } files, { $recordings } recordings, from { $start } to { $end } UTC. Every hash and the signature are right.
cli-incident-hash = Hash of the manifest: { $hash }
cli-incident-fingerprint = Fingerprint of the key: { $fingerprint }
cli-incident-kept = Patients of these sessions are not erased before an owner lifts the mark (page Backup).
