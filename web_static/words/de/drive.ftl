### Texte der Seite „Fahren“: Strecke wählen, fahren, ein beendeter Durchgang.

drive-none-title = Fahren ist noch nicht möglich
drive-none-lead = Zuerst die Kalibrierung: Sie lernt, welche Bewegungen die Person machen kann.
drive-none-go = Kalibrieren
drive-no-path = Dieser Grundriss hat keine Strecke „{ $path }“ mehr. Wählen Sie eine andere Aufgabe.
drive-title = Wohin?
drive-why-first = Eine erste Aufgabe: die Flure der veröffentlichten Studie. Der Rollstuhl wird an den Start gesetzt.
drive-why-again = Die zuletzt gefahrene Aufgabe. Der Rollstuhl wird an den Start gesetzt.
drive-why-next-level = Die letzten drei Durchgänge erreichten das Ziel ohne Berührung, und keiner war über die Schwankung hinaus schlechter. Diese Aufgabe ist eine Stufe schwerer.
drive-why-chosen = Die von Ihnen gewählte Aufgabe. Der Rollstuhl wird an den Start gesetzt.
drive-choose = Andere wählen
drive-choose-title = Aufgabe wählen
drive-choose-lead = Wählen Sie eine Art von Aufgabe, dann die Schwierigkeit, dann die Aufgabe.
drive-choose-groups = Arten von Aufgaben
drive-group-first = Einstieg
drive-group-corridors = Flure
drive-group-doors = Türen
drive-group-obstacles = Hindernisse
drive-group-following = Folgen
drive-group-outdoors = Draußen
drive-group-own = Eigene Pläne
drive-own-none = Diese Klinik hat noch keinen eigenen Grundriss.
drive-own-go = Grundriss zeichnen oder importieren
drive-places = Was noch zum Fahren gehört
drive-place-chair = Rollstuhl
drive-place-chair-unicycle = Virtuell, reagiert sofort
drive-place-chair-wheelchair = Virtuell, wie ein echter Rollstuhl
drive-place-chair-lead = Üben Sie mit dem virtuellen Rollstuhl, oder fahren Sie einen echten.
# Breaks where the card is narrower than the word.
drive-place-screen = Patienten{ "\u00AD" }bildschirm
drive-place-screen-lead = Ein zweiter Bildschirm für den Patienten: die Ansicht, große Hinweise und das Tempo. Dort lässt sich nichts ändern.
drive-place-plans = Grundrisse
drive-place-plans-state = Zeichnen oder importieren
drive-screens =
    { $count ->
        [one] { $count } gekoppelt
       *[other] { $count } gekoppelt
    }
drive-screens-bad =
    { $count ->
        [one] { $count } gekoppelt, ohne Bild
       *[other] { $count } gekoppelt, nicht alle mit Bild
    }
drive-screens-away =
    { $count ->
        [one] { $count } gekoppelt, nicht verbunden
       *[other] { $count } gekoppelt, nicht alle verbunden
    }
drive-screens-none = Keiner ist gekoppelt
drive-done = Zurück zur Aufgabe
drive-level = Schwierigkeit von „{ $plan }“
drive-no-shirt = Ein Durchgang braucht ein Shirt. Es ist noch keines gewählt.
drive-no-shirt-go = Shirt wählen
drive-obstacle-shirt = Zum Shirt
drive-obstacle-calibrate = Kalibrieren
drive-obstacle-controls = Zur Steuerung
drive-start = Durchgang starten
drive-start-plan = In der Planansicht starten
drive-length = { $length } m
drive-size = { $width } × { $height } m
drive-body-person-practised = Eine geübte simulierte Person fährt.
drive-body-person-novice = Eine ungeübte simulierte Person fährt.
drive-body-visitor = Sie fahren mit den Tastfeldern oder Tasten.
drive-body-recorded = Die aufgezeichneten Bewegungen einer Person fahren den Rollstuhl. Sie folgen der Strecke nicht.
drive-body-patient = Der Patient fährt.
drive-body-change = Ändern
drive-camera = Selbst bewegen mit dieser Kamera
drive-camera-hint = Aufgezeichnet werden Bewegungen, kein Bild; am Ende wird alles gelöscht.
drive-plan-label = Grundriss von { $plan } mit der Strecke „{ $path }“
task-path = Der Linie folgen
task-follow = Folgen
task-turn = Drehen
task-back = Rückwärts
task-course = Parcours
trial-stage = { $stage } von { $stages } · { $title }
trial-turned = noch { $left }°
trial-turned-over = { $left }° zu weit
trial-spot = { $distance } m neben der Stelle
trial-behind-near = { $distance } m Abstand: zu nah
trial-behind-right = { $distance } m Abstand: genau richtig
trial-behind-far = { $distance } m Abstand: zu weit weg
trial-name = Durchgang { $number } · { $plan }
trial-done = { $done } von { $length } m
trial-off = { $distance } m neben der Strecke
trial-contacts =
    { $count ->
        [one] { $count } Berührung
       *[other] { $count } Berührungen
    }
