### Texte des Rahmens: Kopfzeile, Leiste, Hinweise, Anmeldung.

app-name = bodydrive
app-title = { $page } · bodydrive
demo-tag = Vorführung
demo-explained = Alles hier ist eine Vorführung: Patienten und Durchgänge werden verworfen, wenn das Programm endet.
stop = STOP
stop-label = Rollstuhl jetzt stoppen
stop-sent = Stopp wurde gesendet.
stop-not-sent = Der Stopp kam nicht an: Schalten Sie den Rollstuhl an seinem eigenen Schalter aus.
app-title-of = { $code }, { $part } · { $page } · bodydrive
who-open = Sitzung { $number } offen
who-shown = wird gezeigt
who-shown-one = Sitzung { $number } wird gezeigt
who-shown-two = Sitzungen { $first } und { $second } werden gezeigt
busy-trial = Ein Durchgang läuft. Bis er beendet ist, lässt sich hier nichts ändern.
busy-trial-go = Zum Durchgang
busy-drive = Der echte Rollstuhl ist freigegeben. Bis die Fahrt beendet ist, lässt sich hier nichts ändern.
busy-drive-go = Zum Rollstuhl
busy-test = Der Zwei-Minuten-Test läuft. Bis er beendet ist, lässt sich hier nichts ändern.
busy-test-go = Zum Test
busy-run = Ein Schritt der Kalibrierung läuft. Bis er beendet ist, lässt sich hier nichts ändern.
busy-run-go = Zur Kalibrierung
who-nobody = Keine Sitzung offen
lamp-shirt = Shirt { $good } von { $all }
lamp-shirt-estimated = Shirt { $good } von { $all }, { $estimated } geschätzt
lamp-shirt-silent = Shirt stumm
lamp-shirt-unknown = Shirt: unbekannt
lamp-shirt-none = Noch kein Shirt
lamp-chair = Rollstuhl: virtuell
lamp-chair-unknown = Rollstuhl: unbekannt
lamp-screen =
    { $count ->
        [one] Patientenbildschirm
       *[other] { $count } Patientenbildschirme
    }
lamp-screen-bad =
    { $count ->
        [one] Patientenbildschirm: kein Bild
       *[other] Ein Patientenbildschirm: kein Bild
    }
lamp-screen-away =
    { $count ->
        [one] Patientenbildschirm: nicht erreichbar
       *[other] Ein Patientenbildschirm: nicht erreichbar
    }
