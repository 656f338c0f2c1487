### Refusals of the server: notes, scales and the sign-off of a session, two sessions side by side.

records-most-notes = A session has at most { $count } notes: revise one of them.
records-no-note = There is no note { $number } in this session: choose one of its notes.
records-most-scales = A session has at most { $count } scales: remove one first.
records-no-scale = There is no scale { $number } in this session: choose one of its scales.
records-still-driven = Something of this session is still being driven or tested: end it first, then sign off.
records-not-signed = Session { $session } is not signed off: it can be changed already.
records-signed = Session { $session } was signed off by { $person } on { $day } at { $time }, so nothing of it can be changed: an owner can unlock it.
records-other-patient = These two sessions are not of one patient: choose two sessions of the same list.
records-same-session = These are one and the same session: choose two.
