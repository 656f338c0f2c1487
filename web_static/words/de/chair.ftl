### Texte zum echten Rollstuhl: auswählen, freigeben, fahren, und der Temporegler.

which-virtual = Virtueller Rollstuhl
which-feel = Fahrverhalten
which-feel-unicycle = Reagiert sofort
which-feel-unicycle-hint = Wie in der veröffentlichten Studie.
which-feel-wheelchair = Wie ein echter Rollstuhl
which-feel-wheelchair-hint = Er reagiert verzögert, die Lenkräder schwenken, die Antriebsräder rutschen etwas.
which-real = Echter Rollstuhl
which-real-go = „{ $name }“ fahren …
which-none = Hier ist noch keiner gekoppelt.
which-none-go = Einen koppeln
which-none-ask = Hier ist noch keiner gekoppelt. Verantwortliche koppeln einen Rollstuhl unter „Einstellungen“.
chair-title = „{ $name }“ fahren
chair-lead = Gehen Sie die drei Karten durch, und geben Sie den Rollstuhl dann frei. Der Patient sitzt im Rollstuhl, und jemand steht am Stoppschalter.
chair-lead-simulated = Gehen Sie die drei Karten durch, und geben Sie den Rollstuhl dann frei. Jemand steht am Stoppschalter des Rollstuhls.
chair-virtual = Virtuellen Rollstuhl nehmen
chair-card = Der Rollstuhl
chair-state-disarmed = Gesperrt
chair-state-checking = Wartet auf Ruhe
chair-state-armed = Freigegeben
chair-state-fault = Nicht bereit
chair-state-silent = Keine Antwort
chair-battery = Akku
chair-battery-unknown = nicht gemeldet
chair-switch = Stoppschalter
chair-switch-pressed = gedrückt
chair-switch-released = nicht gedrückt
chair-age = Letzte Antwort
chair-age-value = vor { $age } s
chair-now = gerade eben
chair-never = nie
chair-drives = Aktuelles Tempo
chair-measured = Gemessen
chair-commanded = Verlangt
chair-drives-value = { $v } m/s, { $omega } °/s
chair-simulated = Vorführung: Der simulierte Körper kann diesen Rollstuhl fahren. Deshalb darf niemand darin sitzen.
chair-switch-why = Lösen Sie den Stoppschalter des Rollstuhls. Solange er gedrückt ist, fährt nichts.
chair-joystick-why = Lassen Sie den Joystick des Rollstuhls los. Solange er bewegt wird, gehorcht der Rollstuhl nur ihm.
apply-card = Einstellungen, die gelten werden
apply-set = Set
apply-change = Dieses Set ändern
apply-forward-back = Vor und zurück
apply-turning = Drehen
apply-level-clinic = Grenzwert der Klinik
apply-level-chair = Grenzwert des Rollstuhls
apply-level-dial = mit dem Temporegler auf { $share }
apply-more = Beschleunigung, Dämpfung, Fingerabdruck
apply-hash = Fingerabdruck
apply-hash-hint = Bei gleichem Fingerabdruck fährt der Rollstuhl gleich.
apply-crawls = Zu diesem Rollstuhl fehlt das Rollstuhldokument. Er fährt höchstens 0,3 m/s, was auch immer hier eingestellt ist. Messen Sie zuerst seinen Joystick aus.
apply-document = Rollstuhldokument
apply-document-hint = Die ersten Stellen des Fingerabdrucks der Datei, die sagt, wie schnell der Joystick diesen Rollstuhl fährt.
apply-cruise = Hält von selbst an nach
apply-cruise-value = { $time } s ohne Bewegung
apply-turn-cruise = Hört auf zu drehen nach
apply-turn-cruise-value = { $time } s ohne Bewegung
apply-practised = Geübt
apply-practised-trials =
    { $count ->
        [one] { $count } Durchgang mit dem virtuellen Rollstuhl, { $when }
       *[other] { $count } Durchgänge mit dem virtuellen Rollstuhl, zuletzt { $when }
    }
