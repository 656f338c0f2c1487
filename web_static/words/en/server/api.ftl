### Refusals of requests, and what the pages show of the server's state: signing in, roles, addresses, files, floor plans,
### screens, replays, this computer.

## Signing in

api-locked = This page is locked: give the password, or let somebody else sign in.
api-not-signed-in = You are not signed in, or no longer: sign in again.
api-reviewer-changes-nothing = A reviewer reads and comments, and changes nothing else: ask an owner for more rights.
api-reviewer-exports-nothing = A reviewer takes no records out of the clinic: ask a clinician for a report or an export.
api-only-owners = Only an owner of the clinic changes this: ask one.
api-link-wrong = This link is wrong, was used, or is older than { $hours } hours: ask an owner for a new one.
api-person-disabled = This person may no longer sign in: ask an owner.
api-no-demonstration = This is not a demonstration: sign in with your name and password.
api-other-demonstration = This link belongs to another demonstration: open the link that was printed last.
api-set-up-already = This clinic is set up already: sign in with your name and password.
api-set-up-code-wrong = This code is wrong, used or older than { $minutes } minutes: restart the program for a new one.
api-passwords-not-checked = Passwords cannot be checked at this moment: try again.
api-sign-in-wrong = Name or password is wrong: try again, or ask an owner for a new password.
# $name is the name of the person who is signed in.
api-password-not-own = That is not the password of { $name }: try again, or ask an owner for a new one.
api-sign-in-busy = Too many people are signing in at this moment: wait a few seconds, then try again.
api-password-short = This password is too short: use at least { $least } characters.
api-password-long = This password is too long: use at most { $most } characters.
api-password-common = This password is among the first that anybody would try: choose another one.
api-tries-name =
    { $seconds ->
        [one] Too many wrong passwords for this name: wait { $seconds } second, or sign in where you have signed in before.
       *[other] Too many wrong passwords for this name: wait { $seconds } seconds, or sign in where you have signed in before.
    }
api-tries-here =
    { $seconds ->
        [one] Too many wrong passwords came from here: wait { $seconds } second, then try again.
       *[other] Too many wrong passwords came from here: wait { $seconds } seconds, then try again.
    }
api-tries-code =
    { $seconds ->
        [one] Too many wrong codes came from here: wait { $seconds } second, then try again.
       *[other] Too many wrong codes came from here: wait { $seconds } seconds, then try again.
    }

## Addresses and requests

api-address-not-ours = This address does not belong to this program: open the link that it printed.
api-not-our-page = This request does not come from our own page: open the page and try again.
api-too-large = This is too large: send at most { $megabytes } MB here.
api-too-many-files = Other files are arriving at the moment: wait until they are here, then try again.
api-too-slow = This arrives too slowly, so it was given up: bring this device nearer to the network, then try again.
api-not-the-proxy = This program is reached through the clinic's proxy only: open the address of the proxy.
api-proxy-incomplete = The proxy does not say who sent this request: let it set X-Forwarded-For, X-Forwarded-Proto and X-Forwarded-Host, each once, as in docs/proxy.
api-proxy-not-encrypted = The proxy was reached without encryption: let it answer https only, and open its https address.
# $none is a word of the interface for programs, $header the name of a header.
api-session-unnamed = The request does not name the session that its page shows: send its id, or '{ $none }' while no session is open, in the header { $header }.
api-link-only-here = Only this machine can open the link, because the program listens to nobody else.
api-link-only-in-network = The link opens in the clinic's own network or VPN only: elsewhere, it needs a proxy (page “For the computing department” under /docs/).
api-screen-only-here = Only this machine can open the link, because the program listens to nobody else. For a screen of its own, end the program and start it with “bodydrive serve --lan”.
api-this-machine-only = This program serves this machine alone: end it, and start it with “bodydrive serve --lan”.
api-only-tablet-page = Over http there is only the page that explains how to connect: open / at this address.
api-own-certificate = This clinic has a certificate of its own: there is nothing to install.

## Driving

api-far = The chair is set in motion only from a screen in the building, connected without anything in between: go to the chair, and open the page there.
api-another-controller = Somebody else started this, and only that person can go on with it or end it here. You can stop it, and ask.
api-no-picture = This screen has no picture, and nobody drives blind: wait until the 3D view is there, or choose the drawn plan on the Drive page.
api-no-picture-for-patient = The patient's screen has no picture, and nobody drives blind: wait until it has one, or unpair that screen.
api-patients-screen-away = The patient's screen, which this trial uses, is out of reach: bring it back, or unpair it, then tap Continue.
api-process-restarting = The control process is being restarted.
api-controls-changed = The controls, or the chair's document, were changed meanwhile: read again what applies, then arm.
api-not-in-view = This screen has not said yet that it is in view: wait a moment, then arm again.
api-trial-on-real-chair = A real chair is chosen: choose the virtual one for a trial.
# $name is the name of a path in the program.
api-no-path = This floor plan has no path '{ $name }': choose one of the list.
api-no-view = There is no 3D view while no session is open: open one first.

