### The camera of a tablet, laptop or phone as the shirt: on the Shirt page and on the patient's screen.

camera-title = Die Kamera
camera-private = Das Bild bleibt auf diesem Gerät: Nichts davon wird gespeichert oder gesendet. Das Programm erhält nur, wie die Gelenke stehen, etwa 30-mal pro Sekunde.
camera-mirror = Spiegelbild der Kamera mit den erkannten Gelenken
camera-start = Kamera starten
camera-stop = Kamera beenden
# A button on the patient's screen.
camera-start-screen = Kamera dieses Bildschirms verwenden
camera-rate =
    { $count ->
        [one] { $count } Bild pro Sekunde.
       *[other] { $count } Bilder pro Sekunde.
    }

## What the camera does, and what to change.

camera-off = Setzen Sie sich so, dass Kopf, Arme und Hüften im Bild sind und sonst niemand.
camera-asking = Der Browser fragt nach der Kamera: Erlauben Sie sie.
camera-preparing = Die Kamera wird vorbereitet. Beim ersten Mal dauert das bis zu einer Minute.
camera-good = Die Kamera sieht Sie.
camera-lost = Die Kamera sieht niemanden, und der Rollstuhl stoppt: Setzen Sie sich vor sie.
camera-back = Rücken Sie ein wenig zurück: Kopf, Schultern und Ellbogen müssen im Bild sein.
camera-light = Mehr Licht: Die Kamera sieht Sie kaum.
camera-slow = Dieses Gerät liest nur { $count } Bilder pro Sekunde, und Bewegungen gehen verloren: Schließen Sie andere Programme, oder verwenden Sie ein anderes Gerät.

## Why there is no camera.

camera-insecure = Browser geben die Kamera nur Seiten über https: Öffnen Sie diese Seite so oder auf diesem Rechner selbst.
camera-none = Hier gibt es keine Kamera: Schließen Sie eine an, oder öffnen Sie diese Seite auf einem Tablet oder Telefon.
camera-denied = Der Browser erlaubt die Kamera nicht: Erlauben Sie sie für diese Seite in den Einstellungen des Browsers.
camera-busy = Ein anderes Programm verwendet die Kamera: Schließen Sie es, und starten Sie die Kamera noch einmal.
camera-failed = Die Bilder der Kamera können nicht gelesen werden: Laden Sie diese Seite neu, oder verwenden Sie ein aktuelles Chrome, Edge, Firefox oder Safari.
camera-taken = Eine andere Seite ist die Kamera: Beenden Sie sie zuerst dort.
camera-unwanted = Die Kamera ist nicht das verwendete Shirt: Wählen Sie sie auf der Seite „Shirt“.
