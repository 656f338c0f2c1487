### Refusals of requests, and what the pages show of the server's state: signing in, roles, addresses, files, floor plans,
### screens, replays, this computer.

## Signing in

api-locked = Diese Seite ist gesperrt. Geben Sie das Passwort ein, oder melden Sie sich als jemand anderes an.
api-not-signed-in = Sie sind nicht oder nicht mehr angemeldet. Melden Sie sich wieder an.
api-reviewer-changes-nothing = Mitlesende lesen und kommentieren und ändern sonst nichts. Bitten Sie eine verantwortliche Person um mehr Rechte.
api-reviewer-exports-nothing = Mitlesende geben keine Dokumentation aus der Klinik heraus. Bitten Sie eine Fachkraft um einen Bericht oder einen Export.
api-only-owners = Nur Verantwortliche können das ändern. Fragen Sie eine verantwortliche Person.
api-link-wrong = Dieser Link ist falsch, wurde schon verwendet oder ist älter als { $hours } Stunden. Bitten Sie eine verantwortliche Person um einen neuen.
api-person-disabled = Diese Person darf sich nicht mehr anmelden. Fragen Sie eine verantwortliche Person.
api-no-demonstration = Dies ist keine Vorführung. Melden Sie sich mit Ihrem Namen und Ihrem Passwort an.
api-other-demonstration = Dieser Link gehört zu einer anderen Vorführung. Öffnen Sie den Link, der zuletzt ausgegeben wurde.
api-set-up-already = Diese Klinik ist schon eingerichtet. Melden Sie sich mit Ihrem Namen und Ihrem Passwort an.
api-set-up-code-wrong = Dieser Code ist falsch, wurde schon verwendet oder ist älter als { $minutes } Minuten. Starten Sie das Programm neu, um einen neuen zu erhalten.
api-passwords-not-checked = Passwörter können gerade nicht geprüft werden. Versuchen Sie es noch einmal.
api-sign-in-wrong = Name oder Passwort ist falsch. Versuchen Sie es noch einmal, oder bitten Sie eine verantwortliche Person um ein neues Passwort.
# $name is the name of the person who is signed in.
api-password-not-own = Das ist nicht das Passwort von { $name }. Versuchen Sie es noch einmal, oder bitten Sie eine verantwortliche Person um ein neues.
api-sign-in-busy = Gerade melden sich zu viele Personen an. Warten Sie einige Sekunden, und versuchen Sie es dann noch einmal.
api-password-short = Dieses Passwort ist zu kurz. Verwenden Sie mindestens { $least } Zeichen.
api-password-long = Dieses Passwort ist zu lang. Verwenden Sie höchstens { $most } Zeichen.
api-password-common = Dieses Passwort gehört zu denen, die man zuerst ausprobieren würde. Wählen Sie ein anderes.
api-tries-name =
    { $seconds ->
        [one] Zu viele falsche Passwörter für diesen Namen. Warten Sie { $seconds } Sekunde, oder melden Sie sich dort an, wo Sie schon einmal angemeldet waren.
       *[other] Zu viele falsche Passwörter für diesen Namen. Warten Sie { $seconds } Sekunden, oder melden Sie sich dort an, wo Sie schon einmal angemeldet waren.
    }
api-tries-here =
    { $seconds ->
        [one] Von hier kamen zu viele falsche Passwörter. Warten Sie { $seconds } Sekunde, und versuchen Sie es dann noch einmal.
       *[other] Von hier kamen zu viele falsche Passwörter. Warten Sie { $seconds } Sekunden, und versuchen Sie es dann noch einmal.
    }
api-tries-code =
    { $seconds ->
        [one] Von hier kamen zu viele falsche Codes. Warten Sie { $seconds } Sekunde, und versuchen Sie es dann noch einmal.
       *[other] Von hier kamen zu viele falsche Codes. Warten Sie { $seconds } Sekunden, und versuchen Sie es dann noch einmal.
    }

## Addresses and requests

