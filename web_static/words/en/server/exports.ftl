### Texts of exports: refusals, and what stands in the exported files for those who read them.

exports-nothing = There is nothing to export: nothing was recorded.
exports-no-session = This patient has no session { $session }: choose one that was opened.
exports-recording-missing = This recording is missing.
# Name of a data set of the Brain Imaging Data Structure (BIDS); $patient is a code.
exports-bids-name = bodydrive recordings of { $patient }
# File README of such a data set. tracksys-shirt, tracksys-wheelchair, LATENCY and BodydriveSource are names in its files.
exports-bids-readme =
    Signals of a shirt with strain sensors, or of what stood in for it, and the wheelchair that they drove, by bodydrive.

    tracksys-shirt: the channels of the shirt, one row for each frame that came.
    tracksys-wheelchair: pose and commands, one row for each turn of the control loop.
    Each motion file begins with the column LATENCY: seconds since the start of the run.
    The sidecar of each file says where the signals come from, and whether they are simulated (BodydriveSource).
exports-method-test = Two-minute test: targets on a cross, reached with a cursor, while no chair moves
# How a measure was taken: the title of the floor plan, and the name of the path on it.
exports-method-trial = { $plan }, path { $path }
exports-note-trial = { $source }. Session { $session }, trial { $number }. Calibration version { $version }, fingerprint of the controls { $hash }.
exports-note-test = { $source }. Session { $session }, two-minute test { $number }. Calibration version { $version }, fingerprint of the controls { $hash }.
