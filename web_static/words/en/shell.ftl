### Texts of the frame: header, rail, notices, sign-in.

app-name = bodydrive
app-title = { $page } · bodydrive
demo-tag = Demonstration
demo-explained = Everything here is a demonstration: patients and trials are thrown away when the program ends.
stop = STOP
stop-label = Stop the chair now
stop-sent = Stop was sent.
stop-not-sent = Stop did not get through: switch the chair off at its own switch.
app-title-of = { $code }, { $part } · { $page } · bodydrive
who-open = session { $number } open
who-shown = shown
who-shown-one = session { $number } shown
who-shown-two = sessions { $first } and { $second } shown
busy-trial = A trial is running. Nothing can be changed here until it has ended.
busy-trial-go = Go to the drive
busy-drive = The real chair is armed. Nothing can be changed here until the drive has ended.
busy-drive-go = Go to the chair
busy-test = The two-minute test is running. Nothing can be changed here until it has ended.
busy-test-go = Go to the test
busy-run = A step of the calibration is running. Nothing can be changed here until it has ended.
busy-run-go = Go to the calibration
who-nobody = No session is open
lamp-shirt = Shirt { $good } of { $all }
lamp-shirt-estimated = Shirt { $good } of { $all }, { $estimated } estimated
lamp-shirt-silent = Shirt silent
lamp-shirt-unknown = Shirt: not known
lamp-shirt-none = No shirt yet
lamp-chair = Chair: virtual
lamp-chair-unknown = Chair: not known
lamp-screen =
    { $count ->
        [one] Patient’s screen
       *[other] { $count } patient’s screens
    }
lamp-screen-bad =
    { $count ->
        [one] Patient’s screen: no picture
       *[other] A patient’s screen: no picture
    }
lamp-screen-away =
    { $count ->
        [one] Patient’s screen: out of reach
       *[other] A patient’s screen: out of reach
    }
lamp-armed = Chair: armed
lamp-real = Real chair: { $state }
lamp-real-disarmed = disarmed
lamp-real-checking = waits for rest
lamp-real-armed = armed
lamp-real-fault = not ready
lamp-real-silent = no answer
theme-label = Colours: { $theme }. Change
theme-system = as the system
theme-light = light
theme-dark = dark
theme-contrast = high contrast
theme-now = Colours: { $theme }.
help-open = What is this page for?
sign-out = Sign out
rail-label = The steps of a session, and settings
rail-done = done
rail-sign-in = Sign in
rail-set-up = Set up the clinic
rail-chair = Real chair
rail-patients = Patients
rail-shirt = Shirt
rail-calibrate = Calibrate
rail-controls = Controls
rail-drive = Drive
rail-review = Review
rail-settings = Settings
note-lost = No connection to the program since { $time }.
note-lost-why = A chair that is driven from this page stops by itself. The page still tries to send STOP; all else waits for the connection.
practice-simulator = Simulated shirt:
practice-replay = Recorded signals:
practice-other = A shirt that nobody wears:
practice-only = practice only
session-other = Another session is open
session-opened = Patient { $code } was opened on another screen by { $name } at { $time }.
session-opened-somebody = Patient { $code } was opened on another screen at { $time }.
session-ended = The session of patient { $code } was ended on another screen, and no session is open now.
session-belongs = What this page shows belongs to { $code } and can no longer be sent.
session-over = Another session is open: nothing was sent from this page.
session-drafts = Entered here and not sent:
session-draft = { $label }: { $value }
session-go = Go on with { $code }
session-patients = Go to the patients
note-control = The control process ended; the chair stands.
note-control-why = Starting a new one…
note-fault-continue = Continue
note-fault-again = Stopped again at { $time }.
note-fault-others = The clinician beside the chair looks around, then taps Continue.
note-fault-drive = The chair stands. “Continue” is on the page that shows it.
note-fault-drive-go = Go to the drive
note-fault-idle = No trial and no drive runs: taking the stop back moves nothing, and a new trial can be started then.
note-fault-idle-go = Take the stop back
note-fault-idle-others = The chair stands. The clinician beside the chair looks around, then takes the stop back.
note-driving = A real chair is being driven.
note-driving-go = Go there
note-warning-go = Look at the backups
note-fault-first = A stop or fault is still in force: see the strip above, and take the stop back there first.
note-signed-out = You were signed out: sign in again.
error-no-answer = The program does not answer: see whether it still runs, then try again.
error-status = The program refused this (code { $status }): load the page again.
error-page = This page could not be shown.
error-other-page = Go to “{ $page }”
try-again = Try again
undo = Undo
redo = Redo
cancel = Cancel
back = Back
loading = One moment…
sign-in-title = Sign in
sign-in-lead = Body-machine interface for powered wheelchairs.
sign-in-name = Name
sign-in-password = Password
sign-in-go = Sign in
sign-in-invited = Invited, but without a password yet? Open the link of your invitation, or scan its code, on this device.
typed-show = Show
typed-show-label = Show what is typed
typed-hide = Hide
typed-hide-label = Hide what is typed
sign-in-demo = This is a demonstration: open the link that the program printed on its console. It signs you in.
setup-title = Set up this clinic
setup-lead = This clinic has no people yet. You become the first owner: the one who may add people.
setup-code = Set-up code
setup-code-hint = The program printed it on its console when it started.
setup-password-hint = At least { $count } characters. A short sentence is easy to remember.
setup-go = Set up and sign in
nobody-title = No session is open
nobody-lead = Choose a patient: that starts a session, and this page shows it.
nobody-go = Choose a patient
# What a page shows instead of a patient whom somebody has deleted; $code: of the patient.
gone-title = Patient deleted
gone-lead = { $code } was deleted: nothing of this patient can be seen or changed any more.

## The choice of the language. Each language has its own name, in all files the same.

language-title = Language
language-lead = Of these pages, for you and for this browser.
language-screen = Language of the patient's screen
language-of-browser = As the screen's browser
language-en = English
language-es = Español
language-de = Deutsch