api-address-not-ours = Diese Adresse gehört nicht zu diesem Programm. Öffnen Sie den Link, den das Programm ausgegeben hat.
api-not-our-page = Diese Anfrage kommt nicht von einer Seite dieses Programms. Öffnen Sie die Seite, und versuchen Sie es noch einmal.
api-too-large = Das ist zu groß. Senden Sie hier höchstens { $megabytes } MB.
api-too-many-files = Gerade kommen andere Dateien an. Warten Sie, bis sie da sind, und versuchen Sie es dann noch einmal.
api-too-slow = Das kommt zu langsam an, deshalb wurde es abgebrochen. Bringen Sie dieses Gerät dorthin, wo der Empfang besser ist, und versuchen Sie es dann noch einmal.
api-not-the-proxy = Dieses Programm ist nur über den Proxy der Klinik erreichbar. Öffnen Sie die Adresse des Proxys.
api-proxy-incomplete = Der Proxy gibt nicht an, von wem diese Anfrage stammt. Lassen Sie ihn X-Forwarded-For, X-Forwarded-Proto und X-Forwarded-Host setzen, jeden genau einmal, wie in docs/proxy.
api-proxy-not-encrypted = Der Proxy wurde ohne Verschlüsselung erreicht. Lassen Sie ihn nur über https antworten, und öffnen Sie seine https-Adresse.
# $none is a word of the interface for programs, $header the name of a header.
api-session-unnamed = Die Anfrage nennt nicht die Sitzung, die ihre Seite zeigt. Senden Sie im Header { $header } die ID der Sitzung, oder „{ $none }“, solange keine Sitzung offen ist.
api-link-only-here = Nur dieser Rechner kann den Link öffnen, weil das Programm für andere nicht erreichbar ist.
api-link-only-in-network = Der Link lässt sich nur im eigenen Netz oder VPN der Klinik öffnen. Von anderswo braucht er einen Proxy (Seite „For the computing department“ unter /docs/).
api-screen-only-here = Nur dieser Rechner kann den Link öffnen, weil das Programm für andere nicht erreichbar ist. Für einen eigenen Patientenbildschirm beenden Sie das Programm, und starten Sie es mit „bodydrive serve --lan“.
api-this-machine-only = Dieses Programm ist nur auf diesem Rechner erreichbar. Beenden Sie es, und starten Sie es mit „bodydrive serve --lan“.
api-only-tablet-page = Über http gibt es nur die Seite, die das Verbinden erklärt. Öffnen Sie / unter dieser Adresse.
api-own-certificate = Diese Klinik hat ein eigenes Zertifikat. Es ist nichts zu installieren.

## Driving

api-far = Der Rollstuhl lässt sich nur von einem Bildschirm im Gebäude in Bewegung setzen, der direkt verbunden ist. Gehen Sie zum Rollstuhl, und öffnen Sie die Seite dort.
api-another-controller = Jemand anderes hat diese Fahrt gestartet, und nur diese Person kann sie hier fortsetzen oder beenden. Sie können die Fahrt stoppen und die Person fragen.
api-no-picture = Dieser Bildschirm hat kein Bild, und ohne Bild wird nicht gefahren. Warten Sie, bis die 3D-Ansicht da ist, oder wählen Sie auf der Seite „Fahren“ die Planansicht.
api-no-picture-for-patient = Der Patientenbildschirm hat kein Bild, und ohne Bild wird nicht gefahren. Warten Sie, bis das Bild da ist, oder entkoppeln Sie den Bildschirm.
api-patients-screen-away = Der Patientenbildschirm, den dieser Durchgang verwendet, ist nicht erreichbar. Stellen Sie die Verbindung wieder her, oder entkoppeln Sie ihn. Tippen Sie dann auf „Fortsetzen“.
api-process-restarting = Der Steuerungsprozess wird neu gestartet.
api-controls-changed = Die Steuerung oder das Rollstuhldokument wurde inzwischen geändert. Lesen Sie noch einmal, welche Einstellungen gelten, und geben Sie den Rollstuhl dann frei.
api-not-in-view = Dieser Bildschirm hat noch nicht gemeldet, dass seine Seite zu sehen ist. Warten Sie einen Moment, und geben Sie den Rollstuhl dann noch einmal frei.
api-trial-on-real-chair = Ein echter Rollstuhl ist gewählt. Wählen Sie für einen Durchgang den virtuellen.
# $name is the name of a path in the program.
api-no-path = Dieser Grundriss hat keine Strecke „{ $name }“. Wählen Sie eine aus der Liste.
api-no-view = Solange keine Sitzung offen ist, gibt es keine 3D-Ansicht. Öffnen Sie zuerst eine Sitzung.

## Calibration and controls

# Title of the last step of a calibration.
api-result = Ergebnis
api-result-instruction = Sehen Sie sich jedes Gelenk an. Wiederholen Sie, was nicht gut genug ist, und tippen Sie dann auf „Diese Kalibrierung verwenden“.
api-calibration-busy = Ein Schritt wird aufgezeichnet, oder die Kalibrierung wird berechnet. Warten Sie, bis das fertig ist.
api-calibration-in-use = Diese Kalibrierung wird schon verwendet. Gehen Sie weiter zur Steuerung, oder wiederholen Sie einen Schritt.
# Begins a sentence on what is wrong in a set of controls.
api-the-controls = Die Steuerung

## Review

api-replay-while-driving = Gerade fährt jemand. Wählen Sie „Plan“, oder warten Sie, bis die Fahrt vorbei ist.
api-no-replay = Von diesem Durchgang gibt es kein Bild. Seine Aufzeichnung ist nicht lesbar, oder sie nennt keinen Ort.
api-replay-closed = Diese Wiedergabe wurde geschlossen. Öffnen Sie sie noch einmal.
api-trial-still-running = Dieser Durchgang läuft noch. Sehen Sie ihn an, wenn er beendet ist.
api-recording-unreadable = Die Aufzeichnung dieses Durchgangs ist nicht lesbar. Stellen Sie sie aus einem Backup wieder her.
# Follows the name of what was sent. $measures are names of measures in the program.
api-no-measure = ist kein Messwert; wählen Sie einen von diesen: { $measures }
api-trials-not-comparable = Diese beiden Durchgänge unterscheiden sich in Patient, Aufgabe oder Quelle. Deshalb gilt keiner als besser.

