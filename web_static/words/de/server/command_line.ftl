### Texts of the command line, `bodydrive COMMAND ...`: what it prints, and what it says of bad input.
### Words that begin with --, and words in capitals behind them, are typed on the command line: they are not translated.

## Every command

# A name of the reader's own, such as a file or a joint, and a sentence on it.
cli-named = { $name }: { $text }
cli-file-failed = { $file } kann nicht gelesen oder geschrieben werden ({ $reason }): Beheben Sie das, und versuchen Sie es noch einmal
cli-output-failed = die Ausgabe kann nicht gelesen oder geschrieben werden ({ $reason }): Beheben Sie das, und versuchen Sie es noch einmal
# $problem is a sentence of the library that reads the command line, $command is such as: bodydrive score
cli-see-help = { $problem }: siehe { $command } --help
cli-out-was-read = --out { $file } ist eine Datei, die hierfür gelesen wurde: Wählen Sie einen anderen Ort
cli-out-unwritable = --out { $file } kann nicht geschrieben werden ({ $reason }): Wählen Sie einen anderen Ort
cli-out-no-folder = --out { $folder }: { $file } ist eine Datei und kein Ordner, wählen Sie einen anderen Ort
cli-out-forbidden = --out { $folder }: in { $parent } darf nichts geschrieben werden, wählen Sie einen anderen Ort
cli-out-no-file = --out { $file } ist keine gewöhnliche Datei: Wählen Sie einen anderen Ort
cli-file-written = { $file } ist geschrieben.
cli-source = Quelle: { $source }
cli-no-clinic = In { $folder } gibt es keine Klinik. Geben Sie ihren Ordner mit --state an.
cli-no-set-up = Die Klinik in { $folder } ist noch nicht eingerichtet. Öffnen Sie zuerst ihre Seiten.
cli-folder-unwritable = In { $folder } kann nicht geschrieben werden. Wählen Sie mit --state einen anderen Ordner.
cli-folder-in-use = Die Klinik in { $folder } ist schon geöffnet. Beenden Sie das andere Programm, oder wählen Sie mit --state eine andere.
cli-other-version = Das laufende Programm hat eine andere Version als dieser Befehl. Geben Sie den Befehl jener Version ein, oder beenden Sie zuerst das Programm.
cli-others-can-read =
    { $count ->
        [one] Andere Personen an diesem Rechner können { $count } Datei der Klinik lesen, { $file }. Übertragen Sie sie diesem Konto, oder verlegen Sie die Klinik auf einen Datenträger, der Rechte bewahrt.
       *[other] Andere Personen an diesem Rechner können { $count } Dateien der Klinik lesen, als erste { $file }. Übertragen Sie sie diesem Konto, oder verlegen Sie die Klinik auf einen Datenträger, der Rechte bewahrt.
    }
# The name of a clinic that a command makes.
cli-clinic-name = Klinik
cli-no-such-patient = Es gibt keinen Patienten mit dem Code „{ $code }“. Sehen Sie in der Liste der Patienten nach.
cli-yes = ja
cli-no = nein
# Of a measured value, in a table.
cli-unknown = nicht bekannt

## about

cli-about-compiled = bodydrive { $version }, mit kompilierten Berechnungen (die Zahlen sind in jedem Fall gleich, Bit für Bit)
cli-about-plain = bodydrive { $version }, als reines Python (die Zahlen sind in jedem Fall gleich, Bit für Bit)
cli-about-held = In den eigenen Dateien steckt Arbeit anderer. Die Texte der Lizenzen stehen in THIRD_PARTY_NOTICES.txt:
cli-about-no-licence = keine Lizenz angegeben
# Of a package, in the place of its version.
cli-about-missing = nicht installiert
cli-about-not-installed = bodydrive ist für dieses Python nicht installiert, deshalb sind seine Pakete nicht bekannt. Installieren Sie sein Wheel.

## chair and shirt: pairing. The key is shown as a QR code above these sentences.

# The chair whose options were wrong.
cli-the-chair = der Rollstuhl
cli-chair-paired = { $name } unter { $host }:{ $port } ist gekoppelt. Der Schlüssel steht in { $file } und im Code oben.
# A command follows.
cli-chair-next = Schreiben Sie auf dem Rechner des Rollstuhls den Inhalt des Codes in eine Datei { $file }, die nur Sie lesen können, und starten Sie dort:
cli-shirt-paired = Das Shirt ist gekoppelt. Sein Schlüssel steht in { $path } und im Code oben. Wählen Sie { $file } auf der Seite „Shirt“.
# A command follows.
cli-shirt-next =
    Die Firmware des Shirts braucht den Inhalt des Codes. Zum Ausprobieren schreiben Sie ihn auf einem beliebigen
    Rechner in eine Datei { $file }, die nur Sie lesen können, und starten Sie dort:

## chair: the rehearsal without one, and its record

