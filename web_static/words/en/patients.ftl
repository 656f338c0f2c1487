### Texts of the patients page.

patients-title = Who has come?
patients-lead = Patients are known here by a code and a pseudonym; no name is needed.
patients-search = Search by code or pseudonym
patients-new = New patient
patients-new-title = New patient
patients-code = Code
patients-code-hint = Letters, digits, point, dash; for example P-015.
patients-pseudonym = Pseudonym
patients-pseudonym-hint = A word that you and the patient recognise. Not the real name.
patients-note = Note
patients-note-hint = May stay empty.
patients-add = Add and start the session
patients-start = Start session
patients-go-on = Go on
patients-end = End session
patients-here = session open
patients-ends =
    A session of { $code } is open: { $name } began it at { $time }, { $trials ->
        [one] { $trials } trial
       *[other] { $trials } trials
    }. Only one session can be open.
patients-ends-somebody =
    A session of { $code } is open: begun at { $time }, { $trials ->
        [one] { $trials } trial
       *[other] { $trials } trials
    }. Only one session can be open.
patients-ends-go = End it and start { $next }
patients-sessions =
    { $count ->
        [one] { $count } session
       *[other] { $count } sessions
    }
patients-trials =
    { $count ->
        [one] { $count } trial
       *[other] { $count } trials
    }
patients-never = no session yet
patients-last = last session { $day }
patients-delete = Delete { $code }
patients-deleted = { $code } was deleted.
patients-empty = The list is empty. Add the first patient: a code and a pseudonym are enough.
patients-none-found = Nobody matches “{ $words }”. Check the spelling, or add a new patient.
patients-alone = Nobody else works in this clinic yet.
patients-ended = The session has ended.
