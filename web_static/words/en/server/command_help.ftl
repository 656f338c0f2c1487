### The help of the command line, `bodydrive COMMAND --help`. Each message is one line without values.
### Words that begin with --, words in capitals and names of files are typed on the command line: they are not translated.

## Every command

cli-help-program = Body-machine interface for powered wheelchairs: calibrate, practise, score, drive.
cli-help-version = Say which version this is, and end.
cli-help-state = The folder of the clinic's database and recordings.
cli-help-json = Print one JSON object and nothing else.

## demo and serve

cli-help-demo = Open a throw-away demonstration clinic: a simulated shirt, a patient, and the virtual chair.
cli-help-serve = Open a clinic; its database and recordings are kept.
cli-help-port = The port to listen on; 0 takes any free one.
cli-help-demo-host = The address to listen on, one of this machine alone.
cli-help-demo-floorplan = A floor plan of your own to drive in, too.
cli-help-serve-host = The address to listen on; with --lan one of this machine's, or several, instead of all.
cli-help-serve-lan = Open the clinic to tablets in this network, over https.
cli-help-serve-certificate = A certificate of your own for --lan: a PEM file, with its chain.
cli-help-serve-key = The private key of that certificate: a PEM file.
cli-help-serve-behind-proxy = The address of the clinic's own reverse proxy, the only way in; needs --name.
cli-help-serve-name = The name, or NAME:PORT, by which browsers reach the proxy.
cli-help-serve-lsl = Send commands, gestures and markers to LabRecorder over LSL; everybody on the network can read them.

## check and service

cli-help-check = Measure what this computer grants, and say whether it is good enough for driving; exit code 1 when it is not.
cli-help-check-seconds = How long to measure the loop.
cli-help-check-own-port = A port of the clinic that runs, instead of the usual two.
cli-help-service = Let the machine start the clinic by itself.
cli-help-service-install = Install a systemd unit that runs `bodydrive serve --lan`, and start it.
cli-help-service-install-system = A unit of the system, which starts with the machine; needs sudo.
cli-help-service-install-account = With --system: the account that owns the clinic, not root.
cli-help-service-install-print = Print the unit, and change nothing.

## calibrate and decode. A column of a CSV file, such as start, is not translated.

cli-help-signals = CSV, Parquet, XLSX, MATLAB, C3D, EDF, XDF or BVH, or the folder of a recording.
cli-help-signals-command = Show what a file of signals holds, before it is used.
cli-help-signals-show = Show what a file of signals holds: its columns, its time with its unit, its sample rate, its channels and joints.
cli-help-signals-layout = The shirt's layout, JSON; without it that beside the file.
cli-help-signals-out = Where the signals go, as they are read: a .parquet file with t in seconds.
cli-help-signals-time = The column of times; empty where none is right, and --rate counts.
cli-help-signals-unit = The unit of the times: s, ms, us, ns, min, h or d.
cli-help-signals-rate = The sample rate, Hz: the samples are even, whatever their times say.
cli-help-signals-channels = The columns of the channels, in the order of the layout.
cli-help-signals-part = The stream or the sheet that is read alone, by its name.
cli-help-layout = The shirt's layout, JSON.
cli-help-calibrate = Fit a calibration profile to a file of signals: per joint its main movement, span, sign and thresholds.
cli-help-calibrate-out = Where the calibration profile goes, JSON.
cli-help-calibrate-prompts = CSV start,end,joint: when which joint moved towards its gesture; every row counts. Fixes the sign.
cli-help-calibrate-from = Where the free movement begins, s.
cli-help-calibrate-to = Where the free movement ends, s.
cli-help-calibrate-rest-from = Where the rest begins, s.
cli-help-calibrate-rest-to = Where the rest ends, s.
cli-help-calibrate-unused = A channel not to be used; may be given again.
cli-help-calibrate-prior = What `bodydrive prior` wrote of other people in the same shirt.
cli-help-calibrate-map = Which calibration drives: standard, learnt from the cues, from other people, or the best.
cli-help-calibrate-gestures = Rank every gesture that was found, there and back, and suggest four.
cli-help-decode = Decode a file of signals with the very chain of the live loop.
cli-help-decode-profile = What `bodydrive calibrate` wrote, or a saved parameter set.
cli-help-decode-out = Where the commands go: .parquet or .csv.
cli-help-decode-dead-zone = From where every gesture counts, full movements per second.
cli-help-decode-cutoff = Tremor damping, Hz: lower damps more.

## prior

