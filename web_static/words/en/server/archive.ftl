### Texts about the archive of a patient: one file, by which a patient's records come from one clinic to another.
### Where a text begins with { $file }:, the pages leave these first words out.

archive-session-here = A session of this patient is open: end it first, then make the archive.

archive-none = { $file }: this is no archive of bodydrive, or it was cut: name another file.
# $name: of a file within the archive.
archive-changed = { $file }: '{ $name }' in the archive was changed or cut, and nothing was imported: copy the archive again.
# $schema: a whole number.
archive-newer = { $file }: this archive was made by a newer bodydrive (schema { $schema }), and nothing was imported: update this one.
# $why: one of the clauses below.
archive-wrong = { $file }: this archive cannot be read, because { $why }; nothing was imported.
archive-code-taken = The code '{ $code }' belongs to another patient of this clinic, and nothing was imported: give that patient another code, then import again.
archive-recordings-here = Recordings of this archive belong to another patient of this clinic, and nothing was imported: look for that patient in the list of patients, or under “{ deleted-title }” on the page “{ rail-backup }”.
archive-patient-here = { $code } is in this clinic already, and nothing was imported: replace that patient, or leave it as it is.
archive-session-open = A session of { $code } is open here, and nothing was imported: end it first, then import again.
# $made: a date.
archive-incident = { $code } is part of the incident of { $made } and must not be replaced: an owner lifts the mark of the incident first.
# $until: a date.
archive-records-kept = Sessions of { $code } were held in this clinic, and their records must be kept until { $until }: the patient cannot be replaced, and nothing was imported.

## Clauses that say why an archive cannot be read: each stands in archive-wrong as $why. “Its” is “of the archive”.
## $row: the number of a row. $table, $column, $field: names in the file, which stay as they are.

archive-memory = it needs too much memory
# $problem: a sentence without a full stop.
archive-text-refused = a text in it is refused: { $problem }
archive-recording-names = its recordings have wrong names
archive-recording-unnamed = it has a recording that no row names
archive-recording-channels = the recording '{ $recording }' has other channels than its layout
archive-recording-gestures = the recording '{ $recording }' has other gestures than it names
# $problem: archive-field, or what a library says, in English.
archive-recording-field = in the recording '{ $recording }', { $problem }
archive-recording-unreadable = the recording '{ $recording }' cannot be read
archive-comment-without-author = a comment in it has no author
archive-other-tables = its tables are others
archive-other-columns = the columns of its table '{ $table }' are others
archive-rows-most = it has more than { NUMBER($most, useGrouping: 1) } rows
archive-one-patient = it has not exactly one patient
archive-session-not-ended = one of its sessions has not ended
archive-row-contradicts = row { $row } of its table '{ $table }' contradicts another one
# $problem: archive-field, or what a library says, in English.
archive-row-field = in row { $row } of its table '{ $table }', { $problem }
# $problem: archive-date, another text without a full stop, or what a library says, in English.
archive-field = '{ $field }' is wrong ({ $problem })
archive-date = this is no date between 1970 and 2200
archive-value-empty = row { $row } of its table '{ $table }', column '{ $column }', is empty
archive-value-type = row { $row } of its table '{ $table }', column '{ $column }', has another type
archive-value-long = row { $row } of its table '{ $table }', column '{ $column }', is too long
archive-value-place = row { $row } of its table '{ $table }', column '{ $column }', is not { $row }
archive-value-refers = row { $row } of its table '{ $table }', column '{ $column }', refers to a row that is not there
archive-value-date = row { $row } of its table '{ $table }', column '{ $column }', is no date
archive-map-from = row { $row } of its table 'profile' comes from a version that is not there
archive-map-back = row { $row } of its table 'profile' does not say which version it goes back to
archive-controls-map = in row { $row } of its table 'parameters', 'profile_id' refers to a row that is not there
archive-controls-current = in row { $row } of its table 'parameters', 'current' is wrong, because another set of controls is the current one
