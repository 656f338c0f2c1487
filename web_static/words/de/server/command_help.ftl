### The help of the command line, `bodydrive COMMAND --help`. Each message is one line without values.
### Words that begin with --, words in capitals and names of files are typed on the command line: they are not translated.

## Every command

cli-help-program = Körper-Maschine-Schnittstelle für Elektrorollstühle: kalibrieren, üben, messen, fahren.
cli-help-version = Die Version nennen und das Programm beenden.
cli-help-state = Der Ordner mit der Datenbank und den Aufzeichnungen der Klinik.
cli-help-json = Ein einziges JSON-Objekt ausgeben und sonst nichts.

## demo and serve

cli-help-demo = Eine Klinik zur Vorführung öffnen, die nicht aufbewahrt wird: ein simuliertes Shirt, ein Patient und der virtuelle Rollstuhl.
cli-help-serve = Eine Klinik öffnen; ihre Datenbank und ihre Aufzeichnungen bleiben erhalten.
cli-help-port = Der Port der Seiten; 0 nimmt irgendeinen freien.
cli-help-demo-host = Die Adresse der Seiten, eine von diesem Rechner allein.
cli-help-demo-floorplan = Ein eigener Grundriss, in dem man auch fahren kann.
cli-help-serve-host = Die Adresse der Seiten; mit --lan eine oder mehrere dieses Rechners statt aller.
cli-help-serve-lan = Die Klinik für Tablets in diesem Netz öffnen, über https.
cli-help-serve-certificate = Ein eigenes Zertifikat für --lan: eine PEM-Datei mit seiner Kette.
cli-help-serve-key = Der private Schlüssel dieses Zertifikats: eine PEM-Datei.
cli-help-serve-behind-proxy = Die Adresse des Reverse-Proxys der Klinik, des einzigen Zugangs; braucht --name.
cli-help-serve-name = Der Name, oder NAME:PORT, unter dem Browser den Proxy erreichen.
cli-help-serve-lsl = Fahrbefehle, Gesten und Marker über LSL an LabRecorder senden; jeder im Netz kann sie lesen.

## check and service

cli-help-check = Messen, was dieser Rechner bietet, und sagen, ob er zum Fahren gut genug ist; wenn nicht, ist der Exit-Code 1.
cli-help-check-seconds = Wie lange die Regelschleife gemessen wird.
cli-help-check-own-port = Ein Port der Klinik, die gerade läuft, statt der beiden üblichen.
cli-help-service = Den Rechner die Klinik von selbst starten lassen.
cli-help-service-install = Eine systemd-Unit installieren, die `bodydrive serve --lan` ausführt, und sie starten.
cli-help-service-install-system = Eine Unit des Systems, die mit dem Rechner startet; braucht sudo.
cli-help-service-install-account = Mit --system: das Konto, dem die Klinik gehört, nicht root.
cli-help-service-install-print = Die Unit ausgeben und nichts ändern.

## calibrate and decode. A column of a CSV file, such as start, is not translated.

