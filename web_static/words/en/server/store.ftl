### Texts about what a clinic stores: patients, sessions, people, chairs, screens, floor plans, the disk, the database.

store-no-patient = There is no patient { $patient }: choose one from the list of patients.
store-no-session = There is no session { $session }: choose one of the patient's list.
store-no-trial = There is no trial { $trial }: choose one from the list of trials.
store-no-drive = There is no drive { $drive }: choose one from the list of drives.
store-no-chair = There is no chair { $chair }: choose one of the list, or pair it first.
store-no-screen = There is no paired screen { $screen }: choose one of the list.
store-no-person = There is no person { $person }: choose one of the list.
store-nobody-called = There is nobody called '{ $name }': see the list of people.
store-no-incident = There is no incident { $incident }: look at the list.
store-no-deleted-patient = There is no deleted patient { $patient }: look at the list.
store-no-set = There is no saved set '{ $title }': choose one from the list.
store-no-plan = There is no floor plan '{ $name }' of your own: choose one of the list.
store-no-deleted-plan = There is no deleted floor plan '{ $name }': look at the list.
store-no-replaced-file = There is no such replaced file, or its 30 days are over: look at the list.

store-code-taken = The code '{ $code }' already belongs to { $pseudonym }: choose another code.
store-code-deleted = The code '{ $code }' belongs to a deleted patient: choose another code, or let an owner undo the deletion on the page “{ rail-backup }”.
store-patient-here = The patient { $pseudonym } has an open session: end it first, then delete the patient.
# $time: a time of day.
store-session-open =
    { $trials ->
        [one] A session of { $code } is open: begun at { $time }, { $trials } trial. End it first, or confirm that the new session ends it.
       *[other] A session of { $code } is open: begun at { $time }, { $trials } trials. End it first, or confirm that the new session ends it.
    }
# $person: the name of the person who began the session. $time: a time of day.
store-session-open-by =
    { $trials ->
        [one] A session of { $code } is open: begun by { $person } at { $time }, { $trials } trial. End it first, or confirm that the new session ends it.
       *[other] A session of { $code } is open: begun by { $person } at { $time }, { $trials } trials. End it first, or confirm that the new session ends it.
    }
store-trial-running = This trial is still running: end it first.

store-no-consent =
    { $consent ->
        [recording] { $code } has not consented to recording: ask, and enter the date under “{ record-link }”. Practice with the simulated shirt needs no consent.
        [clinic_prior] { $code } has not consented to the use for other patients of the clinic: ask, and enter the date under “{ record-link }”.
       *[sharing] { $code } has not consented to sharing outside the clinic: ask, and enter the date under “{ record-link }”.
    }

store-person-name-taken = There is already somebody called '{ $name }': choose another name to sign in with.
store-last-owner = No other owner than { $name } can sign in, so { $name } must remain an owner: make somebody else an owner first.
store-patients-of-reviewers = Patients are chosen for reviewers only: owners and clinicians work with all of them.
# $name: of a person. The link is an invitation to choose a password.
store-invited-disabled = { $name } is disabled: enable this person first, then make a link.
store-sign-in-ended = This sign-in has ended: sign in again.

store-chair-name-taken = There is already a chair called '{ $name }': choose another name, or unpair that one first.
# A key: the secret that a chair shares with this computer.
store-keys-used-up = Every number of a key was used: begin with a new folder for the clinic.

# The code pairs a screen of the patient.
store-code-over = The session of this code has ended: ask for a new code.
store-screens-most = { $most } screens are paired already: unpair one on the clinician's page first.

store-steps-mixed = Some steps were recorded in a shirt that nobody wears, others in a worn one: begin the calibration anew, in one of them.
store-steps-mixed-sensors = Some steps were recorded with other sensors than the rest: begin the calibration anew, with one kind of sensors.
store-step-interrupted = The program was restarted during this step: repeat it.
store-not-calibrated = Nothing is calibrated yet: calibrate first, and tap “{ result-accept }”.
store-set-of-other-version = These controls were saved by another version of the program, and this one cannot read them: calibrate again, or start that version.
# $title: the name of a saved set of controls.
store-set-of-other-joints = '{ $title }' was made for a shirt with other joints and does not fit this calibration: bind the gestures anew.
store-nothing-to-undo = There is nothing to undo: this is the first setting.
store-nothing-to-redo = There is nothing to redo.
store-no-map-before = This version comes straight from a calibration: there is no version before it to go back to.