cli-rehearsal-title = Übung ohne Rollstuhl
cli-rehearsal-about = { $who }, { $date }; bodydrive { $version }, Ausgang { $output }, Schlüssel { $key }.
cli-rehearsal-no-chair = Der Rollstuhl war nachgebildet. Was ein echter tut, wenn sein Kabel gezogen wird oder der Empfänger endet, zeigt das nicht: Probieren Sie es mit angehobenen Rädern.
cli-rehearsal-signed = { $file } ist unterschrieben. SHA-256: { $digest }. HMAC: { $tag }.
cli-rehearsal-end = { $kept } von { $steps } Schritten wurden eingehalten. Das Protokoll ist { $file }.
cli-rehearsal-no-output = --output { $output } lässt sich nicht nachbilden: Geben Sie eines an von { $outputs }
cli-rehearsal-no-who = das Protokoll braucht --who, einen Namen in einer Zeile mit höchstens { $most } Zeichen: Geben Sie ihn an
cli-rehearsal-no-json = --out { $file } endet nicht auf .json: Geben Sie einen solchen Namen an
cli-rehearsal-no-receiver = der Empfänger startet nicht ({ $reason }): Berichtigen Sie, was er nennt
cli-rehearsal-false = { $file } ist kein Protokoll, das mit diesem Schlüssel unterschrieben wurde, oder wurde seither geändert: Geben Sie die richtige Datei und den richtigen Schlüssel an
cli-rehearsal-genuine = { $file } ist so, wie es mit diesem Schlüssel unterschrieben wurde.
cli-rehearsal-step =
    { $step ->
        [paired] Der Empfänger startet mit dem Schlüssel des Rollstuhls.
        [armed] Der Rollstuhl wird freigegeben.
        [driven] Er wird vorwärts gefahren.
        [stopped] Stopp wird gedrückt.
        [switch] Während der Fahrt wird der Schalter des Rollstuhls gedrückt.
        [silence] Während der Fahrt enden die Fahrbefehle, wie wenn das Netzwerkkabel gezogen wird.
        [hand] Während der Fahrt bewegt jemand den eigenen Joystick des Rollstuhls.
        [cable] Während der Fahrt wird das Kabel des Rollstuhls gezogen.
        [plugged] Das Kabel wird wieder eingesteckt.
       *[killed] Während der Fahrt wird der Prozess des Empfängers abgebrochen.
    }
cli-rehearsal-must =
    { $step ->
        [paired] Er muss antworten.
        [armed] Er muss das annehmen.
        [driven] Seine Räder müssen sich drehen.
        [stopped] Seine Räder müssen stehen.
        [switch] Seine Räder müssen stehen.
        [silence] Seine Räder müssen stehen.
        [hand] Seine Räder müssen stehen.
        [cable] Der Empfänger muss die Störung melden und keine Geschwindigkeit mehr verlangen.
        [plugged] Die Räder müssen stehen, und der Rollstuhl muss gesperrt sein.
       *[killed] Die Klinik muss sehen, dass er schweigt.
    }
cli-rehearsal-result =
    { $how ->
        [kept] EINGEHALTEN: { $took } von { $limit } ms.
        [late] NICHT EINGEHALTEN: { $took } ms statt { $limit }.
       *[never] NICHT EINGEHALTEN: Es geschah nicht ({ $limit } ms).
    }

## decode

cli-decode-suffix = --out { $file }: der Name muss auf .parquet oder .csv enden
cli-decode-done = { $frames } Datenpakete, { $seconds } s, dekodiert in { $out }
cli-profile-unreadable = --profile { $file } ist nicht lesbar ({ $reason }): Geben Sie die Datei an, die calibrate geschrieben hat
cli-profile-no-json = --profile { $file } ist kein JSON-Dokument: Geben Sie die Datei an, die calibrate geschrieben hat
cli-range-dead-zone = --dead-zone { $value }: geben Sie volle Bewegungen pro Sekunde von { $least } bis { $most } an
cli-range-cutoff = --cutoff { $value }: geben Sie Hz von { $least } bis { $most } an
# The options that were wrong together.
cli-dead-zone-or-cutoff = --dead-zone oder --cutoff

## floorplan

cli-plan-suffix = --out { $file }: der Name muss auf .json enden
# The options of the command, which were wrong.
cli-the-options = die Optionen
cli-plan-no-room = { $file }: ein Rollstuhl passt nirgends hinein, zeichnen Sie eine Strecke auf einer Ebene PATH, oder prüfen Sie die Einheit
cli-plan-made = { $title }: { $walls } Wandstücke, eine Strecke von { $length } m, geschrieben in { $out }
# $plans are names, with commas between them
cli-plan-fine = { $file }: in Ordnung ({ $plans })

## log

cli-log-unreadable = Das Protokoll in { $file } ist nicht lesbar ({ $reason }). Geben Sie ein anderes --state an.