cli-help-prior = Learn from other people in the same shirt, so that somebody new drives before being calibrated.
cli-help-prior-file = The prior; it is made when there is none.
cli-help-prior-person = A code for the person: letters, digits, dots and dashes, no name.
cli-help-prior-add = Add a person's recordings to a prior. A person who is in it already is replaced.
cli-help-prior-add-signals = CSV, Parquet or a recording's folder; all recordings of the person.
cli-help-prior-add-prompts = CSV start,end,joint: when which joint moved towards its gesture. One for each of SIGNALS.
cli-help-prior-add-from = Where ten seconds of free movement begin, s.
cli-help-prior-remove = Take a person out of a prior, as if this person had never been added.
cli-help-prior-show = Show per joint and gesture what a prior knows: people, seconds, strokes and their rates, ranges of channels.
cli-help-prior-merge = Add priors up. The result holds sums over eight people or more, and nobody's entry: it may leave the clinic.
# A further paragraph.
cli-help-prior-merge-released = An own prior keeps who was released, because nobody may be in two releases: of a prior that has grown, only the people who are new are released, and releases are added up. The files of the own priors that are released are written again for that.
cli-help-prior-merge-priors = Own priors or releases.
cli-help-prior-merge-out = Where the result goes: a .json file.
cli-help-prior-merge-own = Keep an entry per person. The result must not leave the clinic.
cli-help-prior-export = Write what the clinic knows of patients in a worn shirt. Without --release it must not leave the clinic.
cli-help-prior-export-out = Where the prior goes.
cli-help-prior-export-layout = The layout of the worn shirt, JSON.
cli-help-prior-export-release = Only sums over eight people or more, all of whom consent to sharing.
cli-help-prior-import = Take over a clinic's own prior: for all of its people, or for nobody. What is known of them is replaced.
cli-help-prior-import-file = A clinic's own prior, as `export` writes it.

## score, study, replay and floorplan

cli-help-score = Score a driven trajectory against a prescribed path; s and m.
# A further paragraph.
cli-help-score-following = A drive that ends no further along the path than it began, and not at its goal, has no measures of following. Two loops around one place in opposite directions cancel in the area off the path; the distance driven counts both.
cli-help-score-trajectory = CSV or Parquet with columns t, x, y; TUM, EuRoC or KITTI; a bag of ROS or MCAP.
cli-help-score-path = CSV or Parquet with columns x, y: the path's points.
cli-help-score-goal-radius = How near the path's end counts as reached, m.
cli-help-study = Let a simulated person calibrate, then drive a path again and again, and score every trial.
cli-help-study-out = Folder to write; it must be new or empty.
cli-help-study-trials = How often the path is driven: 22, or 3 a session.
cli-help-study-seed = The same seed gives the same numbers.
cli-help-study-seeds = How many people, from --seed on.
cli-help-study-floorplan = Name of a bundled floor plan, or a JSON file.
cli-help-study-path = Name of a path in it; the first when not given.
cli-help-study-format = Of the figures; none leaves them out.
cli-help-study-no-learning = Nothing that is practised stays.
cli-help-study-overwrite = Replace what the folder holds.
cli-help-study-adapt = Over sessions: let the calibration follow the person, against a fixed one.
cli-help-study-person = Over sessions: what happens to body or shirt.
cli-help-study-map = With --adapt: standard calibration, or what cues or other people teach.
cli-help-study-sessions = How many, with --adapt or --interface-test.
cli-help-study-interface-test = Over sessions: the two-minute test before the trials of each.
cli-help-study-jobs = Processes at once; as many as processors when not given.
cli-help-replay = Play a recorded run as a shirt source: its frames as datagrams, at their own times. Ctrl-C ends it.
cli-help-replay-recording = Folder of a recorded run, CSV or Parquet.
cli-help-replay-to = Where the datagrams go, HOST:PORT.
cli-help-replay-loop = Begin again at the end.
cli-help-replay-speed = How many times as fast as it was recorded.
cli-help-floorplan = List the places that come with the software, check one, or make one from a file.
cli-help-floorplan-import = Make a floor plan from a ROS map, a DXF drawing or a picture: walls, and a path to drive.
cli-help-floorplan-import-file = MAP.yaml of a ROS map, a DXF drawing, or a PNG or JPEG picture.
cli-help-floorplan-import-out = Where the floor plan goes: a .json file.
cli-help-floorplan-import-name = The plan's name: letters, digits, dots, dashes.
cli-help-floorplan-import-title = What people call it.
# The units are typed.
cli-help-floorplan-import-unit = Of a drawing that does not say it: mm, cm, m, inch or foot.
cli-help-floorplan-import-layer = A drawing's layer with walls; several times for more.
cli-help-floorplan-import-metres-per-pixel = A picture's scale.
cli-help-floorplan-import-width = Or how wide the whole picture is, m.
cli-help-floorplan-import-threshold = A pixel lighter than this share of white is free.
cli-help-floorplan-import-outside = A map or a picture: use what can be reached from its edge, too.
cli-help-floorplan-list = List what can be driven in and comes with the software: scenes by level, buildings, and their tasks.
cli-help-floorplan-check = Say whether a floor plan or a scene can be driven in, and if not, what is wrong where.
cli-help-floorplan-check-file = A floor plan or a scene.

## chair and shirt

