### Texte zum Hochladen: vergebene Namen, Objekte mit unwahrscheinlicher Größe und ersetzte Dateien.

same-name-keep-both = Beide behalten, neue als { $name }
same-name-replace = Ersetzen
same-name-kept = Ersetztes lässt sich { $days } Tage lang zurückholen.
object-scale-size = { $size } m
object-scale-as-it-says = { $size } m, laut Datei
replaced-title = In den letzten { $days } Tagen ersetzt
replaced-when = Ersetzt { $day }; endgültig gelöscht { $until }.
replaced-put-back = Zurückholen
replaced-put-back-label = { $name } zurückholen
replaced-back = { $name } ist wieder da.