## people

# Whether somebody can sign in: a person's state in a list.
cli-person-state-active = aktiv
cli-person-state-invited = eingeladen
cli-person-state-disabled = gesperrt
# Behind a reviewer, in a list: the codes of the patients whom the reviewer may see.
cli-person-patients = Patienten: { $codes }
cli-person-no-patients = Patienten: keine
cli-no-role = --role { $role } ist keine Rolle. Geben Sie owner, clinician oder reviewer an.
cli-name-unusable = Dieser Name ist nicht verwendbar. Geben Sie 1 bis 80 sichtbare Zeichen an.
cli-no-patient-option = --patient { $code }: Einen Patienten mit diesem Code gibt es nicht, siehe Seite „Patienten“.
cli-person-is-disabled = { $name } ist gesperrt. Offene Seiten dieser Person enden innerhalb von 5 Sekunden.
cli-person-is-enabled = { $name } kann sich wieder anmelden, mit dem bisherigen Passwort.
# The link follows. $time is a day with a time of day.
cli-invitation = Mit diesem Link wählt { $name } ein Passwort, einmal, bis { $time }:
cli-not-running = Das Programm läuft jetzt nicht. Starten Sie es mit `bodydrive serve`, und öffnen Sie dann den Link unter seiner Adresse.

## demo and serve: addresses, ports, certificates

cli-no-address = „{ $host }“ ist keine Adresse dieses Rechners. Lassen Sie --host weg, oder geben Sie eine seiner Adressen an.
cli-port-busy = Port { $port } von { $host } ist belegt. Beenden Sie das Programm, das ihn verwendet, oder wählen Sie mit --port einen anderen (mit make: PORT={ $next }).
cli-port-of-system = Port { $port } ist dem System vorbehalten. Wählen Sie mit --port einen über 1023.
cli-proxy-no-address = --behind-proxy „{ $text }“ ist keine Adresse. Schreiben Sie eine wie 127.0.0.1 oder 10.1.2.0/24.
cli-proxy-too-large = --behind-proxy { $text } umfasst zu viele Adressen, um ihnen zu vertrauen. Geben Sie die Adresse des Proxys an.
cli-no-public-name = --name „{ $text }“ ist kein Name. Schreiben Sie einen wie clinic.example.org.
cli-not-encrypted = Andere Rechner erreichen { $host }, und ohne https könnten alle auf dem Weg lesen und ändern, was sie senden. Verwenden Sie „bodydrive serve --lan“, oder lassen Sie --host weg.
cli-proxy-needs-name = --behind-proxy und --name gehören zusammen. Geben Sie die Adresse und den Namen des Proxys an.
cli-proxy-or-lan = Ein Proxy ist der einzige Zugang. Verwenden Sie entweder --lan oder --behind-proxy.
cli-one-host = Ohne --lan gibt es nur eine Adresse. Geben Sie --host einmal an, oder lassen Sie es weg.
cli-certificate-needs-lan = Ein Zertifikat ist für andere Rechner. Verwenden Sie --certificate und --key zusammen mit --lan.
cli-certificate-needs-key = Ein Zertifikat braucht seinen Schlüssel. Geben Sie beide an, mit --certificate FILE --key FILE.
# A QR code and an address follow.
cli-scan = Scannen Sie diesen Code mit einem Tablet, oder öffnen Sie dort die Adresse darunter:
# A QR code and an address follow.
cli-scan-again = Die Adresse dieses Rechners hat sich geändert. Scannen Sie diesen Code mit einem Tablet, oder öffnen Sie dort die Adresse darunter:
cli-demo-opened = Eine Vorführung, nichts wird aufbewahrt. Strg-C beendet sie.
cli-serve-opened = Die Klinik in { $folder }. Strg-C beendet das Programm.
cli-setup-code = Einrichtungscode für die erste verantwortliche Person, gültig { $minutes } Minuten: { $code }
cli-control-process-failed = Der Steuerungsprozess kann nicht gestartet werden ({ $reason }). Schließen Sie andere Programme, und versuchen Sie es dann noch einmal.
cli-control-process-ended = Der Steuerungsprozess ist nicht gestartet, deshalb gibt es nichts zu zeigen. Lesen Sie die Meldungen oben, und versuchen Sie es noch einmal.
# $kind is the name of an error in Python, $problem what it says
cli-not-started = Das Programm ist nicht gestartet. Der Grund ist { $kind }: { $problem }. Beheben Sie das, wenn Sie können, und starten Sie das Programm dann noch einmal. Melden Sie sonst diese Zeile.
# The name of the clinic of `bodydrive demo`.
cli-demo-clinic = Vorführung
# What is noted about the two patients of `bodydrive demo`.
cli-demo-calibrated = Ein Patient der Vorführung: keine echte Person. Im simulierten Shirt kalibriert.
cli-demo-newcomer = Ein Patient der Vorführung: keine echte Person. Nie kalibriert: fährt mit dem, was von anderen Personen gelernt wurde.

