### Texts of the export of a patient's recordings and measures, and of the import of an archive.

export-title = Export for other programs
export-lead = Recordings and measures as one zip file. It names the patient by the code, and says what was simulated.
export-form = Form
export-form-csv = CSV: opens in a spreadsheet
export-form-parquet = Parquet: for Python and R
export-form-xdf = XDF: for laboratories that measure movement
export-form-bids = BIDS-motion: for archives of research data
export-form-fhir = FHIR: measures for a hospital's records
export-form-archive = Archive: everything, for another clinic with bodydrive
export-what = Sessions
export-all = All sessions
export-session = Session { $number }
export-go = Export
export-go-label = Export of { $code }
export-wait = Long recordings take a minute or more. The log keeps who exported what.
export-progress = How much of the export is packed
export-begun = The export begins.
export-state-going-on = Recordings packed: { $packed } of { $recordings }. Sent: { $size }.
export-state-complete = The export is complete: { $size }.
export-state-broken-off = The export was broken off, and the file is not complete: export again.
export-csv-how = Columns are separated by commas, and numbers have a decimal point. A spreadsheet that writes a decimal comma asks how to open the file: choose UTF-8 and English there.
export-archive-how = The recordings take { $size }. An owner of the other clinic imports the file on its Patients page.
export-archive-open = A session of this patient is open: end it first, then make the archive.
export-consent = An export needs the patient's consent to sharing outside: ask, and enter it above.
import-go = Import an archive
import-under-way = { $name } is being sent and checked. Large recordings take minutes; leave this page open.
import-progress = How much of this step is done
import-send = Sending: { $done } of { $total }
import-unpack = Checking and unpacking: { $done } of { $total }
import-done =
    The patient { $code } is imported: { $sessions ->
        [one] { $sessions } session
       *[other] { $sessions } sessions
    }, { $trials ->
        [one] { $trials } trial
       *[other] { $trials } trials
    }.
import-replace = Replace the patient
import-kept = Everything of this patient that is here is replaced by what the archive has. An archive of the patient as it is now is made first, and kept for 30 days.
import-replaced =
    { $code } is replaced: { $sessions ->
        [one] { $sessions } session
       *[other] { $sessions } sessions
    }, { $trials ->
        [one] { $trials } trial
       *[other] { $trials } trials
    }. The patient as it was is kept for 30 days in the clinic's folder: replaced/{ $kept }.
import-known = { $code } was imported from this archive before: nothing was changed.