## Calibration and controls

# Title of the last step of a calibration.
api-result = Result
api-result-instruction = Look at each joint. Repeat what is not good enough, then tap “{ result-accept }”.
api-calibration-busy = A step is being recorded, or the calibration is being worked out: wait for its end.
api-calibration-in-use = This calibration is in use already: go on to the controls, or repeat a step.
# Begins a sentence on what is wrong in a set of controls.
api-the-controls = The controls

## Review

api-replay-while-driving = Somebody drives: choose Plan, or wait until the drive is over.
api-no-replay = There is no picture of this trial: its recording cannot be read, or names no place.
api-replay-closed = This replay was closed: open it again.
api-trial-still-running = This trial is still running: look at it when it has ended.
api-recording-unreadable = The recording of this trial cannot be read: restore it from a backup.
# Follows the name of what was sent. $measures are names of measures in the program.
api-no-measure = is no measure: choose one of { $measures }
api-trials-not-comparable = These two trials differ in their patient, task or source, so neither is called better.

## Floor plans and objects

# $problem says what is wrong in the file of the plan, and what to do, without a full stop.
api-plan-unusable = The floor plan '{ $name }' cannot be used: { $problem }. Then save or import it again.
api-no-plan = There is no floor plan '{ $name }': choose one of the list.
# Begins a sentence on what is wrong in a floor plan.
api-the-plan = The floor plan
# $problem is a sentence without its full stop: what is wrong, and what to do.
api-problem = { $problem }.
api-plan-too-many-parts = The floor plan has more than { NUMBER($count, useGrouping: 1) } points and objects: make it simpler.
api-plan-other-name = The floor plan, name: it is not '{ $name }' as in the address: correct it.
api-plan-unreadable = This floor plan can no longer be read: draw it anew.
api-options-not-json = The import, options: this is not JSON: correct it.
# $endings are endings of file names.
api-wrong-plan-file = '{ $name }' is none of these: { $endings }. Save it as one of them, then add it again.
api-plan-too-large = '{ $name }' is larger than { $megabytes } MB: make it smaller, then add it again.
api-map-too-large = '{ $name }' is larger than 100 kB: make it smaller, then add it again.
api-map-incomplete = A ROS map is two files: choose its .yaml and its picture together.
api-map-picture-alone = A .pgm picture belongs to a map: choose its .yaml file as well.
api-one-plan-at-a-time = One floor plan is made at a time: choose one file, or a map's two.
api-no-glb = '{ $name }' is no GLB file: export the object as glTF binary (.glb).
api-glb-too-large = '{ $name }' is larger than { $megabytes } MB: make the object simpler.
api-too-many-objects = There are { $count } objects already: delete some in the folder 'models'.

## Files of signals and bodies

api-wrong-upload = '{ $name }' is not a CSV or Parquet file: save it as one of these, then add it again.
api-upload-too-large = '{ $name }' is larger than { $megabytes } MB: cut it, or save it as Parquet.
api-upload-empty = '{ $name }' is empty: choose another file.
# Begins a sentence on what is wrong in what a person has corrected.
api-the-import = The import
# A choice among joints: of channels whose names say no part of the body.
api-joint-body = Body, as one joint
api-one-recording = One recording is imported at a time: choose one file, or that of BIDS-motion with its _channels.tsv and _motion.json.
# $count is a count of numbers in the file.
api-upload-columns = '{ $name }' has no column of times (t) with channels beside it, or more than { NUMBER($count, useGrouping: 1) } numbers: a row above the numbers must name the time and each channel.
# $problem is the reason that the operating system gives.
api-upload-not-kept = '{ $name }' cannot be kept ({ $problem }): free some disk space, then add it again.

## This computer

api-measuring-while-busy = A chair is armed or something is recorded, and measuring takes time from the control loop: measure when that is over.
api-measuring-interrupted = A chair was armed or a recording began, so the measuring ended, because it takes time from the control loop: measure again when that is over.
api-measuring-already = This computer is being measured already: wait until that is over.
api-measuring-failed = This computer could not be measured: try again, or run 'bodydrive check' on it to see why.
# The name of a screen: begins a sentence on how many pictures a second it draws. $name is the name of a person.
api-page-of = The page of { $name }
# The name of a screen: begins a sentence on how many pictures a second it draws.
api-patients-screen = A patient's screen
