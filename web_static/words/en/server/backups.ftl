### Texts about backups of a clinic, about restoring one, and about incident files.

backups-warning-folder-gone = The folder of the backups is not there: connect the disk or network drive it lies on.
backups-warning-none = There is no good backup yet: choose a folder on another disk, then make one.
# $days: 3 or more.
backups-warning-old = The last good backup is { $days } days old: the list of backups says why; make one now.

backups-no-folder = No folder is chosen: choose one first.
backups-folder-relative = Give the whole path of the folder, beginning with /.
backups-folder-inside = This folder lies in the clinic's own folder, or holds it: choose one on another disk.
backups-folder-gone = The folder { $folder } is not there: connect the disk it lies on.
backups-folder-gone-choose = The folder { $folder } is not there: connect the disk it lies on, or choose another.
# $problem: what the operating system says, in its language.
backups-folder-not-writable = The folder { $folder } cannot be written ({ $problem }): choose another one.
backups-header-missing = { $folder } holds backups, but its file { $file } is missing: choose another folder.
backups-header-unreadable = { $folder } is no folder of backups: its file { $file } cannot be read.
backups-of-other-clinic = { $folder } holds the backups of another clinic: choose a folder of its own for this one.
backups-of-other-passphrase = { $folder } holds backups with another passphrase, or without one: use what that folder was made with, or choose an empty folder.

backups-passphrase-short = Give a passphrase of at least 8 characters.
backups-wrong-passphrase = The passphrase is wrong, or the file was changed: give the passphrase with which it was made.
# HOW-TO-OPEN.txt is a file in the backup, in English.
backups-passphrase-slow = This computer is too slow or too busy for the passphrase: close other programs and try again, or follow HOW-TO-OPEN.txt in the backup.

backups-busy = A backup is being made: wait until it is done.
backups-under-way = A backup is being made already: wait until it is done.
backups-other-under-way = Another backup of this clinic is being made: wait until it is done.
backups-process-ended = The process that makes the backup has ended: look at the disks, then try again.
# $problem: what the operating system or a library says, in its language.
backups-failed = The backup could not be made ({ $problem }): look at the disks, then try again.
# $problem: what the operating system says, in its language. $place: a file or folder.
backups-failed-at = The backup could not be made ({ $problem }: { $place }): look at the disks, then try again.
# A recording is left out while it is being made.
backups-left-out =
    { $recordings ->
        [one] One recording was going on and left out: the next backup holds it.
       *[other] { $recordings } recordings were going on and left out: the next backup holds them.
    }
backups-changed-meanwhile = { $file } was changed while it was copied: try again.
backups-file-there = There is a file { $file } already: choose another name.
backups-no-folder-for-file = There is no folder { $folder }: make it, or choose another place.
backups-no-clinic = There is no clinic in { $folder }: give its folder with --state.
backups-not-set-up = The clinic in { $folder } is not set up yet: open its pages first.
backups-unequal = The backup { $file } reads back wrongly: this disk is damaged, take another.
backups-unequal-in-folder = The backup in { $folder } reads back wrongly: this disk is damaged, take another.
# $files: how many.
backups-parts-unequal =
    { $files ->
        [one] { $files } file in { $folder } reads back wrongly: this disk is damaged, take another.
       *[other] { $files } files in { $folder } read back wrongly: this disk is damaged, take another.
    }

# A backup, or an incident file.
backups-damaged = This file is damaged or was cut off: take another one.
backups-part-damaged = This backup is damaged: { $file } is missing or was changed. Take another one.
backups-none = This is no backup of bodydrive, or it was changed: take another one.
backups-other-version = This backup was made by another version of bodydrive: restore it with that version.
# $folder: into which a backup is to be restored. $found: a file or folder in it. $kept: the name of a file.
backups-not-empty = { $folder } is not empty, it holds { $found }: restore into an empty folder. Of a clinic that was there before, leave only { $kept }.
backups-restored-unequal = { $file } is not equal to what was backed up: take another backup, or another disk.

backups-incident-other-key = Another key than the given one has signed this incident file: ask where it comes from.
backups-incident-wrong-signature = The signature of this incident file is wrong: it was changed after it was made.
backups-incident-changed = { $file } in this incident file was changed, or is missing.
