### Texts about files of signals (CSV or Parquet): what is wrong with one, and what was mended. Most begin with the name
### of a file, or with a place in it (signals-line, signals-row), and have no full stop.

## Places, and lists of names

signals-line = { $file }, line { $line }
signals-row = { $file }, row { $row }
# layout: a field of the file, not translated.
signals-layout-place = { $file }, layout
# The end of a list of names that is too long.
signals-names-more = { $names } and { $count } more

## Files and columns

signals-file-missing = { $file }: there is no such file, check its name
# reason: what the operating system says of it, in its own language.
signals-file-unreadable = { $file }: this file cannot be read ({ $reason }), check it
signals-folder = { $file }: this is a folder, name a file in it
signals-device = { $file }: this is a device or a pipe, name an ordinary file
signals-no-rows = { $file }: there is no row below the header, record again or name another file
signals-no-csv = { $file }: this is not a CSV file but something binary or not in UTF-8, save it as CSV in UTF-8 or as Parquet
signals-csv-unreadable = { $file }: this CSV file cannot be read ({ $reason }), save it anew
signals-no-parquet = { $file }: this is not a Parquet file, save it as one or give it the name of a CSV
signals-parquet-damaged = { $file }: this Parquet file was cut or changed and cannot be read, save it anew
signals-numbers = { $file }: this holds more than { NUMBER($most, useGrouping: 1) } numbers, cut it into shorter recordings
signals-empty = { $file }: this file is empty (or begins with an empty line), name another one
signals-line-ends = { $file }: its lines end in carriage returns alone, save the file with other line ends
signals-column-missing = { $file }: there is no column '{ $column }' (there are { $names }), add it
signals-columns-missing = { $place }: none of the columns { $names } is there, only { $there }, add them or name another file
signals-columns-twice = { $place }: there are two columns '{ $column }', rename one of them
signals-column-unnamed = { $place }: column { $number } has no name, give it one
# kind: the name of a type of data, not translated.
signals-column-type = { $file }: column '{ $column }' holds { $kind } and not numbers, leave it out or convert it
signals-no-number = { $place }: '{ $column }' has no number there, fill it in
signals-cells =
    { $count ->
        [one] { $place }: { $count } cell where the header has { $expected }, correct or remove this line
       *[other] { $place }: { $count } cells where the header has { $expected }, correct or remove this line
    }
signals-not-a-number = { $place }, column '{ $column }': '{ $cell }' is not a number, write one or leave the cell empty
# separator: what stands between two columns; decimal: the sign of a decimal number.
signals-dialect =
    { $separator ->
        [semicolons] { $decimal ->
            [comma] It was read with semicolons between columns and decimal commas.
           *[point] It was read with semicolons between columns and decimal points.
        }
        [tabs] { $decimal ->
            [comma] It was read with tabs between columns and decimal commas.
           *[point] It was read with tabs between columns and decimal points.
        }
       *[commas] { $decimal ->
            [comma] It was read with commas between columns and decimal commas.
           *[point] It was read with commas between columns and decimal points.
        }
    }

## Channels. “t” is the name of the column of times.

signals-no-channel = { $file }: there is no channel beside 't', add a column per channel
signals-channels = { $file }: { $count } channels are more than a shirt can have, keep at most { $most }
signals-channel-named-t = { $file }: the layout '{ $layout }' has a channel 't', which is the time: rename the channel
# names: one name or several.
signals-channel-missing = { $file }: channel { $names } of the layout '{ $layout }' is not in this recording, add the column or use the layout of the shirt that was recorded
signals-samples-few =
    { $count ->
        [one] { $file }: { $count } sample is too few for a signal, record at least a few seconds
       *[other] { $file }: { $count } samples are too few for a signal, record at least a few seconds
    }
signals-frames-few =
    { $count ->
        [one] { $file }: { $count } frame is too few for a signal, name a longer recording.
       *[other] { $file }: { $count } frames are too few for a signal, name a longer recording.
    }
signals-run-without-layout = { $file }: the recording does not say which shirt it is of.
signals-layout-missing = { $file }: there is no such layout, check its name
signals-layout-unreadable = { $file }: this layout cannot be read ({ $reason }), check it

## Times, in the column t

