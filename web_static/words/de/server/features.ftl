### Refusals of the server: comments on trials, consents, the two-minute test.

# $number names the comment, as in the address of the page.
comments-missing = Es gibt keinen Kommentar { $number }. Wählen Sie einen der Kommentare dieses Durchgangs.
comments-most = Ein Durchgang hat höchstens { $count } Kommentare. Ändern Sie einen Ihrer eigenen.
comments-not-author = Einen Kommentar ändert nur, wer ihn geschrieben hat. Schreiben Sie einen eigenen.
comments-withdrawn-already = Dieser Kommentar wurde zurückgezogen. Schreiben Sie einen neuen.
comments-trial-running = Dieser Durchgang läuft noch. Sehen Sie ihn sich an, wenn er beendet ist.
consents-future = Eine Einwilligung wird heute erteilt oder wurde früher erteilt. Wählen Sie einen Tag, der nicht in der Zukunft liegt.
tests-missing = Es gibt keinen Zwei-Minuten-Test { $number }. Wählen Sie einen aus der Liste.
tests-still-running = Der Zwei-Minuten-Test läuft noch. Beenden Sie ihn zuerst, und fragen Sie dann, wie anstrengend er war.
tests-stop-in-force = Ein Stopp besteht noch. Heben Sie ihn zuerst auf, und starten Sie dann den Zwei-Minuten-Test.
