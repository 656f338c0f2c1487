### Texte der Seite „Dieser Rechner“ für Verantwortliche. Was gefunden wurde, kommt in Worten vom Server (app/host/machine_check.py).

rail-computer = Dieser Rechner
computer-lead = Ob dieser Rechner und die jetzt offenen Bildschirme zum Fahren gut genug sind.
computer-settings-go = Diesen Rechner prüfen
computer-owner = Nur Verantwortliche prüfen diesen Rechner. Fragen Sie eine verantwortliche Person.
computer-measured = Geprüft werden die Pünktlichkeit der Regelschleife, die Rechte im System, der freie Speicherplatz, die Uhr, die Anschlüsse und die Bilder pro Sekunde auf jedem offenen Bildschirm. Öffnen Sie zuerst die Bildschirme, die Sie prüfen möchten, am besten mit der 3D-Ansicht.
computer-go = { $seconds } s lang messen
computer-again = Erneut messen
computer-measuring = Messung läuft. Noch { $left } s.
computer-counting = Messung läuft. Das Ergebnis kommt gleich.
computer-progress = Fortschritt der Messung
computer-machine = Dieser Rechner
computer-screens = Jetzt offene Bildschirme
computer-screens-bad =
    { $count ->
        [one] { $count } jetzt offener Bildschirm ist nicht gut genug.
       *[other] { $count } jetzt offene Bildschirme sind nicht gut genug.
    }
computer-no-screens = Kein Bildschirm ist offen.
computer-verdict-good = Gut
computer-verdict-attention = Könnte besser sein
computer-verdict-bad = Nicht gut genug