cli-help-signals = CSV, Parquet, XLSX, MATLAB, C3D, EDF, XDF oder BVH, oder der Ordner einer Aufzeichnung.
cli-help-signals-command = Zeigen, was eine Datei mit Signalen enthält, bevor sie verwendet wird.
cli-help-signals-show = Zeigen, was eine Datei mit Signalen enthält: Spalten, Zeit mit ihrer Einheit, Abtastrate, Kanäle und Gelenke.
cli-help-signals-layout = Das Layout des Shirts, JSON; ohne diese Option das neben der Datei.
cli-help-signals-out = Wohin die Signale geschrieben werden, so wie sie gelesen werden: eine Datei .parquet mit t in Sekunden.
cli-help-signals-time = Die Spalte mit den Zeiten; leer, wenn keine stimmt und --rate gilt.
cli-help-signals-unit = Die Einheit der Zeiten: s, ms, us, ns, min, h oder d.
cli-help-signals-rate = Die Abtastrate, Hz: die Abtastwerte sind gleichmäßig, was auch immer ihre Zeiten sagen.
cli-help-signals-channels = Die Spalten der Kanäle, in der Reihenfolge des Layouts.
cli-help-signals-part = Der Datenstrom oder das Blatt, das allein gelesen wird, mit seinem Namen.
cli-help-layout = Das Layout des Shirts, JSON.
cli-help-calibrate = Ein Kalibrierungsprofil aus einer Datei mit Signalen berechnen: für jedes Gelenk Hauptbewegung, Bereich, Vorzeichen und Schwellenwerte.
cli-help-calibrate-out = Wohin das Kalibrierungsprofil geschrieben wird, JSON.
cli-help-calibrate-prompts = CSV start,end,joint: wann sich welches Gelenk zu seiner Geste hin bewegt hat; jede Zeile zählt. Legt das Vorzeichen fest.
cli-help-calibrate-from = Wo die freie Bewegung beginnt, s.
cli-help-calibrate-to = Wo die freie Bewegung endet, s.
cli-help-calibrate-rest-from = Wo die Ruhe beginnt, s.
cli-help-calibrate-rest-to = Wo die Ruhe endet, s.
cli-help-calibrate-unused = Ein Kanal, der nicht verwendet wird; darf mehrmals stehen.
cli-help-calibrate-prior = Was `bodydrive prior` über andere Personen im gleichen Shirt geschrieben hat.
cli-help-calibrate-map = Mit welcher Kalibrierung gefahren wird: Standard, aus den Vorgaben gelernt, von anderen Personen, oder die beste.
cli-help-calibrate-gestures = Alle gefundenen Gesten, hin und zurück, nach ihrer Güte ordnen und vier vorschlagen.
cli-help-decode = Eine Datei mit Signalen genau so dekodieren wie die Regelschleife.
cli-help-decode-profile = Was `bodydrive calibrate` geschrieben hat, oder ein gespeichertes Set.
cli-help-decode-out = Wohin die Fahrbefehle geschrieben werden: .parquet oder .csv.
cli-help-decode-dead-zone = Ab wo jede Geste zählt, in vollen Bewegungen pro Sekunde.
cli-help-decode-cutoff = Tremordämpfung, Hz: ein kleinerer Wert dämpft stärker.

## prior

cli-help-prior = Von anderen Personen im gleichen Shirt lernen, damit jemand Neues schon vor der eigenen Kalibrierung fährt.
cli-help-prior-file = Die Starthilfe; gibt es keine, wird sie angelegt.
cli-help-prior-person = Ein Code der Person: Buchstaben, Ziffern, Punkte und Bindestriche, kein Name.
cli-help-prior-add = Die Aufzeichnungen einer Person zu einer Starthilfe hinzufügen. Wer schon darin ist, wird ersetzt.
cli-help-prior-add-signals = CSV, Parquet oder der Ordner einer Aufzeichnung; alle Aufzeichnungen der Person.
cli-help-prior-add-prompts = CSV start,end,joint: wann sich welches Gelenk zu seiner Geste hin bewegt hat. Eine für jede von SIGNALS.
cli-help-prior-add-from = Wo zehn Sekunden freier Bewegung beginnen, s.
cli-help-prior-remove = Eine Person aus einer Starthilfe entfernen, als wäre sie nie hinzugefügt worden.
cli-help-prior-show = Für jedes Gelenk und jede Geste zeigen, was eine Starthilfe weiß: Personen, Sekunden, Bewegungen und ihr Tempo, Bereiche der Kanäle.
cli-help-prior-merge = Starthilfen zusammenzählen. Das Ergebnis hat Summen über acht oder mehr Personen und von niemandem einen Eintrag: Es darf die Klinik verlassen.
# A further paragraph.
cli-help-prior-merge-released = Eine eigene Starthilfe merkt sich, wer in einer Fassung zur Weitergabe ist, denn niemand darf in zweien sein: Von einer gewachsenen Starthilfe werden nur die neuen Personen weitergegeben, und die Fassungen werden zusammengezählt. Dafür werden die Dateien der eigenen Starthilfen, die weitergegeben werden, neu geschrieben.
cli-help-prior-merge-priors = Eigene Starthilfen oder Fassungen zur Weitergabe.
cli-help-prior-merge-out = Wohin das Ergebnis geschrieben wird: eine .json-Datei.
cli-help-prior-merge-own = Für jede Person einen Eintrag behalten. Das Ergebnis darf die Klinik nicht verlassen.
cli-help-prior-export = Schreiben, was die Klinik von Patienten in einem getragenen Shirt weiß. Ohne --release darf es die Klinik nicht verlassen.
cli-help-prior-export-out = Wohin die Starthilfe geschrieben wird.
cli-help-prior-export-layout = Das Layout des getragenen Shirts, JSON.
cli-help-prior-export-release = Nur Summen über acht oder mehr Personen, die alle in die Weitergabe eingewilligt haben.
cli-help-prior-import = Die eigene Starthilfe einer Klinik übernehmen: für alle ihre Personen oder für niemanden. Was über sie bekannt ist, wird ersetzt.
cli-help-prior-import-file = Die eigene Starthilfe einer Klinik, wie `export` sie schreibt.

