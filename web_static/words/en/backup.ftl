### Texts of the owner's page "Backup": backups, deleted patients, incidents.

rail-backup = Backup
backup-lead = Copies of everything in this clinic on another disk, and what becomes of deleted patients.
backup-settings-go = Look at the backups
backup-owner = Only an owner can manage the backups: ask an owner.
backup-state-title = Backups
backup-last = The last good backup is of { $when }. All of it was read back.
backup-now = Back up now
backup-store = Copying: { $done } of { $total }
backup-verify = Reading back: { $done } of { $total }
backup-begins = The backup begins. The database is copied first.
backup-progress = How much of this step is done
backup-done = The backup is done.
backup-failed = The backup failed.
backup-while = You may go on working and driving meanwhile.
backup-list = The newest backups
backup-good = Good
backup-bad = Failed
backup-of =
    { $files ->
        [one] { $files } file
       *[other] { $files } files
    }, { $size }, { $encrypted ->
        [yes] encrypted
       *[no] not encrypted
    }, { $keys ->
        [yes] with keys
       *[no] without keys
    }
backup-place = Every night
backup-folder = Folder
backup-folder-hint = On a stick or a network drive, for example /media/backup. Empty: no backups.
backup-hour = From this hour on
backup-encrypted = Encrypt with a passphrase
backup-passphrase = Passphrase
backup-passphrase-new = At least { $count } characters. Keep it outside this clinic: without it nobody can restore.
backup-passphrase-kept = A passphrase is set. Leave this empty to keep it.
backup-with-keys = Back up the keys of chairs, shirts and clinic, too
backup-kept = The last { $daily } daily, { $weekly } weekly and { $monthly } monthly backups are kept. A recording that is in several backups is stored only once.
backup-save = Save
backup-saved = Saved.
deleted-title = Deleted patients
deleted-lead = Everything of a deleted patient is hidden at once, and erased after { $days } days. Older backups still hold it. In the folder they are replaced within 6 months; backups that were saved as single files must be deleted by you.
deleted-none = Nobody was deleted.
deleted-left =
    { $count ->
        [one] erased in { $count } day
       *[other] erased in { $count } days
    }
deleted-due = erased within the hour
deleted-what =
    { $count ->
        [one] { $count } recording
       *[other] { $count } recordings
    }
deleted-undo = Undo
deleted-undo-label = Undo the deletion of { $code }
deleted-undone = { $code } is back.
deleted-erase = Erase now
deleted-erase-label = Erase now: { $code }
deleted-erase-title = Erase { $code } for good?
deleted-erase-lead = Sessions, calibrations, trials and recordings go at once. This cannot be undone.
deleted-erase-go = Erase for good
deleted-erased = { $code } was erased.
deleted-reason = Reason
deleted-reason-hint = The reason is kept in the log. Do not write names.
deleted-reason-go = Delete for this reason
records-title = How long records are kept
records-years = Years after the last session
records-years-hint = Ask what the law says where you are. Deleting earlier asks for a reason. Empty: nothing is set.
incidents-title = Incidents
incidents-lead = The command “bodydrive incident” makes a signed archive of the last 24 hours, and marks the patients in it. A marked patient is not erased until you lift the mark.
incidents-none = No incident was archived.
incidents-of = { $when }, fingerprint { $hash }
incidents-patients =
    { $count ->
        [one] { $count } patient
       *[other] { $count } patients
    }
incidents-lift = Lift the mark
incidents-lift-label = Lift the mark of the incident of { $when }
incidents-lifted = Lifted { $when }: { $reason }
incidents-key = Fingerprint of the key that signs