## service

cli-service-account = Eine eigene Unit läuft unter Ihrem Konto. Lassen Sie --account weg, oder fügen Sie --system hinzu.
cli-service-root = Die Klinik darf nicht als root laufen. Geben Sie ihr Konto mit --account an.
cli-service-state = Geben Sie den Ordner der Klinik mit --state an: Eine Unit des Systems hat keinen Benutzerordner.
cli-service-letters = Der Name des Ordners oder des Kontos enthält ein Zeichen, das in einer Unit nicht stehen kann. Wählen Sie einen anderen.

## check

cli-check-begins = { $seconds } s lang wird gemessen, wie die Regelschleife laufen würde …

## replay

cli-replay-speed = --speed { $speed }: geben Sie eine Zahl zwischen { $least } und { $most } an
cli-replay-begins = { $name } wird an { $to } gesendet: { $channels } Kanäle mit { $rate } Hz, { $seconds } s. Strg-C beendet das Senden.
cli-replay-loops = { $name } wird an { $to } gesendet: { $channels } Kanäle mit { $rate } Hz, { $seconds } s, immer wieder von vorn. Strg-C beendet das Senden.
cli-replay-failed = --to { $to }: dorthin lässt sich nichts senden ({ $reason }), geben Sie eine andere Adresse an
cli-replay-stopped = Gestoppt. Gesendete Datenpakete: { $frames }.
cli-replay-ended = Die Aufzeichnung ist zu Ende. Gesendete Datenpakete: { $frames }.
cli-replay-address = --to { $to }: schreiben Sie einen Rechner und einen Port, zum Beispiel { $example }
cli-replay-no-host = --to { $to }: einen Rechner mit diesem Namen gibt es nicht, korrigieren Sie ihn

## score

cli-score-radius = --goal-radius { $radius }: geben Sie Meter an, mehr als 0 und höchstens { $most }
cli-score-places = { $file }: x und y müssen Meter sein, höchstens { $most } von 0 entfernt, korrigieren Sie sie
cli-score-too-long = { $file }: dauert { $seconds } s, mehr als einen Tag, geben Sie t in Sekunden an, für einen Durchgang
cli-score-rows = { $file }: die Zeilen liegen meist { $seconds } s auseinander, geben Sie t in Sekunden an, nicht in Millisekunden
cli-score-speed = { $file }: die mittlere Geschwindigkeit ist { $speed } m/s, geben Sie x und y in Metern an und t in Sekunden
cli-score-slow = { $file }: die mittlere Geschwindigkeit ist { $speed } m/s bei Zeilen im Abstand von { $seconds } s, geben Sie t in Sekunden an, nicht in Millisekunden
cli-score-loops = Zwei Schleifen um dieselbe Stelle in Gegenrichtung heben sich in der Fläche auf, der gefahrene Weg zählt beide.

## signals. column, unit, role, ... are titles of a table.

cli-signals-title-column = Spalte
cli-signals-title-unit = Einheit
cli-signals-title-role = enthält
cli-signals-title-joint = Gelenk
cli-signals-title-least = kleinster Wert
cli-signals-title-most = größter Wert
cli-signals-title-missing = fehlt
cli-signals-role =
    { $role ->
        [time] Zeit
        [channel] Kanal
        [other-time] andere Zeit
        [counter] Zähler
        [text] Wörter
        [empty] nichts
        [constant] einen Wert
       *[unused] nicht verwendet
    }
cli-signals-summary =
    { $channels ->
        [one] { $rows } Abtastwerte, { $seconds } s, mit { $rate } Hz, { $channels } Kanal.
       *[other] { $rows } Abtastwerte, { $seconds } s, mit { $rate } Hz, { $channels } Kanäle.
    }
# names: of streams or sheets.
cli-signals-parts = Teile, die sich mit --part einzeln lesen lassen: { $names }.
cli-signals-suffix = --out { $file }: der Name muss mit .parquet enden
cli-signals-rate = --rate { $rate }: geben Sie Hz von { $least } bis { $most } an
cli-signals-unit = --unit { $unit }: geben Sie eine dieser Einheiten an: { $known }
cli-signals-channels = --channels { $channels }: geben Sie verschiedene Namen von Spalten an, mit Kommas dazwischen
# problem: a sentence without a full stop.
cli-signals-correct = { $problem } (oder sagen Sie es mit --time, --unit oder --rate; was eine Datei enthält, zeigt bodydrive signals show)

## study