## score, study, replay and floorplan

cli-help-score = Eine Fahrspur an einer vorgegebenen Strecke messen; s und m.
# A further paragraph.
cli-help-score-following = Eine Fahrspur, die auf der Strecke nicht weiter vorn endet, als sie begonnen hat, und nicht am Ziel, hat keine Messwerte dafür, wie gut sie folgt. Zwei Schleifen um dieselbe Stelle in Gegenrichtung heben sich in der Fläche neben der Strecke auf; der gefahrene Weg zählt beide.
cli-help-score-trajectory = CSV oder Parquet mit den Spalten t, x, y; TUM, EuRoC oder KITTI; ein Bag von ROS oder MCAP.
cli-help-score-path = CSV oder Parquet mit den Spalten x, y: die Punkte der Strecke.
cli-help-score-goal-radius = Wie nah am Ende der Strecke das Ziel als erreicht gilt, m.
cli-help-study = Eine simulierte Person kalibrieren und dann immer wieder eine Strecke fahren lassen, und jeden Durchgang messen.
cli-help-study-out = Der Ordner, in den geschrieben wird; er muss neu oder leer sein.
cli-help-study-trials = Wie oft die Strecke gefahren wird: 22-mal, oder 3-mal pro Sitzung.
cli-help-study-seed = Der gleiche Seed ergibt die gleichen Zahlen.
cli-help-study-seeds = Wie viele Personen, ab --seed.
cli-help-study-floorplan = Name eines mitgelieferten Grundrisses, oder eine JSON-Datei.
cli-help-study-path = Name einer Strecke darin; ohne Angabe die erste.
cli-help-study-format = Der Abbildungen; none lässt sie weg.
cli-help-study-no-learning = Nichts, was geübt wird, bleibt.
cli-help-study-overwrite = Ersetzen, was der Ordner enthält.
cli-help-study-adapt = Über mehrere Sitzungen: die Kalibrierung der Person folgen lassen, im Vergleich mit einer festen.
cli-help-study-person = Über mehrere Sitzungen: was mit Körper oder Shirt geschieht.
cli-help-study-map = Mit --adapt: Standardkalibrierung, oder was Vorgaben oder andere Personen lehren.
cli-help-study-sessions = Wie viele, mit --adapt oder --interface-test.
cli-help-study-interface-test = Über mehrere Sitzungen: der Zwei-Minuten-Test vor den Durchgängen jeder Sitzung.
cli-help-study-jobs = Prozesse zugleich; ohne Angabe so viele wie Prozessoren.
cli-help-replay = Eine Aufzeichnung senden, wie ein Shirt es täte: ihre Datenpakete als Datagramme, zu ihren eigenen Zeiten. Strg-C beendet das Senden.
cli-help-replay-recording = Ordner einer Aufzeichnung, CSV oder Parquet.
cli-help-replay-to = Wohin die Datagramme gehen, HOST:PORT.
cli-help-replay-loop = Am Ende von vorn beginnen.
cli-help-replay-speed = Wievielmal so schnell, wie aufgezeichnet wurde.
cli-help-floorplan = Die mitgelieferten Orte auflisten, einen prüfen, oder einen aus einer Datei erstellen.
cli-help-floorplan-import = Einen Grundriss aus einer ROS-Karte, einer DXF-Zeichnung oder einem Bild erstellen: Wände und eine Strecke zum Fahren.
cli-help-floorplan-import-file = MAP.yaml einer ROS-Karte, eine DXF-Zeichnung, oder ein Bild als PNG oder JPEG.
cli-help-floorplan-import-out = Wohin der Grundriss geschrieben wird: eine .json-Datei.
cli-help-floorplan-import-name = Der Name des Grundrisses: Buchstaben, Ziffern, Punkte, Bindestriche.
cli-help-floorplan-import-title = Der Titel, den man liest.
# The units are typed.
cli-help-floorplan-import-unit = Einer Zeichnung, die keine nennt: mm, cm, m, inch oder foot.
cli-help-floorplan-import-layer = Eine Ebene der Zeichnung mit Wänden; darf mehrmals stehen.
cli-help-floorplan-import-metres-per-pixel = Der Maßstab eines Bildes.
cli-help-floorplan-import-width = Oder wie breit das ganze Bild ist, m.
cli-help-floorplan-import-threshold = Ein Pixel, das heller ist als dieser Anteil von Weiß, ist frei.
cli-help-floorplan-import-outside = Eine Karte oder ein Bild: auch verwenden, was vom Rand aus erreichbar ist.
cli-help-floorplan-list = Auflisten, was zum Fahren mitgeliefert wird: Szenen nach Stufe, Gebäude, und ihre Aufgaben.
cli-help-floorplan-check = Sagen, ob man in einem Grundriss oder einer Szene fahren kann, und wenn nicht, was wo falsch ist.
cli-help-floorplan-check-file = Ein Grundriss oder eine Szene.

