### Texts about the check of the log, which says who did what when. Its rows form a chain. The head is a file beside the
### database that says how many rows the log has: rows that were removed from its end are noticed by it.

logs-whole =
    { $rows ->
        [one] The log is whole: { $rows } row, not edited, moved, put in or removed.
       *[other] The log is whole: { $rows } rows, none edited, moved, put in or removed.
    }
# $rows: how many, 1 or more. It follows on logs-whole.
logs-head-behind =
    { $rows ->
        [one] The newest row is not in its head yet: the program ended just then, or it writes now.
       *[other] The newest { $rows } rows are not in its head yet: the program ended just then, or it writes now.
    }
# $row: the number of a row, $day: its date. It follows on logs-whole or logs-head-behind.
logs-head-begun = A removal of newest rows is noticed from row { $row } on, of { $day }.
# Two of these sentences, one after the other.
logs-sentences = { $first } { $second }
logs-empty = The log is empty.
# $row: the number of a row.
logs-row-changed = The log was changed: row { $row } was edited, moved or put in, or rows before it were removed. Archive the state of this computer with “bodydrive incident FILE”, and compare the log with that of a backup.
# $left, $rows: how many.
logs-newest-removed = The log was changed: its newest rows were removed, { $left } of { $rows } are left. Archive the state of this computer with “bodydrive incident FILE”, and compare the log with that of a backup.
# $rows: how many.
logs-rows-exchanged =
    { $rows ->
        [one] The log was changed: its first row is not the row that was written. Archive the state of this computer with “bodydrive incident FILE”, and compare the log with that of a backup.
       *[other] The log was changed: its first { $rows } rows are not the rows that were written. Archive the state of this computer with “bodydrive incident FILE”, and compare the log with that of a backup.
    }
logs-head-missing = The head of the log is missing beside the database: rows may have been removed from the log's end. Archive the state of this computer with “bodydrive incident FILE”, and compare the log with that of a backup.