cli-study-seeds = --seed { $seed } lässt keinen Platz für --seeds { $seeds }: Der größte Seed ist { $largest }
cli-study-learning = --no-learning geht nur ohne --adapt: Über mehrere Sitzungen wird die Person mit --person gewählt
cli-study-interface = --interface-test geht nur ohne --adapt und ohne --no-learning: Wählen Sie eines davon
cli-study-map = --map { $map } geht nur mit --adapt: Geben Sie an, wie sich die Kalibrierung anpasst, oder lassen Sie es weg
cli-study-path = --path { $path }: hat keine Linie, von der aus gemessen wird, wählen Sie eine Strecke, der man entlangfährt
cli-study-foreign = --out { $folder } enthält „{ $file }“, das zu keiner Studie gehört: Geben Sie einen neuen oder leeren Ordner an
# $names are names of floor plans, with commas between them
cli-study-no-plan = --floorplan „{ $plan }“: einen solchen Grundriss gibt es nicht, verwenden Sie { $names } oder eine JSON-Datei
# A sentence on the floor plan, the path or the folder that was named, which begins with the name where it needs one.
cli-study-bad-plan = --floorplan { $problem }
cli-study-bad-path = --path: { $problem }
cli-study-bad-out = --out { $problem }
cli-study-figures = --format { $format }: Abbildungen brauchen die Bibliothek matplotlib, installieren Sie sie mit pip install 'bodydrive[figures]', oder verzichten Sie mit --format none auf Abbildungen
# One trial of a simulated person: the area between the driven and the prescribed path.
cli-study-trial = Durchgang { $number } von { $trials }: gefahrener Weg { $distance } m, Fläche neben der Strecke { $area } m², { $seconds } s
cli-study-trial-missed = Durchgang { $number } von { $trials }: gefahrener Weg { $distance } m, Fläche neben der Strecke { $area } m², { $seconds } s, Ziel nicht erreicht
# $seed stands for a simulated person, $mode is off or what --adapt was given
cli-study-session-trial = Seed { $seed }, { $mode }, Sitzung { $session }, Durchgang { $trial }: Fläche neben der Strecke { $area } m²
cli-study-session-trial-missed = Seed { $seed }, { $mode }, Sitzung { $session }, Durchgang { $trial }: Fläche neben der Strecke { $area } m², Ziel nicht erreicht
cli-study-seed-trials =
    { $count ->
        [one] Seed { $seed }: { $count } Durchgang gefahren
       *[other] Seed { $seed }: { $count } Durchgänge gefahren
    }
cli-study-seed-sessions =
    { $count ->
        [one] Seed { $seed }: { $count } Sitzung
       *[other] Seed { $seed }: { $count } Sitzungen
    }
cli-study-trials-done =
    { $count ->
        [one] { $count } Durchgang in { $seconds } s, geschrieben in { $out }
       *[other] { $count } Durchgänge in { $seconds } s, geschrieben in { $out }
    }
cli-study-tests-done =
    { $count ->
        [one] { $count } Zwei-Minuten-Test in { $seconds } s, geschrieben in { $out }
       *[other] { $count } Zwei-Minuten-Tests in { $seconds } s, geschrieben in { $out }
    }

## calibrate: a table with one line for each joint. A title of a column stays short.

cli-joints-joint = Gelenk
# How clear the main movement is, in percent.
cli-joints-clear = klar
cli-joints-span = Bereich
# How many of 100 movements reach half of full.
cli-joints-hits = erkannt von 100
# How often the gesture acts while the person rests.
cli-joints-at-rest = in Ruhe pro Minute
# From which speed of the movement the gesture counts.
cli-joints-counts-from = zählt ab
cli-joints-full-at = voll ab
cli-joints-calibration = Kalibrierung
# Calibrations, in the last column: the standard one, one learnt from the cues, one learnt from other people.
cli-map-standard = Standard
cli-map-cues = Vorgaben
cli-map-people = Personen
# A share of the full movement per second.
cli-calibrate-rate = { $share } % / s
# $least is the least figure that the repetitions show
cli-at-least = { $figure } (min. { $least })
cli-at-most = { $figure } (max. { $most })
# An expected figure with its standard deviation.
cli-forecast = { $value } ± { $uncertainty }
cli-calibrate-clear-means = Klar: Anteil des Signals, der in der Hauptbewegung liegt. Bereich: der vollen Bewegung, in der Einheit der Signale.
cli-calibrate-expected-means = Erkannt von 100: Bewegungen, die voraussichtlich die halbe volle Wirkung erreichen. In Ruhe pro Minute: wie oft die Geste voraussichtlich auslöst.
# $reason has no full stop
cli-channel-left-out = Kanal { $channel } wird ausgelassen: { $reason }.
cli-calibrate-out = Das Kalibrierungsprofil steht in { $out }
# Titles of the columns of gestures: all of them together as one score, the strength of the signal, how well the
# movement repeats, how much moves along with it, the effort, false activations a minute, the share of cues answered.
cli-gesture = Geste
cli-gestures-score = Punkte
cli-gestures-signal = Signal
cli-gestures-repeats = wiederh.
cli-gestures-along = Mitbew.
cli-gestures-effort = Aufwand
cli-gestures-false = Ruhe/min
cli-gestures-answered = erkannt
# What gestures are suggested for.
cli-control-faster = schneller
cli-control-slower = langsamer
cli-control-left = links drehen
cli-control-right = rechts drehen
cli-control-stop = Stopp
# $source says what the calibration was learnt from. $hits and $false are such as: 93 ± 6.6
cli-prior-joint = { $joint }: { $source } (Personen: { $people }, eigene Wiederholungen: { $repetitions }); voraussichtlich erkannt von 100 Bewegungen: { $hits }; voraussichtlich in Ruhe ausgelöst pro Minute: { $false }
cli-prior-joint-dropped = { $joint }: { $source } (Personen: { $people }, eigene Wiederholungen: { $repetitions }); voraussichtlich erkannt von 100 Bewegungen: { $hits }; voraussichtlich in Ruhe ausgelöst pro Minute: { $false }; Kanäle, die sich kaum bewegen: { $channels }
# A ring is a band of sensors around an arm.
cli-ring-as-others = Ring { $ring }: sitzt wie bei anderen Personen.
cli-ring-turned =
    { $places ->
        [one] Ring { $ring }: gegenüber anderen Personen um { $places } Platz verdreht; die Kalibrierung berücksichtigt das.
       *[other] Ring { $ring }: gegenüber anderen Personen um { $places } Plätze verdreht; die Kalibrierung berücksichtigt das.
    }
