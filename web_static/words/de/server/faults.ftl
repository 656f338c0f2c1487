### Faults: why motion was refused or ended, and what a person does next. The first texts of each are for the
### clinician, those with -patient for the patient, who reads no technical details.

# The next step of a fault after which Continue goes on with the trial or the drive.
remedy-continue = { $remedy } Tippen Sie dann auf „Fortsetzen“.

fault-none = Alles ist in Ordnung.
fault-none-remedy = Machen Sie weiter.
fault-none-patient = Der Rollstuhl wurde gestoppt.

fault-stop-tablet = STOP wurde auf dem Bildschirm gedrückt.
fault-stop-tablet-remedy = Sehen Sie sich um.
fault-stop-tablet-patient = Auf der Seite einer Fachkraft wurde STOP gedrückt.

fault-stop-gesture = Der Patient hat die Stopp-Geste gemacht.
fault-stop-gesture-remedy = Fragen Sie den Patienten.
fault-stop-gesture-patient = Sie haben den Rollstuhl gestoppt.

fault-stop-key = Der Stopp wurde auf der Tastatur gedrückt.
fault-stop-key-remedy = Sehen Sie sich um.
fault-stop-key-patient = Auf der Seite einer Fachkraft wurde STOP gedrückt.

fault-not-neutral = Der Körper war nicht innerhalb von 5 Sekunden in Ruhe.
fault-not-neutral-remedy = Bitten Sie den Patienten um Ruhe, oder erhöhen Sie unter „Steuerung“ den Wert „Zählt ab“ der aktiven Bewegung.
fault-not-neutral-patient = Ihr Körper war noch nicht in Ruhe. Lassen Sie die Arme hängen.

fault-shirt-silent = Das Shirt sendet nicht mehr, oder seine Signale kommen zu spät.
fault-shirt-silent-remedy = Prüfen Sie Akku und Kabel des Shirts, und sehen Sie auf der Seite „Shirt“ nach.
fault-shirt-silent-patient = Das Shirt sendete nichts mehr.

fault-shirt-lossy = Mehr als ein Zehntel der Signale des Shirts ging verloren.
fault-shirt-lossy-remedy = Bringen Sie den Sender des Shirts näher heran.
fault-shirt-lossy-patient = Signale des Shirts gingen verloren.

fault-channels-bad = Sensoren von zwei Bewegungen lieferten unmögliche Werte.
fault-channels-bad-remedy = Sehen Sie sich die Lampen auf der Seite „Shirt“ an, und wiederholen Sie die Kalibrierung ohne die fehlerhaften Sensoren.
fault-channels-bad-patient = Einige Sensoren des Shirts müssen geprüft werden.

fault-web-silent = Das Programm sendete dem Steuerungsprozess nichts.
fault-web-silent-remedy = Warten Sie, bis die Seite wieder da ist, und starten Sie dann noch einmal.
fault-web-silent-patient = Das Programm wurde unterbrochen.

fault-screen-lost = Der Bildschirm, der die Fahrt gestartet hat, sendete 0,3 s lang nichts: Er war nicht erreichbar oder überlastet, oder seine Seite wurde geschlossen.
fault-screen-lost-remedy = Sorgen Sie dafür, dass dieser Bildschirm verbunden ist und die Seite zeigt.
fault-screen-lost-patient = Der Bildschirm der Fachkraft war nicht erreichbar.

fault-screen-hidden = Die Seite, die die Fahrt gestartet hat, war verdeckt oder wurde verlassen.
fault-screen-hidden-remedy = Holen Sie sie in den Vordergrund, und lassen Sie sie dort.
fault-screen-hidden-patient = Die Seite der Fachkraft war nicht zu sehen.

fault-screen-slow = Die Seite, die die Fahrt gestartet hat, stand zu lange still, und STOP ließ sich dort nicht drücken.
fault-screen-slow-remedy = Schließen Sie auf diesem Bildschirm andere Seiten und Programme, oder verkleinern Sie das Fenster.
fault-screen-slow-patient = Der Bildschirm der Fachkraft war zu langsam.

fault-bad-number = Ein Fahrbefehl war keine Zahl.
fault-bad-number-remedy = Fahren Sie nicht. Wiederholen Sie die Kalibrierung, und melden Sie den Fehler.
fault-bad-number-patient = Das Programm hat einen Fehler gemacht.

fault-loop-late = Die Regelschleife stand zu lange still.
fault-loop-late-remedy = Schließen Sie andere Programme auf diesem Rechner.
fault-loop-late-patient = Das Programm war zu langsam.