trial-above = Von oben
trial-above-line = Blaue Linie: auf dem Boden weiß
trial-speed = Tempo
trial-views = Ansicht
trial-view-eye = Auge
trial-view-chase = Hinten
trial-view-top = Oben
trial-view-free = Frei
trial-view-plan = Plan
trial-view-surface = Das Bild: zum Drehen ziehen, zum Zoomen spreizen oder Mausrad, zum Verschieben zwei Finger oder Umschalttaste
trial-view-free-group = Freie Ansicht
trial-view-free-left = Nach links
trial-view-free-right = Nach rechts
trial-view-free-up = Höher
trial-view-free-down = Tiefer
trial-view-free-nearer = Näher
trial-view-free-farther = Weiter weg
trial-view-settings = Einstellungen des Auges
trial-view-fov-deg = Blickfeld
trial-view-eye-height = Augenhöhe
trial-view-roll-share = Kopfneigung
trial-view-roll-share-why = Wie stark das Bild die Neigung zeigt. Keine Neigung ist am angenehmsten.
trial-view-reduced = Auf diesem Bildschirm sind weniger Bewegungen eingestellt. Das Bild neigt sich nicht.
trial-view-head = Kopftracker
trial-view-head-why = Das Bild folgt dem Blick des Kopfes.
trial-view-head-on = Folgen
trial-view-pace = { $rate } Bilder pro Sekunde, { $age } ms alt
trial-view-pace-slow = { $rate } Bilder pro Sekunde, { $age } ms alt. Das Bild ist auf diesem Bildschirm langsam. Schließen Sie andere Seiten, oder verkleinern Sie das Fenster.
trial-plots = Diagramme
trial-end = Beenden
trial-ending = Wird ausgewertet …
trial-ending-why = Der Durchgang ist beendet. Das Ergebnis erscheint hier von selbst. Ein langer Durchgang dauert länger.
trial-moment = Einen Moment …
trial-moment-why = Das Bild wird vorbereitet.
trial-rest = Ruhe …
trial-rest-why = Lassen Sie die Arme hängen. Der Rollstuhl ist bereit, wenn der Körper in Ruhe ist.
trial-go = Los
trial-frame = 3D-Ansicht des Rollstuhls im Gebäude
trial-pause = Pause
trial-pause-why = Der Rollstuhl und die Uhr stehen. Beide laufen von selbst weiter, wenn der Bildschirm eine Sekunde lang schnell genug war.
trial-pause-screen-lost = Der Bildschirm, der den Durchgang gestartet hat, ist nicht erreichbar oder zu langsam.
trial-pause-screen-hidden = Die Seite, die den Durchgang gestartet hat, ist verdeckt oder wurde verlassen.
trial-pause-screen-slow = Der Bildschirm, der den Durchgang gestartet hat, zeichnet zu langsam.
trial-pause-left = Sonst endet der Durchgang in { $left }
trial-pause-often = Dieser Bildschirm ist zu langsam für die 3D-Ansicht. Die Planansicht braucht weniger Leistung.
trial-paused = Der Durchgang wartet auf „Fortsetzen“. Sonst endet er in { $left }
over-goal = Ziel erreicht
over-time-out = Die Zeit ist abgelaufen
over-by-hand = Von Hand beendet
over-fault = Durch Stopp oder Störung beendet
over-null = Durchgang
over-lead = Durchgang { $number } · { $plan } · { $path } · { $when }
over-driven = Fahrspur über der Strecke
over-no-trajectory = Die Aufzeichnung dieses Durchgangs fehlt, deshalb gibt es keine Fahrspur. Seine Messwerte bleiben erhalten.
over-no-measures = Dieser Durchgang war zu kurz zum Messen. Fahren Sie beim nächsten Mal etwas weiter.
over-not-reached = Das Ziel wurde nicht erreicht. Deshalb lässt sich dieser Durchgang nicht mit anderen vergleichen.
over-way = Geschafft: { $done } m von { $length } m der Strecke.
over-not-done = Die Aufgabe wurde nicht abgeschlossen. Deshalb lässt sich die Zeit nicht mit anderen Durchgängen vergleichen.
over-stages = Abschnitt für Abschnitt
over-stage-done = geschafft
over-stage-open = nicht geschafft
over-table = Im Vergleich mit früheren Durchgängen
over-measures = Alle Messwerte dieses Durchgangs
over-measure = Messwert
over-this = Dieser Durchgang
over-previous = Durchgang { $number }
over-best = Bisher bester
over-path-length = Strecke { $length } m
over-discard = Verwerfen …
over-discard-title = Warum zählt dieser Durchgang nicht?
over-discard-interrupted = Er wurde unterbrochen
over-discard-sensor = Ein Sensor hatte Probleme
over-discard-practice = Es war nur eine Übung
over-discard-other = Ein anderer Grund
over-discard-go = Durchgang verwerfen
over-discarded = Zählt nicht: { $reason }
over-discarded-toast = Durchgang { $number } zählt nicht mehr.
over-keep = Wieder zählen lassen
over-count = Zählen lassen
over-counted-toast = Durchgang { $number } zählt.
over-next = Nächster Durchgang
over-harder = Eine Stufe schwerer
over-other = Andere Aufgabe
