### Texts about files of signals (CSV, Parquet and other kinds): what is wrong with one, and what was mended. Most begin with the name
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
signals-no-csv = { $file }: this is not a CSV file but something binary, save it as CSV or as Parquet
signals-no-parquet = { $file }: this is not a Parquet file, save it as one or give it the name of a CSV
signals-parquet-damaged = { $file }: this Parquet file was cut or changed and cannot be read, save it anew
# kind: the name of a format, such as C3D; library, extra: names of parts of programs. None is translated.
signals-library-missing = { $file }: { $kind } files need the library { $library }, install it with pip install 'bodydrive[{ $extra }]', or save the file as CSV
signals-foreign-damaged = { $file }: this { $kind } file is damaged, or of an unknown form, save it anew or as CSV
signals-foreign-empty = { $file }: this { $kind } file holds no signals, name another one
signals-variables-left-out = Variables of another length were left out: { $names }.
signals-streams-left-out = Streams without numbers were left out: { $names }.
# sheet: the name of a sheet of a workbook; names: those of others.
signals-sheet-read = The sheet { $sheet } was read; these others were left out: { $names }.
# count: 2 or more, parts of a recording between which nothing was recorded.
signals-blocks-left-out = The file has { $count } blocks; the first one was read.
# part: the name of a stream or of a sheet.
signals-part-missing = { $file }: there is no part '{ $part }' (there are { $names }), name one of these
signals-matlab-objects = { $file }: its tables are in a form that only MATLAB reads, save them with writetable as CSV
signals-topics-left-out = The places are those of the topic { $topic }; these others were left out: { $names }.
signals-places-several = { $file }: several columns can be the place ({ $names }), call the right ones x and y
signals-kitti-times = { $file }: poses in the form of KITTI have no times, lay times.txt with { $count } times beside it, or give the sample rate
signals-numbers = { $file }: this holds more than { NUMBER($most, useGrouping: 1) } numbers, cut it into shorter recordings
signals-empty = { $file }: this file is empty, name another one
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
signals-no-numbers = { $file }: there is no table of numbers in this file, name another one
signals-line-cut = The last line was cut and is left out ({ $place }).
signals-table-further = Another table begins at { $place } and is left out.
signals-columns-left-out = Columns without numbers that change were left out: { $names }.
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
        [bars] { $decimal ->
            [comma] It was read with vertical bars between columns and decimal commas.
           *[point] It was read with vertical bars between columns and decimal points.
        }
        [blanks] { $decimal ->
            [comma] It was read with blanks between columns and decimal commas.
           *[point] It was read with blanks between columns and decimal points.
        }
       *[commas] { $decimal ->
            [comma] It was read with commas between columns and decimal commas.
           *[point] It was read with commas between columns and decimal points.
        }
    }

## Channels. column: the name of the column of times, often “t”.

signals-no-channel = { $file }: there is no channel beside '{ $column }', add a column per channel
signals-channels = { $file }: { $count } channels are more than a shirt can have, keep at most { $most }
signals-channel-named-t = { $file }: the layout '{ $layout }' has a channel '{ $column }', which is the time: rename the channel
# names: one name or several.
signals-channel-missing = { $file }: channel { $names } of the layout '{ $layout }' is not in this recording, add the column or use the layout of the shirt that was recorded
signals-channels-count = { $file }: { $count } columns were named for the { $expected } channels of the layout '{ $layout }', name one for each channel in their order
# pairs: such as “A = Strain A [mV]”.
signals-channels-taken = These channels have columns of other names: { $pairs }.
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

## Times. column: the name of their column, often “t”.

# names: the columns that there are.
signals-time-missing = { $file }: there is no column 't' and no other one of times (there are { $names }), add one in seconds
# units: a list of texts signals-time-unit; unit: the first of them.
signals-time-units = { $file }: '{ $column }' rises by { $step } from row to row, which can be { $units }: write the unit into its name, such as '{ $column } ({ $unit })'
signals-time-unit =
    { $unit ->
        [ms] milliseconds ({ $rate } Hz)
        [us] microseconds ({ $rate } Hz)
        [ns] nanoseconds ({ $rate } Hz)
       *[s] seconds ({ $rate } Hz)
    }
