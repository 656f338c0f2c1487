### Texts about the computer that runs the program: what `bodydrive check` and the page "This computer" find, the
### clinic's certificates, and the installation of a service.

## What was measured. The control loop computes once each period, a tick, and should never be late.

host-lateness-good = Takte der Regelschleife, die mehr als { $limit } ms zu spät kamen: { $late } von { $ticks }. 99 von 100 kamen innerhalb von { $most } ms, der späteste nach { $latest } ms.
host-lateness-attention = Takte der Regelschleife, die mehr als { $limit } ms zu spät kamen: { $late } von { $ticks }. 99 von 100 kamen innerhalb von { $most } ms, der späteste nach { $latest } ms. Schließen Sie beim Fahren andere Programme.
host-lateness-bad = Takte der Regelschleife, die mehr als { $limit } ms zu spät kamen: { $late } von { $ticks }. 99 von 100 kamen innerhalb von { $most } ms, der späteste nach { $latest } ms. Dieser Rechner ist zu stark ausgelastet oder zu langsam, um einen Rollstuhl zu fahren.
host-disk-good = Auf dem Datenträger sind { $free } GB frei.
host-disk-attention = Auf dem Datenträger sind { $free } GB frei. Schaffen Sie bald Platz.
host-disk-bad = Auf dem Datenträger sind { $free } GB frei. Es kann nichts aufgezeichnet werden. Schaffen Sie Platz.
# $time is a day with a time of day.
host-clock = Die Uhr zeigt { $time } UTC.
host-clock-early = Die Uhr zeigt { $time } UTC, aber das Programm wurde später installiert. Stellen Sie die Uhr.
host-clock-kept = Die Uhr zeigt { $time } UTC, und ein Zeitserver hält sie richtig.
host-clock-not-kept = Die Uhr zeigt { $time } UTC, und kein Zeitserver hält sie richtig. Vergleichen Sie sie ab und zu mit einer anderen Uhr.
host-port-own = Port { $port } ist der dieser Klinik.
host-port-of-system = Port { $port } ist dem System vorbehalten: Dieses Konto darf ihn nicht verwenden.
host-port-in-use = Port { $port } ist belegt, vielleicht durch die Klinik selbst.
host-port-free = Port { $port } ist frei.
host-compiled = Die Berechnungen der Regelschleife laufen kompiliert.
host-not-compiled = Die Berechnungen der Regelschleife laufen als reines Python: mit gleichen Ergebnissen, aber langsamer.
# $name says whose screen it is, such as: The page of Ada
host-screen-silent = { $name }: keine Antwort. Die Seite ist verdeckt, oder das Gerät ist gesperrt oder im Ruhezustand.
host-screen-good = { $name }: { $rate } Bilder pro Sekunde.
host-screen-slow = { $name }: { $rate } Bilder pro Sekunde. Schließen Sie dort andere Programme, oder wählen Sie die Planansicht.
host-summary-good = Dieser Rechner ist zum Fahren gut genug.
host-summary-attention = Dieser Rechner ist zum Fahren gut genug, und etwas könnte besser sein.
host-summary-bad = Dieser Rechner ist so zum Fahren nicht gut genug.

## Certificates: files and the days on which they begin or end

host-authority-made = Für diese Klinik wurde eine Zertifizierungsstelle erstellt. Sie wird auf jedem Tablet einmal installiert, wie die Seite unten erklärt.
host-authority-replaced = Die Zertifizierungsstelle der Klinik wurde ersetzt. Jedes Tablet braucht die neue, wie die Seite unten erklärt. Die alte lässt sich dort entfernen.
host-authority-damaged = Die Zertifizierungsstelle der Klinik in { $file } ist beschädigt. Holen Sie diese Datei aus einem Backup zurück. Oder löschen Sie sie, und installieren Sie die neue Zertifizierungsstelle auf jedem Tablet.
host-authority-ended = Die Zertifizierungsstelle der Klinik in { $file } ist am { $day } abgelaufen. Löschen Sie diese Datei, starten Sie das Programm neu, und installieren Sie die neue Zertifizierungsstelle auf jedem Tablet. (Ist heute nicht der { $today }, stellen Sie stattdessen die Uhr dieses Rechners.)
host-authority-ends-soon = Die Zertifizierungsstelle der Klinik läuft am { $day } ab. Löschen Sie vorher { $file }, und richten Sie jedes Tablet neu ein.
host-authority-early-clock = Die Uhr dieses Rechners zeigt { $today }, aber die Zertifizierungsstelle der Klinik wurde später erstellt, am { $day }. Stellen Sie die Uhr, und starten Sie das Programm dann neu.
# $names are names and addresses of the machine, with commas between them
host-authority-outside = Die Zertifizierungsstelle der Klinik darf nicht für { $names } bürgen, denn als sie erstellt wurde, gab es dies an diesem Rechner noch nicht. Öffnen Sie die Seiten über eine andere Adresse, oder löschen Sie { $file }, und richten Sie jedes Tablet neu ein.
host-certificate-not-renewed = Das Zertifikat des Rechners läuft am { $day } ab und konnte nicht erneuert werden ({ $why }). Schaffen Sie Platz auf dem Datenträger.
host-certificate-ends-soon = Das Zertifikat { $file } läuft am { $day } ab. Ersetzen Sie es durch ein neues.
host-certificate-unreadable = { $file } ist nicht lesbar ({ $why }). Geben Sie die Dateien Ihres Zertifikats an.
host-certificate-no-pair = { $certificate } und { $key } sind kein Zertifikat mit seinem Schlüssel: Beide müssen PEM-Dateien sein und zusammengehören, und der Schlüssel darf keine Passphrase haben.
host-certificate-ended = Das Zertifikat { $file } ist am { $day } abgelaufen, und die Uhr dieses Rechners zeigt { $today }. Ersetzen Sie die Datei durch ein neues Zertifikat, oder stellen Sie die Uhr.
host-certificate-early-clock = Das Zertifikat { $file } gilt ab { $day }, und die Uhr dieses Rechners zeigt { $today }. Stellen Sie die Uhr.
# The name of the certificate in the settings of a device.
host-authority-title = bodydrive auf { $machine }, erstellt am { $day }
# Stands for $machine when the machine has no name.
host-nameless-machine = diesem Rechner
# The settings of an iPad show these two, of the file that lets it trust the clinic's machine.
host-profile-title = bodydrive auf { $machine }
host-profile-explanation = Damit vertraut dieses Gerät dem Rechner Ihrer Klinik, auf dem bodydrive läuft, und sonst nichts: Das Zertifikat gilt nur für diesen Rechner und für private Netze.

## The service that starts the clinic with the machine

# What systemd says of the service.
host-service-description = bodydrive: die Klinik in { $folder }
host-service-no-systemd = Dieser Rechner hat kein systemd. Lassen Sie ihn den Befehl von --print auf seine eigene Weise starten.
host-service-unwritable = { $file } kann nicht geschrieben werden ({ $why }). Mit --system rufen Sie dies mit sudo auf.
host-service-refused = { $file } ist geschrieben, aber systemd hat die Datei nicht angenommen ({ $why }). Beheben Sie das, und versuchen Sie es dann noch einmal.
# Stands in brackets when systemd gives no reason.
host-service-exit-code = Exit-Code { $code }
host-service-installed = { $file } ist installiert und gestartet; „{ $command }“ zeigt den Zustand.
host-service-starts-at-sign-in = Der Dienst startet, wenn Sie sich anmelden. Mit „loginctl enable-linger“ startet er mit dem Rechner.
