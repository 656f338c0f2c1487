### Texte zum Export der Aufzeichnungen und Messwerte eines Patienten und zum Import eines Archivs.

export-title = Export für andere Programme
export-lead = Aufzeichnungen und Messwerte als eine ZIP-Datei. Sie nennt den Patienten nur mit dem Code und gibt an, was simuliert war.
export-form = Format
export-form-csv = CSV: für Tabellenprogramme
export-form-parquet = Parquet: für Python und R
export-form-xdf = XDF: für Labore, die Bewegung messen
export-form-bids = BIDS-Motion: für Forschungsdatenarchive
export-form-fhir = FHIR: Messwerte für die Krankenhausakte
export-form-archive = Archiv: alles, für eine andere Klinik mit bodydrive
export-what = Sitzungen
export-all = Alle Sitzungen
export-session = Sitzung { $number }
export-go = Exportieren
export-go-label = Exportieren: { $code }
export-wait = Lange Aufzeichnungen brauchen eine Minute oder mehr. Im Protokoll steht, wer was exportiert hat.
export-progress = Fortschritt des Exports
export-begun = Der Export beginnt.
export-state-going-on = Aufzeichnungen gepackt: { $packed } von { $recordings }. Gesendet: { $size }.
export-state-complete = Der Export ist vollständig: { $size }.
export-state-broken-off = Der Export wurde abgebrochen, und die Datei ist unvollständig. Exportieren Sie erneut.
export-csv-how = Spalten sind durch Kommas getrennt, Zahlen haben einen Dezimalpunkt. Ein Tabellenprogramm mit Dezimalkomma fragt, wie es die Datei öffnen soll. Wählen Sie dort UTF-8 und Englisch.
export-archive-how = Die Aufzeichnungen brauchen { $size }. Verantwortliche der anderen Klinik importieren die Datei dort auf der Seite „Patienten“.
export-archive-open = Eine Sitzung dieses Patienten ist offen. Beenden Sie sie, bevor Sie das Archiv erstellen.
export-consent = Für einen Export muss der Patient in die Weitergabe nach außen einwilligen. Fragen Sie ihn, und tragen Sie die Einwilligung oben ein.
import-go = Archiv importieren
import-under-way = { $name } wird gesendet und geprüft. Große Aufzeichnungen brauchen Minuten. Lassen Sie diese Seite offen.
import-progress = Fortschritt dieses Schritts
import-send = Senden: { $done } von { $total }
import-unpack = Prüfen und Entpacken: { $done } von { $total }
import-done =
    Patient { $code } ist importiert: { $sessions ->
        [one] { $sessions } Sitzung
       *[other] { $sessions } Sitzungen
    }, { $trials ->
        [one] { $trials } Durchgang
       *[other] { $trials } Durchgänge
    }.
import-replace = Patient ersetzen
import-kept = Alles, was hier zu diesem Patienten gespeichert ist, wird durch den Inhalt des Archivs ersetzt. Vorher wird ein Archiv des jetzigen Stands erstellt und 30 Tage aufbewahrt.
import-replaced =
    { $code } ist ersetzt: { $sessions ->
        [one] { $sessions } Sitzung
       *[other] { $sessions } Sitzungen
    }, { $trials ->
        [one] { $trials } Durchgang
       *[other] { $trials } Durchgänge
    }. Der frühere Stand wird 30 Tage im Ordner der Klinik aufbewahrt: replaced/{ $kept }.
import-known = { $code } wurde schon früher aus diesem Archiv importiert. Nichts wurde geändert.