signals-time-large = { $file }: t goes from { $first } to { $last }, give the time in seconds
signals-time-constant = { $file }: t is { $time } in every row, give the time of each sample in seconds
signals-time-backwards = { $place }: time runs backwards there (t = { $after } after { $before }), sort the rows or remove the part that was recorded twice
signals-time-jumps = { $place }: t jumps there by { $seconds } s ({ $hours } hours), keep the part before or after it, or correct the column t
signals-rate-changes = { $place }: the sample rate changes there (t = { $time } s), cut the file into parts of one rate each
signals-uneven = { $file }: t rises by { $least } to { $most } s from row to row, without an even sample rate: export the device's own time of each sample, or resample the file to an even rate
# Several samples have one time, that of their arrival, or their times come in groups.
signals-shared-uneven =
    { $shared ->
        [one] { $file }: { NUMBER($shared, useGrouping: 1) } of { NUMBER($count, useGrouping: 1) } samples has the time of the sample before, and their number differs from time to time, so that the sample rate is unknown: export the device's own time of each sample, in seconds
       *[other] { $file }: { NUMBER($shared, useGrouping: 1) } of { NUMBER($count, useGrouping: 1) } samples have the time of the sample before, and their number differs from time to time, so that the sample rate is unknown: export the device's own time of each sample, in seconds
    }
signals-shared-spread =
    { $shared ->
        [one] { NUMBER($shared, useGrouping: 1) } of { NUMBER($count, useGrouping: 1) } samples has the time of the sample before: all were spread evenly, at { $rate } Hz.
       *[other] { NUMBER($shared, useGrouping: 1) } of { NUMBER($count, useGrouping: 1) } samples have the time of the sample before: all were spread evenly, at { $rate } Hz.
    }
signals-bursts-uneven = { $file }: the samples come in bursts, stamped when they arrived, and their number differs from time to time, so that the sample rate is unknown: export the device's own time of each sample, in seconds
signals-bursts-spread = The samples come in bursts, stamped when they arrived: they were spread evenly, at { $rate } Hz.
signals-steps-spread = The steps of t differ, though the samples are even: they were spread evenly, at { $rate } Hz.
signals-gaps =
    { $count ->
        [one] There is { NUMBER($count, useGrouping: 1) } gap between the samples, of { $longest } s, before { $place }.
       *[other] There are { NUMBER($count, useGrouping: 1) } gaps between the samples, the longest of { $longest } s, before { $place }.
    }

## Times in another unit than seconds. step: by how much t rises.

signals-unit-counter = { $file }: t must be in seconds, but it rises by { $step } from row to row, which looks like a counter of samples: divide the column t by the sample rate in Hz
signals-unit =
    { $unit ->
        [milliseconds] milliseconds ({ $rate } Hz)
        [microseconds] microseconds ({ $rate } Hz)
        [nanoseconds] nanoseconds ({ $rate } Hz)
        [minutes] minutes ({ $rate } Hz)
        [hours] hours ({ $rate } Hz)
       *[days] days ({ $rate } Hz)
    }
# unit: a text signals-unit.
signals-unit-other = { $file }: t must be in seconds, but it rises by { $step } from row to row, which looks like { $unit }: multiply the column t by { $factor }
signals-unit-one-of-two = { $file }: t must be in seconds, but it rises by { $step } from row to row, which looks like { $unit } or { $or_unit }: multiply the column t by { $factor } or { $or_factor }
signals-unit-or-slow = { $file }: t must be in seconds, but it rises by { $step } from row to row, which looks like another unit, or samples taken too slowly: write it in seconds, and record at { $slowest } to { $fastest } Hz
signals-unit-or-fast = { $file }: t must be in seconds, but it rises by { $step } from row to row, which looks like another unit, or samples taken too fast: write it in seconds, and record at { $slowest } to { $fastest } Hz
# span, rate: of the recording if t is in seconds; span_of_minutes (s), rate_of_minutes (Hz): if it is in minutes.
signals-unit-minutes = { $file }: t must be in seconds, but it rises by { $step } from row to row, which looks like minutes ({ $span_of_minutes } s at { $rate_of_minutes } Hz) and not { $span } s at { $rate } Hz: multiply the column t by 60, or record more than { $brief } s
