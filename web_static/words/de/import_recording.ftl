### Texts of the page that imports a recording of another program.

rail-import-recording = Aufzeichnung importieren
import-recording-lead = Eine Aufzeichnung eines anderen Programms wird zu einer dieses Programms: Sehen Sie, was sie enthält, korrigieren Sie, was nicht stimmt, und verwenden Sie sie.
import-recording-files = Aufzeichnung
import-recording-files-hint = CSV, TSV, Parquet, Excel (XLSX), MATLAB, C3D, TRC, MOT, EDF, XDF, BVH und andere, höchstens 64 MB. Für BIDS-motion wählen Sie auch die Dateien _channels.tsv und _motion.json.
import-recording-reading = Die Datei wird gelesen …
import-recording-holds = Was die Datei enthält
import-recording-kind = Format
import-recording-kind-text = Tabelle als Text (CSV)
import-recording-length = Länge
# $seconds is a number.
import-recording-length-words =
    { $count ->
        [one] { $seconds } s, { $count } Abtastwert
       *[other] { $seconds } s, { $count } Abtastwerte
    }
import-recording-rows =
    { $count ->
        [one] { $count } Zeile
       *[other] { $count } Zeilen
    }
import-recording-rate = Abtastrate
import-recording-rate-words = { $rate } Hz
import-recording-rate-open = Noch nicht bekannt
import-recording-channels = Kanäle
import-recording-joints = Gelenke
import-recording-even = Die Abtastwerte haben gleiche Zeitabstände.
import-recording-correct = Korrigieren Sie es unten: die Spalte mit den Zeiten, ihre Einheit, die Abtastrate, oder welche Spalten Kanäle sind.
import-recording-times = Zeiten
# A stream, or the sheet of a workbook.
import-recording-part = Teil der Datei
import-recording-part-all = Alle zusammen
import-recording-part-largest = Das größte Blatt
import-recording-time = Spalte mit den Zeiten
import-recording-time-none = Keine: Die Abtastwerte haben gleiche Abstände
import-recording-as-it-says = Wie die Datei sagt
import-recording-unit = Einheit der Zeiten
import-recording-unit-s = Sekunden
import-recording-unit-ms = Millisekunden
import-recording-unit-us = Mikrosekunden
import-recording-unit-ns = Nanosekunden
import-recording-unit-min = Minuten
import-recording-unit-h = Stunden
import-recording-unit-d = Tage
import-recording-rate-by-hand = Abtastrate (Hz)
import-recording-rate-hint = Ändern Sie sie nur, wenn die Abtastwerte gleiche Abstände haben und die Zeiten nicht stimmen.
import-recording-channels-count = { $count } von { $all } Spalten sind Kanäle
import-recording-title-channel = Spalte
import-recording-title-unit = Einheit
import-recording-title-range = Bereich
import-recording-title-missing = Fehlt
import-recording-title-joint = Gelenk
import-recording-range = { $least } bis { $most }
import-recording-joint-of = Gelenk von { $name }
import-recording-none-chosen = Wählen Sie mindestens einen Kanal.
import-recording-back = Zurück zum Shirt
import-recording-store = Nur speichern
import-recording-use = Verwenden