cli-ring-mirrored =
    { $places ->
        [one] Ring { $ring }: gegenüber anderen Personen gespiegelt und um { $places } Platz verdreht; die Kalibrierung berücksichtigt das.
       *[other] Ring { $ring }: gegenüber anderen Personen gespiegelt und um { $places } Plätze verdreht; die Kalibrierung berücksichtigt das.
    }
cli-map-guided-missing = --map guided, { $joint }: { $reason }
cli-map-prior-missing = --map prior, { $joint }: { $reason }
cli-map-needs-prior = --map prior: die Bewegungen anderer Personen stehen in einer Starthilfe, geben Sie sie mit --prior an
# $reason is a sentence
cli-map-fallback = { $joint }: { $reason } Es bleibt bei der Standardkalibrierung.
cli-map-guided-not-better = { $joint }: Das aus den Vorgaben Gelernte ist bei den zurückgehaltenen Wiederholungen nicht besser. Mit --map best bleibt es dort bei der Standardkalibrierung.
cli-map-prior-worse = { $joint }: Das von anderen Personen Gelernte ist bei den zurückgehaltenen Wiederholungen schlechter. Mit --map best wird es dort weggelassen.
cli-compare-title = Die Standardkalibrierung und die aus den Vorgaben gelernte, geprüft an zurückgehaltenen vorgegebenen Wiederholungen:
# Titles of columns, each over two figures: of the standard calibration and of the one learnt from the cues.
cli-compared-in-phase = nach Vorgabe
cli-compared-time-driven = Zeit mit Wirkung
cli-compared-false = in Ruhe pro min
# Whether the calibration learnt from the cues is offered: yes or no.
cli-compare-offered = angeboten
cli-no-seconds = --{ $option } { $value }: geben Sie Sekunden als Zahl an
cli-nothing-there = --{ $start } { $first } --{ $end } { $last }: dort liegt nichts von { $signals }, die Zeit reicht von { $begins } bis { $ends } s
cli-prior-problem = --prior { $file }: { $problem }

## prior: what is known of other people in the same shirt. An own prior has an entry for each person; a release has sums over people only, and may leave the clinic.

cli-prior-one-table-each = Aufzeichnungen: { $recordings }, Tabellen mit Vorgaben: { $tables }. Geben Sie für jede Aufzeichnung eine Tabelle an.
cli-prior-add-to-release = { $prior } ist eine Fassung zur Weitergabe, mit Summen über Personen: Ergänzen Sie die eigene Starthilfe der Klinik
cli-prior-added =
    { $people ->
        [one] { $person } mit { $strokes } Bewegungen in { $prior } hinzugefügt, jetzt { $people } Person darin
       *[other] { $person } mit { $strokes } Bewegungen in { $prior } hinzugefügt, jetzt { $people } Personen darin
    }
cli-prior-replaced =
    { $people ->
        [one] { $person } mit { $strokes } Bewegungen in { $prior } ersetzt, jetzt { $people } Person darin
       *[other] { $person } mit { $strokes } Bewegungen in { $prior } ersetzt, jetzt { $people } Personen darin
    }
cli-prior-nobody = { $prior }: eine Person „{ $person }“ gibt es darin nicht
cli-prior-removed = { $person } aus { $prior } entfernt
cli-prior-own =
    { $people ->
        [one] { $prior }: eigene Starthilfe, mit einem Eintrag pro Person, { $people } Person in „{ $layout }“
       *[other] { $prior }: eigene Starthilfe, mit einem Eintrag pro Person, { $people } Personen in „{ $layout }“
    }
