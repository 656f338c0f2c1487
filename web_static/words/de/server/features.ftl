### Refusals of the server: comments on trials, consents, the two-minute test, layouts; and which sensors move together.

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
# $number names the layout, as in the address of the page.
layouts-missing = Es gibt kein Layout { $number }. Wählen Sie eines aus der Liste.
layouts-most = Eine Klinik hat höchstens { $count } Layouts. Löschen Sie eines, das nicht gebraucht wird.
layouts-name-taken = Es gibt schon ein Layout „{ $name }“. Geben Sie diesem einen anderen Namen.
layouts-saved-meanwhile = „{ $name }“ wurde inzwischen an einem anderen Bildschirm gespeichert. Öffnen Sie es neu, und ändern Sie es dort.
layouts-in-use = Das verwendete Shirt hat das Layout „{ $name }“. Verwenden Sie zuerst ein anderes Layout, und löschen Sie dann dieses.
# $count: 2 or more.
layouts-proposal-groups = { $count } Gruppen von Sensoren bewegen sich gemeinsam.
layouts-proposal-one = Alle bewegten Sensoren haben sich gemeinsam bewegt. Sie bilden ein einziges Gelenk.
layouts-proposal-unclear = Keine klaren Gruppen. Bewegen Sie ein Gelenk nach dem anderen, jedes mehrmals, und lassen Sie dann neu vorschlagen.
layouts-proposal-still = Weniger als zwei Sensoren haben sich bewegt. Bewegen Sie jedes Gelenk, und lassen Sie dann neu vorschlagen.
layouts-proposal-short = An weniger als { $least } Sekunden Signal lässt sich nicht erkennen, welche Sensoren sich gemeinsam bewegen. Verwenden Sie eine längere Datei, oder lassen Sie das Shirt länger senden, und lassen Sie dann neu vorschlagen.
