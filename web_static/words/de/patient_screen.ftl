### Texte des Patientenbildschirms und der Karte der Fachkraft, die ihn verwaltet.

patient-title = bodydrive · Patientenbildschirm
patient-view = 3D-Ansicht aus dem Rollstuhl
patient-plan = Dieser Bildschirm kann die 3D-Ansicht nicht zeichnen. Er zeigt den Plan von oben.
patient-no-picture = Zurzeit kein Bild. Der Rollstuhl stoppt.
patient-lost = Keine Verbindung zum Programm
patient-lost-why = Wir warten auf das Programm. Das Bild kommt von selbst zurück.
patient-stopped = Gestoppt
patient-speed = Tempo
patient-backwards = rückwärts
patient-stage = Abschnitt { $stage } von { $stages }
patient-rest = Ruhe
patient-go = Los
patient-goal-name = Ziel
patient-goal = Ziel erreicht
patient-goal-why = Gut gemacht. Ruhen Sie sich etwas aus.
patient-ended = Fertig
patient-ended-why = Ruhen Sie sich etwas aus.
patient-arrow = Pfeil zum Ziel: { $where }
patient-arrow-ahead = geradeaus
patient-arrow-left = links
patient-arrow-right = rechts
patient-arrow-behind = hinter Ihnen
patient-arrow-distance = { $distance } m
patient-sound = Ton einschalten
patient-cue-ready = Bereit machen
patient-cue-rest = Ausruhen
patient-cue-free = Frei bewegen
patient-cue-move = Bewegen
patient-cue-return = Langsam zurück
# { $movement } is an instruction: "Bend the right elbow".
patient-cue-then-movement = Danach: { $movement }
patient-cue-then-ready = Danach: bereit machen
patient-cue-then-rest = Danach: ausruhen
patient-cue-then-free = Danach: frei bewegen
patient-cue-then-move = Danach: bewegen
patient-cue-then-return = Danach: langsam zurück
patient-over-title = Vielen Dank
patient-over-lead = Die Sitzung ist beendet. Dieser Bildschirm zeigt nichts mehr davon.
patient-over-next = Sie können diese Seite schließen. Für die nächste Sitzung zeigt Ihnen die Fachkraft einen neuen Code. Scannen Sie ihn, oder geben Sie ihn hier ein.
patient-unpaired-title = Dieser Bildschirm wird nicht verwendet
patient-unpaired-lead = Er wurde auf der Seite der Fachkraft entkoppelt.
patient-unpaired-next = Um ihn wieder zu verwenden, bitten Sie die Fachkraft um einen neuen Code. Scannen Sie ihn mit der Kamera dieses Bildschirms, oder geben Sie ihn hier ein.
patient-none-title = Diesen Bildschirm koppeln
patient-none-lead = Dieser Bildschirm weiß noch nicht, zu welcher Sitzung er gehört.
patient-none-next = Wählen Sie auf der Seite der Fachkraft „Fahren“, dann „Patientenbildschirm“ und „Bildschirm koppeln“. Scannen Sie den Code dort mit der Kamera dieses Bildschirms, oder geben Sie ihn hier ein.
patient-code = Code von der Seite der Fachkraft
patient-code-go = Koppeln
# Breaks where the card is narrower than the word.
screens-title = Patienten{ "\u00AD" }bildschirm
screens-lead = Ein zweiter Bildschirm für den Patienten: die Ansicht, große Hinweise und das Tempo. Dort lässt sich nichts ändern.
screens-nobody = Ein Bildschirm wird mit einer Sitzung gekoppelt. Wählen Sie zuerst einen Patienten.
screens-pair = Bildschirm koppeln
screens-scan =
    Scannen Sie diesen Code mit der Kamera des Patientenbildschirms, oder öffnen Sie den Link dort. Er gilt einmal, { $minutes ->
        [one] noch { $minutes } Minute
       *[other] noch { $minutes } Minuten
    }.
screens-type = Oder öffnen Sie { $address } auf dem Patientenbildschirm, und geben Sie diesen Code ein:
screens-expired = Dieser Code ist abgelaufen. Erstellen Sie einen neuen.
screens-qr = QR-Code des Links für den Patientenbildschirm
screens-link = Link für den Patientenbildschirm
screens-copy = Link kopieren
screens-copied = Der Link wurde kopiert.
screens-copy-failed = Dieser Browser erlaubt der Seite das Kopieren nicht. Markieren Sie den Link, und kopieren Sie ihn selbst.
screens-again = Neuer Code
screens-close = Schließen
screens-paired = Ein Bildschirm wurde gekoppelt.
screens-name = Bildschirm { $number }
screens-connected = verbunden
screens-away = nicht verbunden
screens-since = gekoppelt { $when }
screens-unpair = Entkoppeln
screens-unpair-label = Bildschirm { $number } entkoppeln
screens-unpaired = Bildschirm { $number } wurde entkoppelt und zeigt nichts mehr.
screens-arrow = Pfeil zum Ziel
screens-sounds = Töne: Berührung, Ziel, Stopp
screens-large = Großer Text
screens-plan = Planansicht statt 3D-Ansicht
screens-picture-view = 3D-Ansicht
screens-picture-plan = Planansicht
screens-picture-none = kein Bild