cli-prior-release = { $prior }: Fassung zur Weitergabe, nur Summen, { $people } Personen in „{ $layout }“
# Titles of columns.
cli-prior-movement = Gelenk und Geste
cli-prior-column-people = Pers.
cli-prior-column-seconds = Sek.
cli-prior-column-strokes = Beweg.
cli-prior-column-rate = Bewegungstempo
cli-prior-ranges = Bereiche der Kanäle, Einheit der Signale
# The prompted movement of a joint.
cli-prior-prompted = { $joint }, vorgegeben
cli-prior-rate-means = Bewegungstempo: Mittel und Abweichung bei einer Bewegung, als Anteile des Tempos, das voll zählt
cli-prior-ring =
    { $people ->
        [one] Ring { $ring }: wie er sitzt, ist von { $people } Person bekannt
       *[other] Ring { $ring }: wie er sitzt, ist von { $people } Personen bekannt
    }
cli-prior-too-few = Zu wenige zum Fahren: Für ein Gelenk sind { $people } Personen nötig
cli-prior-twice = { $prior } ist zweimal angegeben: Nennen Sie jede Starthilfe einmal
cli-prior-merged =
    { $people ->
        [one] { $people } Person in { $out }
       *[other] { $people } Personen in { $out }
    }
cli-prior-released = { $people } Personen in { $out }
# $names are codes of people, or names of joints, with commas between them
cli-prior-left-out = Nicht enthalten sind Gelenke, bei denen weniger als acht Personen noch in keiner Fassung zur Weitergabe sind: { $names }
cli-prior-exported =
    { $people ->
        [one] { $people } Person in { $out }, mit eigenem Eintrag. Die Datei darf die Klinik nicht verlassen.
       *[other] { $people } Personen in { $out }, jede mit eigenem Eintrag. Die Datei darf die Klinik nicht verlassen.
    }
cli-prior-sums =
    { $people ->
        [one] { $people } Person in { $out }: nur Summen. Die Datei darf die Klinik verlassen.
       *[other] { $people } Personen in { $out }: nur Summen. Die Datei darf die Klinik verlassen.
    }
cli-prior-sums-without =
    { $people ->
        [one] { $people } Person in { $out }: nur Summen. Die Datei darf die Klinik verlassen. Nicht enthalten sind Gelenke, bei denen weniger als acht Personen noch in keiner Fassung zur Weitergabe sind: { $names }.
       *[other] { $people } Personen in { $out }: nur Summen. Die Datei darf die Klinik verlassen. Nicht enthalten sind Gelenke, bei denen weniger als acht Personen noch in keiner Fassung zur Weitergabe sind: { $names }.
    }
cli-prior-import-release = { $prior } ist eine Fassung zur Weitergabe, mit Summen und ohne Einträge von Personen: Verwenden Sie sie mit `calibrate --prior`, und importieren Sie die eigene Starthilfe der Klinik
cli-prior-switched-off = In der Klinik ist die Starthilfe für neue Patienten ausgeschaltet: siehe „Einstellungen“
cli-prior-no-patient = { $prior }: einen Patienten „{ $code }“ gibt es in der Klinik nicht; niemand wurde importiert
# In quotation marks: a consent, as the page of the patient calls it.
cli-prior-no-consent = { $prior }: der Patient „{ $code }“ hat in „{ consent-clinic-prior }“ nicht eingewilligt; niemand wurde importiert
cli-prior-imported =
    { $people ->
        [one] { $people } Person aus { $prior } importiert
       *[other] { $people } Personen aus { $prior } importiert
    }
cli-prior-nobody-shares =
    { $people ->
        [one] In „{ $layout }“ ist { $people } Person bekannt, sie hat in „{ consent-sharing }“ nicht eingewilligt: Fragen Sie sie, und tragen Sie die Einwilligung auf der Seite des Patienten ein
       *[other] In „{ $layout }“ sind { $people } Personen bekannt, keine hat in „{ consent-sharing }“ eingewilligt: Fragen Sie sie, und tragen Sie die Einwilligung auf der Seite des Patienten ein
    }
cli-prior-nobody-known = In „{ $layout }“ ist niemand bekannt: Kalibrieren Sie darin Patienten, die in „{ consent-clinic-prior }“ eingewilligt haben
cli-prior-code = Der Code eines Patienten hat Zeichen, die in einer Starthilfe nicht stehen können: Verwenden Sie nur Buchstaben, Ziffern, Punkte und Bindestriche
cli-prior-no-release = Von denen, die in „{ consent-sharing }“ eingewilligt haben: { $problem }
cli-prior-was-read = { $file } ist eine Datei, die hierfür gelesen wurde: Geben Sie der Starthilfe einen anderen Namen
cli-prior-unwritable = { $file } kann nicht geschrieben werden ({ $reason }): Wählen Sie einen anderen Ort
cli-prior-person = --person { $person }: geben Sie 1 bis 64 Buchstaben, Ziffern, Punkte oder Bindestriche an