# $made: a date.
store-incident-not-erased = { $code } is part of the incident of { $made } and must not be erased: an owner lifts the mark of the incident first.
# $until: a date.
store-records-kept = The records of { $code } must be kept until { $until }: undo the deletion, then delete again with a reason.
# $until: a date.
store-records-kept-reason = The records of { $code } must be kept until { $until }: give a reason to delete them earlier.
store-incident-lifted = The mark of this incident was lifted already.
store-clock-hours =
    { $hours ->
        [one] The clock of this machine went on by { $hours } hour for which it did not run: it was set forward, or the machine was off. Nothing is erased because of that: deleted patients, replaced files and old backups stay that much longer. Check date and time.
       *[other] The clock of this machine went on by { $hours } hours for which it did not run: it was set forward, or the machine was off. Nothing is erased because of that: deleted patients, replaced files and old backups stay that much longer. Check date and time.
    }
# $days: 2 or more.
store-clock-days = The clock of this machine went on by { $days } days for which it did not run: it was set forward, or the machine was off. Nothing is erased because of that: deleted patients, replaced files and old backups stay that much longer. Check date and time.
store-erased-list-unreadable = The list of erased patients in { $file } cannot be read: put a copy of it back, from the folder of the backups or out of a backup.

store-disk-full = The disk of the recordings is full: nothing more is recorded, driven or saved. The session can still be ended, and people can sign out. Make room on the computer that runs bodydrive.
store-disk-little = Only { $free } GB are free on the disk of the recordings, and below { $needed } GB nothing is recorded or driven any more: make room.
store-disk-no-session = No session is opened: only { $free } MB are free on the disk of the recordings. Make { $needed } MB free on the computer that runs bodydrive, then open it again.
store-no-room-to-make =
    { $what ->
        [archive] There is no room for this archive: { $needed } MB must be free on the disk where it is made, and { $free } MB are. Make room, then try again; nothing was made.
       *[export] There is no room for this export: { $needed } MB must be free on the disk where it is made, and { $free } MB are. Make room, then try again; nothing was made.
    }

# $name: of a file or floor plan.
store-name-taken = There is '{ $name }' already: keep both.
# $name: of a file or floor plan.
store-name-taken-replace = There is '{ $name }' already: keep both, or replace it.
store-plan-name-bundled = The name '{ $name }' belongs to a plan that comes with the software: choose another.
store-plans-most = There are { $most } floor plans of your own already: delete some first.
store-plan-bundled-kept = A plan that comes with the software stays as it is: save yours as a new plan.
store-plan-bundled-not-deleted = A plan that comes with the software cannot be deleted.
store-plan-saved-meanwhile = Somebody else saved this floor plan meanwhile: save yours as a new plan.

store-database-held = Another program holds the database: wait for its end, then try again.
store-database-damaged = The database is damaged: put a copy of it back, or begin with a new folder.
# The write-ahead log is a file of the database, not the log of who did what.
store-erased-but-read = The erasure is done, but the database is being read, so that its write-ahead log still holds bytes of what was erased: they go when the program ends.
store-copy-unequal = The copy of the database { $database } is not equal to it: check the disk, then try again.
store-copy-no-room = There is no room for a copy of the database, which is needed before anything else: free { $needed } MB on the disk of { $folder }, then try again. Nothing was changed.
# $revision, $newest: numbers of schemas, such as 0002. $version: of this program.
store-schema-newer = The database { $database } was last opened by a newer bodydrive: its schema is { $revision }, and this program ({ $version }) knows schemas up to { $newest }. Nothing was changed: start the newer program again.
# $revision, $newest: numbers of schemas, such as 0002. $problem: the error of the database, in English. $copy: the name of a file.
store-schema-failed = The database { $database } could not be brought from schema { $revision } to { $newest } ({ $problem }). It is as it was, with a copy in { $copy }: start the program that opened it last, and report this.