signals-time-read =
    { $unit ->
        [ms] The times are those of the column '{ $column }', in milliseconds.
        [us] The times are those of the column '{ $column }', in microseconds.
        [ns] The times are those of the column '{ $column }', in nanoseconds.
        [min] The times are those of the column '{ $column }', in minutes.
        [h] The times are those of the column '{ $column }', in hours.
        [d] The times are those of the column '{ $column }', in days.
       *[s] The times are those of the column '{ $column }', in seconds.
    }
signals-time-wraps =
    { $count ->
        [one] The clock of '{ $column }' began again at 0, { $count } time, and its times go on there.
       *[other] The clock of '{ $column }' began again at 0, { $count } times, and its times go on there.
    }
# A person has said that no column of the file is right as the time.
signals-rate-needed = { $file }: without a column of times its sample rate is unknown, give it in Hz
# rate: given by a person.
signals-rate-set = The samples count as even, at { $rate } Hz.
signals-rate-beyond = { $file }: its sample rate is { $rate } Hz, record at { $slowest } to { $fastest } Hz
# found: the sample rate by the column.
signals-rate-wrong = { $file }: the sample rate is given as { $rate } Hz, but by the column '{ $column }' it is { $found } Hz, give that one, or name the unit of the column
signals-time-large = { $file }: { $column } goes from { $first } to { $last }, give the time in seconds
signals-time-constant = { $file }: { $column } is { $time } in every row, give the time of each sample in seconds
signals-time-backwards = { $place }: time runs backwards there ({ $column } = { $after } after { $before }), sort the rows or remove the part that was recorded twice
signals-time-jumps = { $place }: { $column } jumps there by { $seconds } s ({ $hours } hours), keep the part before or after it, or correct the column { $column }
signals-rate-changes = { $place }: the sample rate changes there ({ $column } = { $time } s), cut the file into parts of one rate each
signals-uneven = { $file }: { $column } rises by { $least } to { $most } s from row to row, without an even sample rate: export the device's own time of each sample, or resample the file to an even rate
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
signals-steps-spread = The steps of { $column } differ, though the samples are even: they were spread evenly, at { $rate } Hz.
signals-gaps =
    { $count ->
        [one] There is { NUMBER($count, useGrouping: 1) } gap between the samples, of { $longest } s, before { $place }.
       *[other] There are { NUMBER($count, useGrouping: 1) } gaps between the samples, the longest of { $longest } s, before { $place }.
    }

## Times in another unit than seconds. step: by how much t rises.

signals-unit-counter = { $file }: { $column } must be in seconds, but it rises by { $step } from row to row, which looks like a counter of samples: divide the column { $column } by the sample rate in Hz
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
signals-unit-other = { $file }: { $column } must be in seconds, but it rises by { $step } from row to row, which looks like { $unit }: multiply the column { $column } by { $factor }
signals-unit-one-of-two = { $file }: { $column } must be in seconds, but it rises by { $step } from row to row, which looks like { $unit } or { $or_unit }: multiply the column { $column } by { $factor } or { $or_factor }
signals-unit-or-slow = { $file }: { $column } must be in seconds, but it rises by { $step } from row to row, which looks like another unit, or samples taken too slowly: write it in seconds, and record at { $slowest } to { $fastest } Hz
signals-unit-or-fast = { $file }: { $column } must be in seconds, but it rises by { $step } from row to row, which looks like another unit, or samples taken too fast: write it in seconds, and record at { $slowest } to { $fastest } Hz
# span, rate: of the recording if t is in seconds; span_of_minutes (s), rate_of_minutes (Hz): if it is in minutes.
signals-unit-minutes = { $file }: { $column } must be in seconds, but it rises by { $step } from row to row, which looks like minutes ({ $span_of_minutes } s at { $rate_of_minutes } Hz) and not { $span } s at { $rate } Hz: multiply the column { $column } by 60, or record more than { $brief } s