## chair and shirt

cli-help-chair = Einen echten Rollstuhl koppeln; auf dem Rollstuhl empfangen, was er fahren soll.
cli-help-chair-receive = Auf dem Rollstuhl: Fahrbefehle prüfen, die Zeit überwachen, Geschwindigkeiten allmählich ändern und einen Ausgang ansteuern.
cli-help-chair-measure = Auf dem Rollstuhl: mit kurzen Fahrten messen, welche Geschwindigkeit ein Ausschlag seines Joysticks ergibt.
cli-help-chair-rehearse = Ohne Rollstuhl üben: freigeben, fahren, anhalten, den Schalter drücken, Kabel eines nachgebildeten Rollstuhls ziehen.
cli-help-chair-rehearse-record = Jeder Schritt sagt, was in wie vielen Millisekunden geschehen muss. Das Protokoll wird mit dem Schlüssel des Rollstuhls unterschrieben.
cli-help-chair-rehearse-key-file = Der Schlüssel des Rollstuhls, wie ihn das Koppeln erzeugt hat.
cli-help-chair-rehearse-out = Wohin das Protokoll kommt: eine .json-Datei; eine .md-Datei daneben ist zum Lesen.
cli-help-chair-rehearse-who = Wer das tut: steht im Protokoll.
cli-help-chair-rehearse-output = Was nachgebildet wird: sim oder whill.
cli-help-chair-rehearse-verify = Stattdessen das Protokoll in --out prüfen: ob es so ist, wie es unterschrieben wurde.
cli-help-chair-pair = Einen Schlüssel für einen Rollstuhl erzeugen, bei der Klinik aufbewahren und einmal als QR-Code zeigen.
# A further paragraph.
cli-help-chair-pair-units = Geschwindigkeiten stehen in m/s und rad/s, Beschleunigungen in m/s2 und rad/s2, Rucke in m/s3 und rad/s3.
cli-help-chair-pair-name = Wie der Rollstuhl genannt wird.
cli-help-chair-pair-host = Die Adresse, unter der dieser Rechner den Rollstuhl erreicht.
cli-help-chair-pair-port = Der Port seines Empfängers.
# Of a speed, an acceleration or a jerk.
cli-help-chair-pair-limit = Was dieser Rollstuhl höchstens darf; ohne Angabe ein vorsichtiger Standard.
cli-help-shirt = Ein Shirt über das Netz koppeln; senden, wie ein solches Shirt es tut.
cli-help-shirt-send = Eine Datei oder langsame Wellen senden, wie ein gekoppeltes Shirt es tut: das Beispiel für die Firmware eines Shirts.
cli-help-shirt-pair = Einen Schlüssel für ein Shirt erzeugen, bei der Klinik aufbewahren und einmal als QR-Code zeigen.

## people, log and about