apply-differs = Das unterscheidet sich von „{ $title }“ ({ $hash }), dem zuletzt geübten Set:
apply-unpractised = Mit diesem Set ist in dieser Klinik noch niemand den virtuellen Rollstuhl gefahren.
apply-practise = Jetzt üben
differs-change = { $what }: { $before } → { $now }.
differs-title = Name des Sets: „{ $before }“ → „{ $now }“.
differs-profile = Die Kalibrierung ist eine andere.
differs-order = Gleiche Bewegungen und Werte, in anderer Reihenfolge gespeichert.
differs-gesture-added = { $gesture }: neue Bewegung.
differs-gesture-removed = { $gesture }: wird nicht mehr verwendet.
differs-gesture-joint = { $gesture }: jetzt mit einem anderen Gelenk.
differs-gesture-direction = { $gesture }: zählt jetzt in der anderen Richtung.
differs-gesture-from = { $gesture }, zählt ab: { $before } → { $now }.
differs-gesture-full = { $gesture }, voll ab: { $before } → { $now }.
differs-gesture-moving = Bewegen
differs-gesture-holding = Halten
differs-how-u1-acceleration = hält das Tempo
differs-how-u1-velocity = folgt der Bewegung
differs-how-u2-acceleration = dreht weiter
differs-how-u2-velocity = folgt der Bewegung
differs-gain = { $gestures }, Verstärkung { $gain }
differs-nothing = nichts
neutral-card = In Ruhe
neutral-lead = Bevor der Rollstuhl fährt, muss jede Bewegung eine halbe Sekunde lang unter ihrer Marke bleiben.
neutral-rest = Der Körper ist in Ruhe.
neutral-moves = In Bewegung: { $gestures }.
neutral-no-shirt = Das Shirt sendet nicht. Über den Körper ist deshalb nichts bekannt. Prüfen Sie das Shirt auf der Seite „Shirt“.
neutral-stop = Stopp-Geste: { $gestures }, gleichzeitig.
neutral-no-stop = Keine Stopp-Geste zugeordnet: Der Patient kann den Rollstuhl nicht mit dem Körper stoppen. Ordnen Sie auf der Seite „Steuerung“ eine zu.
arm-go = Freigeben
arm-busy = Freigabe …
arm-ready = Alles ist bereit. Nach dem Freigeben fährt der Patient.
arm-missing =
    { $count ->
        [one] Ein Punkt fehlt:
       *[other] { $count } Punkte fehlen:
    }
arm-missing-short =
    { $count ->
        [one] Ein Punkt fehlt, siehe oben.
       *[other] { $count } Punkte fehlen, siehe oben.
    }
arm-lost = Diese Seite hat keine Verbindung zum Programm. Warten Sie, bis sie wieder da ist.
arm-fault = Ein Stopp oder eine Störung besteht noch. Heben Sie den Stopp in der Leiste oben auf.
arm-front = Lassen Sie diese Seite im Vordergrund, solange der Rollstuhl fährt. Ist sie verdeckt oder nicht erreichbar, stoppt der Rollstuhl.
driving-title = Fahrt mit „{ $name }“
driving-checking = Ruhe …
driving-checking-why = Lassen Sie die Arme hängen. Der Rollstuhl ist bereit, wenn der Körper in Ruhe ist.
driving-armed = Fährt
driving-armed-why = Der Patient fährt. STOP, die Leertaste und die Stopp-Geste stoppen den Rollstuhl.
driving-disarmed = Gesperrt
driving-disarmed-why = Der Rollstuhl steht.
driving-speed = Tempo
driving-reverse = rückwärts
driving-turn-left = dreht nach links, { $turn } °/s
driving-turn-right = dreht nach rechts, { $turn } °/s
driving-straight = geradeaus
driving-stands = steht
driving-end = Fahrt beenden
driving-ending = Wird beendet …
driving-movements = Bewegungen
driving-commands = Fahrbefehle
driving-paused = Die Fahrt wartet auf „Fortsetzen“ und einen neuen Moment der Ruhe. Ohne „Fortsetzen“ endet die Fahrt in { $left }
driven-title = Die Fahrt ist beendet
driven-distance = Weg
driven-time = Zeit
driven-end = Ende
driven-end-by-hand = Von Hand beendet
driven-end-fault = Durch Stopp oder Störung beendet
driven-end-time-out = Die Zeit ist abgelaufen
driven-end-lost = Der Steuerungsprozess wurde beendet
driven-hash = Gefahren mit dem Set mit Fingerabdruck { $hash }.
driven-again = Zurück zum Rollstuhl
driven-gone = Diese Fahrt ist nicht mehr in der Liste. Gehen Sie zurück zum Rollstuhl.
dial-title = Temporegler
dial-label = Temporegler, Anteil der Geschwindigkeiten
dial-up-to = bis { $speed } m/s
dial-hint = Ein niedrigerer Wert gilt sofort. Ein höherer Wert gilt, sobald der Rollstuhl steht und der Körper in Ruhe ist.
