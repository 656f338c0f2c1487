### Texts of the page that imports a recording of another program.

rail-import-recording = Import a recording
import-recording-lead = A recording of another program becomes one of this program: look at what it holds, correct what is wrong, then use it.
import-recording-files = Recording
import-recording-files-hint = CSV, TSV, Parquet, Excel (XLSX), MATLAB, C3D, TRC, MOT, EDF, XDF, BVH and others, at most 64 MB. For BIDS-motion choose its _channels.tsv and _motion.json as well.
import-recording-reading = The file is being read…
import-recording-holds = What the file holds
import-recording-kind = Format
import-recording-kind-text = Table in text (CSV)
import-recording-length = Length
# $seconds is a number.
import-recording-length-words =
    { $count ->
        [one] { $seconds } s, { $count } sample
       *[other] { $seconds } s, { $count } samples
    }
import-recording-rows =
    { $count ->
        [one] { $count } row
       *[other] { $count } rows
    }
import-recording-rate = Sample rate
import-recording-rate-words = { $rate } Hz
import-recording-rate-open = Not known yet
import-recording-channels = Channels
import-recording-joints = Joints
import-recording-even = The samples are evenly spaced in time.
import-recording-correct = Correct it below: the column of times, its unit, the sample rate, or which columns are channels.
import-recording-times = Times
# A stream, or the sheet of a workbook.
import-recording-part = Part of the file
import-recording-part-all = All together
import-recording-part-largest = The largest sheet
import-recording-time = Column of times
import-recording-time-none = None: the samples are evenly spaced
import-recording-as-it-says = As the file says
import-recording-unit = Unit of the times
import-recording-unit-s = Seconds
import-recording-unit-ms = Milliseconds
import-recording-unit-us = Microseconds
import-recording-unit-ns = Nanoseconds
import-recording-unit-min = Minutes
import-recording-unit-h = Hours
import-recording-unit-d = Days
import-recording-rate-by-hand = Sample rate (Hz)
import-recording-rate-hint = Change it only where the samples are evenly spaced and the times are not right.
import-recording-channels-count = { $count } of { $all } columns are channels
import-recording-title-channel = Column
import-recording-title-unit = Unit
import-recording-title-range = Range
import-recording-title-missing = Missing
import-recording-title-joint = Joint
import-recording-range = { $least } to { $most }
import-recording-joint-of = Joint of { $name }
import-recording-none-chosen = Choose at least one channel.
import-recording-back = Back to the shirt
import-recording-store = Only store it
import-recording-use = Use it