cli-help-people = Die Personen einer Klinik ansehen, einladen, sperren und entsperren; einen Link für ein neues Passwort erzeugen.
cli-help-people-name = Der Name, mit dem sich die Person anmeldet.
# The roles are typed.
cli-help-people-role = owner, clinician oder reviewer.
cli-help-people-patient = Der Code eines Patienten, den eine mitlesende Person sehen darf, einmal für jeden; ohne Angabe alle.
cli-help-people-address = Die Adresse der Seiten, für den Link; ohne Angabe die des laufenden Programms.
cli-help-people-list = Die Personen der Klinik auflisten: Name, Rolle, was Mitlesende sehen dürfen, ob sie sich anmelden können.
cli-help-people-invite = Eine Person hinzufügen und den Link ausgeben, mit dem sie innerhalb von 24 Stunden ein Passwort wählt.
# A further paragraph.
cli-help-people-invite-again = Für jemanden, den es schon gibt, erzeugt der Link ein neues Passwort; Rolle und Patienten bleiben.
cli-help-people-disable = Eine Person nicht mehr anmelden lassen; ihre offenen Seiten enden innerhalb von 5 s.
cli-help-people-enable = Eine gesperrte Person wieder anmelden lassen.
cli-help-log = Das Protokoll einer Klinik ansehen: wer wann was getan hat.
cli-help-log-verify = Prüfen, dass keine Zeile des Protokolls geändert, verschoben, eingefügt oder entfernt wurde; die Klinik darf dabei geöffnet sein.
# A further paragraph.
cli-help-log-verify-exit = Der Exit-Code ist 0, wenn das Protokoll unversehrt ist, 1, wenn es verändert wurde, 2, wenn es nicht gelesen werden kann.
cli-help-about = Sagen, welche Version dies ist, wie sie gebaut wurde, und welche Pakete sie verwendet.
cli-help-about-licences = Ihre Pakete und die Arbeit anderer in ihren Dateien auflisten, mit Lizenzen.

## report, export, archive, backup, restore and incident

cli-help-patient = Der Code des Patienten.
cli-help-report = Den Bericht über eine Sitzung eines Patienten schreiben, oder über alle; die Klinik darf dabei geöffnet sein.
cli-help-report-out = Die Datei, die geschrieben wird; sie endet mit .pdf oder .html.
cli-help-report-session = Die Nummer einer Sitzung; ohne Angabe der Verlauf aller Sitzungen.
cli-help-report-letter = Papier im Format Letter statt A4.
cli-help-report-for-patient = Eine Kopie für den Patienten: braucht keine Einwilligung in die Weitergabe nach außen.
cli-help-report-language = Die Sprache des Berichts; ohne Angabe die des Terminals.
cli-help-export = Aufzeichnungen und Messwerte eines Patienten exportieren; die Klinik darf dabei geöffnet sein. Der Patient muss eingewilligt haben.
cli-help-export-out = Die zip-Datei, die geschrieben wird.
cli-help-export-format = Das Format der Dateien darin.
cli-help-export-session = Die Nummer einer Sitzung; ohne Angabe alle Sitzungen.
cli-help-archive = Alles von einem Patienten in eine andere Klinik bringen: Sitzungen, Steuerung, Durchgänge, Aufzeichnungen.
cli-help-archive-make = Das Archiv eines Patienten schreiben, der eingewilligt haben muss; die Klinik darf dabei geöffnet sein.
cli-help-archive-make-out = Das Archiv, das geschrieben wird.
cli-help-archive-import = Ein Archiv importieren; dasselbe noch einmal ändert nichts.
cli-help-archive-import-file = Das Archiv.
cli-help-archive-import-replace = Den Patienten ersetzen, den es hier schon gibt; vorher wird ein Archiv von ihm aufbewahrt.
cli-help-backup = Eine Klinik sichern, auch während sie geöffnet ist, und das Backup prüfen; in einen Ordner wird nur geschrieben, was neu ist.
cli-help-backup-file = Die Datei, die erstellt wird, oder ein Backup-Ordner.
cli-help-backup-encrypt = Mit einer Passphrase verschlüsseln, nach der gefragt wird oder die in BODYDRIVE_PASSPHRASE steht.
cli-help-backup-with-keys = Auch die Schlüssel der Rollstühle und der Klinik sichern.
cli-help-backup-check = Keines erstellen: das Backup FILE lesen und ganz prüfen.
cli-help-restore = Eine Klinik in einem leeren Ordner wiederherstellen: jede Datei mit gleichem Hashwert, ohne die seither endgültig gelöschten Patienten.
cli-help-restore-file = Ein Backup; aus einem Backup-Ordner eine seiner Dateien.
cli-help-restore-erased = Eine neuere erased-patients.json, damit diese Patienten gelöscht bleiben.
cli-help-incident = Protokoll, Aufzeichnungen, Parameter und Versionen der letzten 24 Stunden signiert archivieren, und sie zum Aufbewahren sperren.
cli-help-incident-file = Das Archiv, das erstellt oder mit --check gelesen wird.
cli-help-incident-check = Keines erstellen: jeden Hashwert und die Signatur des Archivs FILE prüfen.
cli-help-incident-public-key = Mit --check: der öffentliche Schlüssel der Klinik (PEM), nicht der im Archiv.
