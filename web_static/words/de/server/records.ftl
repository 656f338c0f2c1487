### Refusals of the server: notes, scales and the sign-off of a session, two sessions side by side.

records-most-notes = Eine Sitzung hat höchstens { $count } Notizen. Ändern Sie eine davon.
records-no-note = In dieser Sitzung gibt es keine Notiz { $number }. Wählen Sie eine ihrer Notizen.
records-most-scales = Eine Sitzung hat höchstens { $count } Assessments. Entfernen Sie zuerst eines.
records-no-scale = In dieser Sitzung gibt es kein Assessment { $number }. Wählen Sie eines ihrer Assessments.
records-still-driven = In dieser Sitzung wird noch gefahren oder getestet. Beenden Sie das zuerst, und zeichnen Sie die Sitzung dann ab.
records-not-signed = Sitzung { $session } ist nicht abgezeichnet. Sie lässt sich schon ändern.
records-signed = Sitzung { $session } wurde von { $person } am { $day } um { $time } abgezeichnet. Deshalb lässt sich daran nichts ändern. Verantwortliche können sie entsperren.
records-other-patient = Diese beiden Sitzungen gehören nicht zum selben Patienten. Wählen Sie zwei Sitzungen derselben Liste.
records-same-session = Das ist zweimal dieselbe Sitzung. Wählen Sie zwei verschiedene.
