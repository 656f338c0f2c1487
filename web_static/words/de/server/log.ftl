### Texts about the check of the log, which says who did what when. Its rows form a chain. The head is a file beside the
### database that says how many rows the log has: rows that were removed from its end are noticed by it.

logs-whole =
    { $rows ->
        [one] Das Protokoll ist unversehrt: { $rows } Zeile, nicht geändert, verschoben, eingefügt oder entfernt.
       *[other] Das Protokoll ist unversehrt: { $rows } Zeilen, keine geändert, verschoben, eingefügt oder entfernt.
    }
# $rows: how many, 1 or more. It follows on logs-whole.
logs-head-behind =
    { $rows ->
        [one] Die neueste Zeile steht noch nicht in der Kopfdatei: Das Programm endete genau dann, oder es schreibt gerade.
       *[other] Die neuesten { $rows } Zeilen stehen noch nicht in der Kopfdatei: Das Programm endete genau dann, oder es schreibt gerade.
    }
# $row: the number of a row, $day: its date. It follows on logs-whole or logs-head-behind.
logs-head-begun = Ob neueste Zeilen entfernt wurden, zeigt sich ab Zeile { $row } vom { $day }.
# Two of these sentences, one after the other.
logs-sentences = { $first } { $second }
logs-empty = Das Protokoll ist leer.
# $row: the number of a row.
logs-row-changed = Das Protokoll wurde verändert: Zeile { $row } wurde geändert, verschoben oder eingefügt, oder Zeilen davor wurden entfernt. Archivieren Sie den Stand dieses Rechners mit „bodydrive incident FILE“, und vergleichen Sie das Protokoll mit dem eines Backups.
# $left, $rows: how many.
logs-newest-removed = Das Protokoll wurde verändert: Die neuesten Zeilen wurden entfernt, vorhanden: { $left } von { $rows }. Archivieren Sie den Stand dieses Rechners mit „bodydrive incident FILE“, und vergleichen Sie das Protokoll mit dem eines Backups.
# $rows: how many.
logs-rows-exchanged =
    { $rows ->
        [one] Das Protokoll wurde verändert: Die erste Zeile ist nicht die, die geschrieben wurde. Archivieren Sie den Stand dieses Rechners mit „bodydrive incident FILE“, und vergleichen Sie das Protokoll mit dem eines Backups.
       *[other] Das Protokoll wurde verändert: Die ersten { $rows } Zeilen sind nicht die, die geschrieben wurden. Archivieren Sie den Stand dieses Rechners mit „bodydrive incident FILE“, und vergleichen Sie das Protokoll mit dem eines Backups.
    }
logs-head-missing = Die Kopfdatei des Protokolls neben der Datenbank fehlt: Am Ende des Protokolls könnten Zeilen entfernt worden sein. Archivieren Sie den Stand dieses Rechners mit „bodydrive incident FILE“, und vergleichen Sie das Protokoll mit dem eines Backups.