fault-recording-lost = Die Aufzeichnung konnte nicht geschrieben werden.
fault-recording-lost-remedy = Schaffen Sie Speicherplatz, und starten Sie dann einen neuen Durchgang.
fault-recording-lost-patient = Die Fahrt konnte nicht aufgezeichnet werden.

fault-control-lost = Der Steuerungsprozess wurde beendet. Der Rollstuhl steht.
fault-control-lost-remedy = Ein neuer wird gestartet, und der Rollstuhl ist zunächst gesperrt. Starten Sie danach noch einmal.
fault-control-lost-patient = Ein Teil des Programms wurde beendet.

fault-stop-chair = Der Stoppschalter des Rollstuhls wurde gedrückt, sein Joystick wurde bewegt, oder der Rollstuhl meldet eine Störung.
fault-stop-chair-remedy = Sehen Sie sich um, lösen Sie den Stoppschalter, und lassen Sie den Joystick los.
fault-stop-chair-patient = Der Rollstuhl wurde mit seinem eigenen Schalter oder Joystick gestoppt, oder er hat eine Störung.

fault-chair-silent = Der Rollstuhl antwortet nicht mehr. Er hält von selbst an.
fault-chair-silent-remedy = Prüfen Sie den Strom des Rollstuhls und das Netz.
fault-chair-silent-patient = Der Rollstuhl war nicht erreichbar.

fault-chair-disarmed = Der Rollstuhl hat sich selbst gesperrt: Zu wenige Fahrbefehle kamen rechtzeitig bei ihm an.
fault-chair-disarmed-remedy = Bringen Sie den Rollstuhl dorthin, wo der Empfang besser ist.
fault-chair-disarmed-patient = Der Rollstuhl war nicht erreichbar.

fault-chair-not-ready = Der Rollstuhl war nicht innerhalb von 5 Sekunden bereit.
fault-chair-not-ready-remedy = Sehen Sie auf der Seite „Echter Rollstuhl“ nach, was er meldet.
fault-chair-not-ready-patient = Der Rollstuhl war nicht rechtzeitig bereit.

fault-shirt-rate = Das Shirt sendet mehr oder weniger Datenpakete pro Sekunde als eingestellt.
fault-shirt-rate-remedy = Stellen Sie auf der Seite „Shirt“ den Wert „{ shirtdev-rate }“ richtig ein, und kalibrieren Sie neu.
fault-shirt-rate-patient = Das Shirt muss neu eingestellt werden.

fault-no-movement = Die Signale änderten sich, wie sich kein Körper bewegt: in Sprüngen, so gleichmäßig wie eine Maschine oder in allen Gelenken gleich.
fault-no-movement-remedy = Prüfen Sie, ob die Stecker des Shirts fest sitzen und sein Kabel frei hängt, und lassen Sie den Patienten ruhen.
fault-no-movement-patient = Die Signale kamen nicht von Ihrer Bewegung. Lassen Sie die Arme hängen.

fault-brake-bad = Ein Sensor der Bewegung zum Bremsen oder Stoppen lieferte unmögliche Werte.
fault-brake-bad-remedy = Sehen Sie sich die Lampen auf der Seite „Shirt“ an, und wiederholen Sie die Kalibrierung ohne die fehlerhaften Sensoren.
fault-brake-bad-patient = Einige Sensoren des Shirts müssen geprüft werden.

fault-picture-lost = Ein Bildschirm hat das Bild verloren, nach dem der Patient fährt.
fault-picture-lost-remedy = Warten Sie, bis das Bild wieder da ist, oder wählen Sie die Planansicht.
fault-picture-lost-patient = Das Bild ging verloren.

## Who acts next, for the patient, while the chair stands.

fault-waits-clinician = Wir warten, bis die Fachkraft nachgesehen hat und es weitergeht.
fault-waits-program = Wir warten auf das Programm. Es startet von selbst wieder.
fault-waits-shirt = Wir warten auf das Shirt. Die Fachkraft kümmert sich darum.
fault-waits-begin = Wir warten, bis die Fachkraft beginnt.
fault-waits-moment = Wir warten auf das Programm. Es braucht einen Moment.
fault-waits-movements = Sie fahren. Der Rollstuhl wartet auf Ihre Bewegungen.
fault-waits-rest = Lassen Sie die Arme hängen. Der Rollstuhl wartet, bis Ihr Körper in Ruhe ist.
