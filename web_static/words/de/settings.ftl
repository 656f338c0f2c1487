### Texte der Einstellungen: was Verantwortliche hier erlauben und welche Rollstühle gekoppelt sind.

prior-title = Starthilfe für neue Patienten
prior-lead = Aus jeder verwendeten Kalibrierung eines Patienten, der einwilligt, lernt das Programm, wie sich Menschen in diesem Shirt bewegen. Ein neuer Patient kann dann nach zehn Sekunden Bewegung den virtuellen Rollstuhl fahren.
prior-on = Aus verwendeten Kalibrierungen lernen
prior-few =
    { $count ->
        [one] Für das verwendete Shirt liegen Bewegungen von einem Patienten vor; { $needed } sind nötig.
       *[other] Für das verwendete Shirt liegen Bewegungen von { $count } Patienten vor; { $needed } sind nötig.
    }
prior-enough = Für das verwendete Shirt liegen Bewegungen von { $count } Patienten vor.
prior-off = Aus: Es wird nichts gelernt, und neue Patienten werden zuerst kalibriert.
settings-title = Einstellungen
settings-lead = Diese Einstellungen gelten für die ganze Klinik.
settings-read-only = Nur Verantwortliche können diese Einstellungen ändern.
limits-title = Grenzwerte der Klinik
limits-lead = Niemand fährt schneller als diese Werte. Ein Set mit höheren Werten behält sie, fährt aber innerhalb der Grenzwerte.
limits-saving = wird gespeichert …
limits-saved = gespeichert
log-lead = Das Protokoll zeigt, wer sich wann angemeldet hat, etwas angesehen oder geändert hat, gefahren ist oder gestoppt hat. Zeilen kommen hinzu, werden aber nie geändert oder entfernt.
log-checking = Das Protokoll wird geprüft …
log-check = Erneut prüfen
tablets-title = Tablets
tablets-lead = Ein weiteres Tablet oder ein weiterer Rechner öffnet diese Seiten verschlüsselt über das Netz der Klinik.
tablets-scan = Scannen Sie diesen Code mit dem Tablet, oder geben Sie die Adresse ein. Die Seite dort erklärt den Rest.
tablets-qr = QR-Code von { $url }
chairs-title = Rollstühle
chairs-lead = Ein gekoppelter Rollstuhl teilt einen geheimen Schlüssel mit diesem Programm und gehorcht sonst niemandem.
chairs-none = Noch kein Rollstuhl gekoppelt. Ohne ihn wird der virtuelle Rollstuhl gefahren.
chairs-address = { $host }, Port { $port }
chairs-facts = bis { $forward } m/s vorwärts, { $reverse } m/s rückwärts · gekoppelt { $when }
chairs-key = Schlüssel { $key }
chairs-pair = Rollstuhl koppeln
chairs-unpair = Entkoppeln
chairs-unpair-label = { $name } entkoppeln
chairs-unpair-title = „{ $name }“ entkoppeln?
chairs-unpair-lead = Der Schlüssel wird hier gelöscht. Dieses Programm kann den Rollstuhl dann nicht mehr fahren. Um ihn wieder zu fahren, koppeln Sie ihn neu.
chairs-unpaired = „{ $name }“ ist nicht mehr gekoppelt.
pair-title = Rollstuhl koppeln
pair-lead = Auf dem Rechner des Rollstuhls läuft der Empfänger. Er braucht einen Schlüssel, der jetzt erstellt wird.
pair-name = Name
pair-name-hint = Wie dieser Rollstuhl hier genannt wird.
pair-host = Adresse
pair-host-hint = Der Rechner des Rollstuhls in diesem Netz, zum Beispiel 192.168.1.40.
pair-port = Port
pair-port-hint = Dort wartet der Empfänger auf Daten. Üblich ist { $port }, wenn nichts anderes eingestellt wurde.
pair-speeds = Was dieser Rollstuhl darf
pair-speeds-hint = Es gilt der kleinste Grenzwert von Set, Klinik und Rollstuhl.
pair-go = Schlüssel erstellen
paired-title = Schlüssel von „{ $name }“ (wird nur einmal gezeigt)
paired-lead = Er wird nie wieder gezeigt, weder hier noch anderswo. Wer ihn hat, kann diesen Rollstuhl fahren. Geht er verloren, entkoppeln Sie den Rollstuhl, und koppeln Sie ihn neu.
paired-qr = QR-Code des Schlüssels von { $name }
paired-step-scan = Legen Sie auf dem Rechner des Rollstuhls eine Datei an, die nur Sie lesen können. Schreiben Sie die Zeile dieses Codes hinein, und drücken Sie dann die Eingabetaste und Strg-D:
paired-step-start = Starten Sie den Empfänger damit:
paired-outputs = Welchen Ausgang Ihr Rollstuhl statt ros2 braucht
paired-step-look = Sehen Sie auf der Seite „Fahren“ nach: Dort antwortet der Rollstuhl innerhalb einer Sekunde.
paired-line = Schlüsselzeile, zum Abtippen oder Kopieren
paired-copy = Schlüsselzeile kopieren
paired-copied = Die Schlüsselzeile wurde kopiert. Leeren Sie die Zwischenablage, wenn der Schlüssel auf dem Rollstuhl ist.
paired-copy-failed = Dieser Browser erlaubt der Seite das Kopieren nicht. Markieren Sie die Zeile, und kopieren Sie sie selbst.
paired-done = Schlüssel ist übertragen