cli-help-chair = Pair with a real chair; receive on the chair what it is to drive.
cli-help-chair-receive = Run on the chair: check commands, watch the time, ramp, and drive an output.
cli-help-chair-measure = Run on the chair: measure by short drives which speed a deflection of its joystick gives.
cli-help-chair-rehearse = Rehearse without a chair: arm, drive, stop, press the switch, pull the cables of an emulated chair.
cli-help-chair-rehearse-record = Each step says what must happen within how many milliseconds. The record is signed with the chair's key.
cli-help-chair-rehearse-key-file = The chair's key, as pairing made it.
cli-help-chair-rehearse-out = Where the record goes: a .json file; a .md file beside it is to be read.
cli-help-chair-rehearse-who = Who does this: stands in the record.
cli-help-chair-rehearse-output = What is emulated: sim or whill.
cli-help-chair-rehearse-verify = Check the record in --out instead: whether it is as it was signed.
cli-help-chair-pair = Make a key for a chair, keep it with the clinic, and show it once as a QR code.
# A further paragraph.
cli-help-chair-pair-units = Speeds are in m/s and rad/s, accelerations in m/s2 and rad/s2, jerks in m/s3 and rad/s3.
cli-help-chair-pair-name = What people call the chair.
cli-help-chair-pair-host = The chair's address, as this machine reaches it.
cli-help-chair-pair-port = Where its receiver listens.
# Of a speed, an acceleration or a jerk.
cli-help-chair-pair-limit = What this chair may do at most; a careful standard when not given.
cli-help-shirt = Pair with a shirt over the network; send as such a shirt does.
cli-help-shirt-send = Send a file or slow waves as a paired shirt does: the example for a shirt's firmware.
cli-help-shirt-pair = Make a key for a shirt, keep it with the clinic, and show it once as a QR code.

## people, log and about

cli-help-people = See, invite, disable and enable the people of a clinic; make a link for a new password.
cli-help-people-name = The name that the person signs in with.
# The roles are typed.
cli-help-people-role = owner, clinician or reviewer.
cli-help-people-patient = The code of a patient that a reviewer may see, once for each; without: all.
cli-help-people-address = The address of the pages, for the link; that of the running program.
cli-help-people-list = List the people of the clinic: name, role, what a reviewer may see, whether they can sign in.
cli-help-people-invite = Add a person, and print the link by which this person chooses a password within 24 hours.
# A further paragraph.
cli-help-people-invite-again = For somebody who is there already, the link makes a new password; role and patients stay.
cli-help-people-disable = Let a person sign in no longer; open pages of this person end within 5 s.
cli-help-people-enable = Let a disabled person sign in again.
cli-help-log = Look at the log of a clinic: who did what, when.
cli-help-log-verify = Check that no row of the log was edited, moved, put in or removed; the clinic may be open meanwhile.
# A further paragraph.
cli-help-log-verify-exit = The exit code is 0 when the log is whole, 1 when it was changed, 2 when it cannot be read.
cli-help-about = Say which version this is, how it was built, and which packages it uses.
cli-help-about-licences = List its packages, and the work of others in its files, with licences.

## report, export, archive, backup, restore and incident

cli-help-patient = The code of the patient.
cli-help-report = Write the report of a patient's session, or of all sessions; the clinic may be open meanwhile.
cli-help-report-out = The file to write: its suffix is .pdf or .html.
cli-help-report-session = The number of one session; without: the course of all sessions.
cli-help-report-letter = Letter paper instead of A4.
cli-help-report-for-patient = A copy for the patient: needs no consent to sharing outside.
cli-help-report-language = The language of the report; without: that of the terminal.
cli-help-export = Export a patient's recordings and measures; the clinic may be open meanwhile. The patient must have consented.
cli-help-export-out = The zip file to write.
cli-help-export-format = The format of the files in it.
cli-help-export-session = The number of one session; without: all sessions.
cli-help-archive = Take a whole patient to another clinic: sessions, controls, trials, recordings.
cli-help-archive-make = Write the archive of a patient, who must have consented; the clinic may be open meanwhile.
cli-help-archive-make-out = The archive to write.
cli-help-archive-import = Import an archive; the same one once more changes nothing.
cli-help-archive-import-file = The archive.
cli-help-archive-import-replace = Replace the patient who is here; first an archive of it is kept.
cli-help-backup = Back up a clinic, also while it is open, and read the backup back; into a folder, only what is new is written.
cli-help-backup-file = The file to make, or a folder of backups.
cli-help-backup-encrypt = Encrypt it with a passphrase, asked for or in BODYDRIVE_PASSPHRASE.
cli-help-backup-with-keys = Back the keys of the chairs and of the clinic up, too.
cli-help-backup-check = Make none: read the backup FILE and check all of it.
cli-help-restore = Restore a clinic into an empty folder: every file equal by hash, patients who were erased since left out.
cli-help-restore-file = A backup; in a folder of backups, one of its files.
cli-help-restore-erased = A newer erased-patients.json, so that those patients stay erased.
cli-help-incident = Archive log, recordings, parameters and versions of the last 24 hours, signed, and mark them as to be kept.
cli-help-incident-file = The archive to make, or with --check to read.
cli-help-incident-check = Make none: check every hash and the signature of the archive FILE.
cli-help-incident-public-key = With --check: the clinic's public key (PEM), not the one inside.
