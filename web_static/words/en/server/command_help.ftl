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

cli-help-signals = CSV or Parquet, or the folder of a recording.
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
cli-help-study = Let a simulated person calibrate, then drive a path again and again, and score every trial.
cli-help-replay = Play a recorded run as a shirt source: its frames as datagrams, at their own times. Ctrl-C ends it.
cli-help-floorplan = List the places that come with the software, check one, or make one from a file.

## chair and shirt

cli-help-chair = Pair with a real chair; receive on the chair what it is to drive.
cli-help-shirt = Pair with a shirt over the network; send as such a shirt does.

## people, log and about

cli-help-people = See, invite, disable and enable the people of a clinic; make a link for a new password.
cli-help-log = Look at the log of a clinic: who did what, when.
cli-help-about = Say which version this is, how it was built, and which packages it uses.

## report, export, archive, backup, restore and incident

cli-help-report = Write the report of a patient's session, or of all sessions; the clinic may be open meanwhile.
cli-help-export = Export a patient's recordings and measures; the clinic may be open meanwhile. The patient must have consented.
cli-help-archive = Take a whole patient to another clinic: sessions, controls, trials, recordings.
cli-help-backup = Back up a clinic, also while it is open, and read the backup back; into a folder, only what is new is written.
cli-help-restore = Restore a clinic into an empty folder: every file equal by hash, patients who were erased since left out.
cli-help-incident = Archive log, recordings, parameters and versions of the last 24 hours, signed, and mark them as to be kept.