## Floor plans and objects

# $problem says what is wrong in the file of the plan, and what to do, without a full stop.
api-plan-unusable = Der Grundriss „{ $name }“ lässt sich nicht verwenden: { $problem }. Speichern oder importieren Sie ihn danach noch einmal.
api-no-plan = Es gibt keinen Grundriss „{ $name }“. Wählen Sie einen aus der Liste.
# Begins a sentence on what is wrong in a floor plan.
api-the-plan = Der Grundriss
# $problem is a sentence without its full stop: what is wrong, and what to do.
api-problem = { $problem }.
api-plan-too-many-parts = Der Grundriss hat mehr als { NUMBER($count, useGrouping: 1) } Punkte und Objekte. Vereinfachen Sie ihn.
api-plan-other-name = Der Grundriss, name: dort steht nicht „{ $name }“ wie in der Adresse; korrigieren Sie es.
api-plan-unreadable = Dieser Grundriss ist nicht mehr lesbar. Speichern Sie ihn noch einmal so, wie er gezeichnet war.
api-options-not-json = Der Import, options: das ist kein JSON; korrigieren Sie es.
# $endings are endings of file names.
api-wrong-plan-file = „{ $name }“ hat keine dieser Endungen: { $endings }. Speichern Sie die Datei in einem dieser Formate, und fügen Sie sie dann noch einmal hinzu.
api-plan-too-large = „{ $name }“ ist größer als { $megabytes } MB. Verkleinern Sie die Datei, und fügen Sie sie dann noch einmal hinzu.
api-map-too-large = „{ $name }“ ist größer als 100 kB. Verkleinern Sie die Datei, und fügen Sie sie dann noch einmal hinzu.
api-map-incomplete = Eine ROS-Karte besteht aus zwei Dateien. Wählen Sie die .yaml-Datei und ihr Bild zusammen.
api-map-picture-alone = Ein .pgm-Bild gehört zu einer Karte. Wählen Sie auch deren .yaml-Datei.
api-one-plan-at-a-time = Grundrisse werden einzeln erstellt. Wählen Sie nur eine Datei oder die zwei Dateien einer Karte.
api-no-glb = „{ $name }“ ist keine GLB-Datei. Exportieren Sie das Objekt als glTF binär (.glb).
api-glb-too-large = „{ $name }“ ist größer als { $megabytes } MB. Vereinfachen Sie das Objekt.
api-too-many-objects = Es gibt schon { $count } Objekte. Löschen Sie einige im Ordner „models“.

## Files of signals and bodies

api-wrong-upload = „{ $name }“ ist weder eine CSV- noch eine Parquet-Datei. Speichern Sie die Datei in einem dieser Formate, und fügen Sie sie dann noch einmal hinzu.
api-upload-too-large = „{ $name }“ ist größer als { $megabytes } MB. Kürzen Sie die Datei, oder speichern Sie sie als Parquet.
api-upload-empty = „{ $name }“ ist leer. Wählen Sie eine andere Datei.
# Begins a sentence on what is wrong in what a person has corrected.
api-the-import = Der Import
# A choice among joints: of channels whose names say no part of the body.
api-joint-body = Körper, als ein Gelenk
api-one-recording = Aufzeichnungen werden einzeln importiert. Wählen Sie nur eine Datei, oder die von BIDS-motion mit ihrer _channels.tsv und _motion.json.
# $count is a count of numbers in the file.
api-upload-columns = „{ $name }“ hat keine Spalte mit Zeiten (t) und Kanälen daneben, oder die Datei enthält mehr als { NUMBER($count, useGrouping: 1) } Zahlen. Eine Zeile über den Zahlen muss die Zeit und jeden Kanal nennen.
# $problem is the reason that the operating system gives.
api-upload-not-kept = „{ $name }“ lässt sich nicht speichern ({ $problem }). Schaffen Sie Speicherplatz, und fügen Sie die Datei dann noch einmal hinzu.

## This computer

api-measuring-while-busy = Ein Rollstuhl ist freigegeben, oder etwas wird aufgezeichnet, und das Messen nimmt der Regelschleife Zeit. Messen Sie, wenn das vorbei ist.
api-measuring-interrupted = Ein Rollstuhl wurde freigegeben, oder eine Aufzeichnung begann. Die Messung wurde deshalb beendet, denn das Messen nimmt der Regelschleife Zeit. Messen Sie noch einmal, wenn das vorbei ist.
api-measuring-already = Dieser Rechner wird schon gemessen. Warten Sie, bis das vorbei ist.
api-measuring-failed = Dieser Rechner konnte nicht gemessen werden. Versuchen Sie es noch einmal. Den Grund zeigt „bodydrive check“, auf diesem Rechner ausgeführt.
# The name of a screen: begins a sentence on how many pictures a second it draws. $name is the name of a person.
api-page-of = Die Seite von { $name }
# The name of a screen: begins a sentence on how many pictures a second it draws.
api-patients-screen = Ein Patientenbildschirm