lamp-armed = Rollstuhl: freigegeben
lamp-real = Echter Rollstuhl: { $state }
lamp-real-disarmed = gesperrt
lamp-real-checking = wartet auf Ruhe
lamp-real-armed = freigegeben
lamp-real-fault = nicht bereit
lamp-real-silent = keine Antwort
theme-label = Farben: { $theme }. Ändern
theme-system = wie im System
theme-light = hell
theme-dark = dunkel
theme-contrast = hoher Kontrast
theme-now = Farben: { $theme }.
help-open = Wozu dient diese Seite?
sign-out = Abmelden
rail-label = Die Schritte einer Sitzung und Einstellungen
rail-done = fertig
rail-sign-in = Anmelden
rail-set-up = Klinik einrichten
rail-chair = Echter Rollstuhl
rail-patients = Patienten
rail-shirt = Shirt
rail-calibrate = Kalibrieren
rail-controls = Steuerung
rail-drive = Fahren
rail-review = Auswertung
rail-settings = Einstellungen
note-lost = Keine Verbindung zum Programm seit { $time }.
note-lost-why = Ein Rollstuhl, der von dieser Seite aus gefahren wird, hält von selbst an. Die Seite versucht weiter, STOP zu senden. Alles andere wartet auf die Verbindung.
practice-simulator = Simuliertes Shirt:
practice-replay = Aufgezeichnete Signale:
practice-other = Ein Shirt, das niemand trägt:
practice-only = nur zum Üben
session-other = Eine andere Sitzung ist offen
session-opened = Patient { $code } wurde um { $time } von { $name } auf einem anderen Bildschirm geöffnet.
session-opened-somebody = Patient { $code } wurde um { $time } auf einem anderen Bildschirm geöffnet.
session-ended = Die Sitzung von Patient { $code } wurde auf einem anderen Bildschirm beendet. Jetzt ist keine Sitzung offen.
session-belongs = Was diese Seite zeigt, gehört zu { $code } und lässt sich nicht mehr senden.
session-over = Eine andere Sitzung ist offen. Von dieser Seite wurde nichts gesendet.
session-drafts = Hier eingegeben und nicht gesendet:
session-draft = { $label }: { $value }
session-go = Weiter mit { $code }
session-patients = Zu den Patienten
note-control = Der Steuerungsprozess wurde beendet. Der Rollstuhl steht.
note-control-why = Ein neuer wird gestartet …
note-fault-continue = Fortsetzen
note-fault-again = Erneut gestoppt um { $time }.
note-fault-others = Die Fachkraft neben dem Rollstuhl sieht sich um und tippt dann auf „Fortsetzen“.
note-fault-drive = Der Rollstuhl steht. „Fortsetzen“ ist auf der Seite, die ihn zeigt.
note-fault-drive-go = Zur Fahrt
note-fault-idle = Es läuft kein Durchgang und keine Fahrt. Wenn Sie den Stopp aufheben, bewegt sich nichts, und ein neuer Durchgang kann gestartet werden.
note-fault-idle-go = Stopp aufheben
note-fault-idle-others = Der Rollstuhl steht. Die Fachkraft neben dem Rollstuhl sieht sich um und hebt dann den Stopp auf.
note-driving = Ein echter Rollstuhl wird gerade gefahren.
note-driving-go = Dorthin
note-warning-go = Backups ansehen
note-fault-first = Ein Stopp oder eine Störung besteht noch. Heben Sie zuerst in der Leiste oben den Stopp auf.
note-signed-out = Sie wurden abgemeldet. Melden Sie sich wieder an.
error-no-answer = Das Programm antwortet nicht. Prüfen Sie, ob es noch läuft, und versuchen Sie es dann noch einmal.
error-status = Das Programm hat dies abgelehnt (Code { $status }). Laden Sie die Seite neu.
error-page = Diese Seite konnte nicht gezeigt werden.
error-other-page = Zu „{ $page }“
try-again = Noch einmal
undo = Rückgängig
redo = Wiederholen
cancel = Abbrechen
back = Zurück
loading = Einen Moment …
sign-in-title = Anmelden
sign-in-lead = Körper-Maschine-Schnittstelle für Elektrorollstühle.
sign-in-name = Name
sign-in-password = Passwort
sign-in-go = Anmelden
sign-in-invited = Eingeladen, aber noch ohne Passwort? Öffnen Sie auf diesem Gerät den Link Ihrer Einladung, oder scannen Sie ihren Code.
typed-show = Zeigen
typed-show-label = Eingabe zeigen
typed-hide = Verbergen
typed-hide-label = Eingabe verbergen
sign-in-demo = Dies ist eine Vorführung. Öffnen Sie den Link, den das Programm in seiner Konsole ausgegeben hat. Er meldet Sie an.
setup-title = Diese Klinik einrichten
setup-lead = Diese Klinik hat noch keine Personen. Sie werden die erste verantwortliche Person und dürfen weitere Personen einladen.
setup-code = Einrichtungscode
setup-code-hint = Das Programm hat ihn beim Start in seiner Konsole ausgegeben.
setup-password-hint = Mindestens { $count } Zeichen. Ein kurzer Satz ist leicht zu merken.
setup-go = Einrichten und anmelden
nobody-title = Keine Sitzung offen
nobody-lead = Wählen Sie einen Patienten. Damit beginnt eine Sitzung, und diese Seite zeigt sie.
nobody-go = Patient wählen
# What a page shows instead of a patient whom somebody has deleted; $code: of the patient.
gone-title = Patient gelöscht
gone-lead = { $code } wurde gelöscht: Von diesem Patienten lässt sich nichts mehr ansehen oder ändern.

## The choice of the language. Each language has its own name, in all files the same.

language-title = Sprache
language-lead = Dieser Seiten, für Sie und für diesen Browser.
language-screen = Sprache des Patientenbildschirms
language-of-browser = Wie der Browser des Bildschirms
language-en = English
language-es = Español
language-de = Deutsch
