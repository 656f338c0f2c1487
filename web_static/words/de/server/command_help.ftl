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

cli-help-calibrate = Ein Kalibrierungsprofil aus einer Datei mit Signalen berechnen: für jedes Gelenk Hauptbewegung, Bereich, Vorzeichen und Schwellenwerte.
cli-help-decode = Eine Datei mit Signalen genau so dekodieren wie die Regelschleife.

## prior

cli-help-prior = Von anderen Personen im gleichen Shirt lernen, damit jemand Neues schon vor der eigenen Kalibrierung fährt.

## score, study, replay and floorplan

cli-help-score = Eine Fahrspur an einer vorgegebenen Strecke messen; s und m.
# A further paragraph.
cli-help-score-following = Eine Fahrspur, die auf der Strecke nicht weiter vorn endet, als sie begonnen hat, und nicht am Ziel, hat keine Messwerte dafür, wie gut sie folgt. Zwei Schleifen um dieselbe Stelle in Gegenrichtung heben sich in der Fläche neben der Strecke auf; der gefahrene Weg zählt beide.
cli-help-study = Eine simulierte Person kalibrieren und dann immer wieder eine Strecke fahren lassen, und jeden Durchgang messen.
cli-help-replay = Eine Aufzeichnung senden, wie ein Shirt es täte: ihre Datenpakete als Datagramme, zu ihren eigenen Zeiten. Strg-C beendet das Senden.
cli-help-floorplan = Die mitgelieferten Orte auflisten, einen prüfen, oder einen aus einer Datei erstellen.

## chair and shirt

cli-help-chair = Einen echten Rollstuhl koppeln; auf dem Rollstuhl empfangen, was er fahren soll.
cli-help-shirt = Ein Shirt über das Netz koppeln; senden, wie ein solches Shirt es tut.

## people, log and about

cli-help-people = Die Personen einer Klinik ansehen, einladen, sperren und entsperren; einen Link für ein neues Passwort erzeugen.
cli-help-log = Das Protokoll einer Klinik ansehen: wer wann was getan hat.
cli-help-about = Sagen, welche Version dies ist, wie sie gebaut wurde, und welche Pakete sie verwendet.

## report, export, archive, backup, restore and incident

cli-help-report = Den Bericht über eine Sitzung eines Patienten schreiben, oder über alle; die Klinik darf dabei geöffnet sein.
cli-help-export = Aufzeichnungen und Messwerte eines Patienten exportieren; die Klinik darf dabei geöffnet sein. Der Patient muss eingewilligt haben.
cli-help-archive = Alles von einem Patienten in eine andere Klinik bringen: Sitzungen, Steuerung, Durchgänge, Aufzeichnungen.
cli-help-backup = Eine Klinik sichern, auch während sie geöffnet ist, und das Backup prüfen; in einen Ordner wird nur geschrieben, was neu ist.
cli-help-restore = Eine Klinik in einem leeren Ordner wiederherstellen: jede Datei mit gleichem Hashwert, ohne die seither endgültig gelöschten Patienten.
cli-help-incident = Protokoll, Aufzeichnungen, Parameter und Versionen der letzten 24 Stunden signiert archivieren, und sie zum Aufbewahren sperren.