## backup and restore. $time is a day with a time of day.

cli-backup-made =
    { $name }: { $files } Dateien, { $size } MB, { $keys ->
        [with] mit den Schlüsseln von Rollstühlen, Shirts und Klinik
       *[without] ohne die Schlüssel von Rollstühlen, Shirts und Klinik
    }, { $encrypted ->
        [yes] verschlüsselt
       *[no] nicht verschlüsselt
    }. Das Backup wurde geprüft, und jeder Hashwert stimmt.
cli-backup-hash = Hashwert von allem: { $hash }
cli-backup-no-erased = Es gibt keine Datei { $file }. Geben Sie die Liste der endgültig gelöschten Patienten an, oder lassen Sie --erased weg.
cli-backup-clinic-open = Die Klinik in { $folder } ist geöffnet. Stellen Sie in einem leeren Ordner wieder her.
cli-restored-with-keys = Die Klinik von { $time } UTC ist in { $folder }: { $files } Dateien, { $size } MB, jede mit gleichem Hashwert. Die Schlüssel von Rollstühlen, Shirts und Klinik waren dabei.
cli-restored-without-keys = Die Klinik von { $time } UTC ist in { $folder }: { $files } Dateien, { $size } MB, jede mit gleichem Hashwert. Schlüssel waren nicht dabei. Koppeln Sie Rollstühle und Shirts neu.
cli-restored-erased =
    { $count ->
        [one] { $count } seither endgültig gelöschter Patient bleibt gelöscht.
       *[other] { $count } seither endgültig gelöschte Patienten bleiben gelöscht.
    }
cli-backup-whole = { $name } ist unversehrt: { $files } Dateien von { $time } UTC, jeder Hashwert stimmt.
cli-backup-is-folder = { $folder } ist ein Backup-Ordner. Geben Sie eine seiner Dateien an. Die neueste ist { $newest }.
cli-no-backup = Es gibt kein Backup { $file }. Geben Sie eine Datei an.
cli-passphrase-needed = Hierfür ist eine Passphrase nötig. Setzen Sie sie in die Umgebungsvariable { $variable }.
# A question; a colon follows.
cli-passphrase = Passphrase
cli-passphrase-short = Diese Passphrase ist zu kurz. Nehmen Sie { $least } oder mehr Zeichen.
# The progress of making a backup, in two steps.
cli-backup-step-store = Kopieren: { $done } von { $total } MB
cli-backup-step-verify = Prüfen: { $done } von { $total } MB
cli-backup-unlogged = Die Klinik hat eine andere Version als dieser Befehl, deshalb steht dieses Backup nicht in ihrem Protokoll.

## report, export, archive, incident

cli-report-suffix = --out { $file } endet weder mit .pdf noch mit .html. Geben Sie eines davon an.
# $problem says in a sentence or two that the patient has not consented, and that a copy for the patient needs no consent
cli-report-for-patient = { $problem } Für eine solche Kopie fügen Sie --for-patient hinzu.
cli-export-format = --format { $format }: Geben Sie eines von { $formats } an.
cli-export-step = Aufzeichnung { $done } von { $total }
cli-archive-made = { $file } ist geschrieben. Der Hashwert ist { $hash }.
cli-archive-imported = Patient { $code } ist importiert. Sitzungen: { $sessions }. Beendete Durchgänge, die zählen: { $trials }.
cli-archive-replaced = Patient { $code } ist ersetzt. Sitzungen: { $sessions }. Beendete Durchgänge, die zählen: { $trials }. Der frühere Stand wird 30 Tage in { $file } aufbewahrt.
cli-archive-again = Patient { $code } wurde schon früher aus diesem Archiv importiert. Nichts wurde geändert.
cli-incident-key = --public-key gehört zu --check. Lassen Sie es weg, oder prüfen Sie eine Vorkommnis-Datei.
cli-incident-no-folder = Es gibt keinen Ordner { $folder }. Legen Sie ihn an, oder wählen Sie einen anderen Ort.
# $start and $end are days with a time of day.
cli-incident-right = { $name }: Dateien: { $files }, Aufzeichnungen: { $recordings }, von { $start } bis { $end } UTC. Jeder Hashwert und die Signatur stimmen.
cli-incident-hash = Hashwert des Manifests: { $hash }
cli-incident-fingerprint = Fingerabdruck des Schlüssels: { $fingerprint }
cli-incident-kept = Patienten dieser Sitzungen werden erst endgültig gelöscht, wenn eine verantwortliche Person die Sperre aufhebt (Seite „Backup“).
