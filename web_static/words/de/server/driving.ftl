### Why a command to the chair, the shirt or the head tracker is refused; why the chair cannot be armed; the state of
### what is connected; why a recorded drive cannot be computed again.

## Arming

drives-during-test = Der Zwei-Minuten-Test läuft, und dabei bewegt sich kein Rollstuhl. Beenden Sie zuerst den Test, und geben Sie den Rollstuhl dann frei.
drives-not-calibrated = Noch gibt es nichts, womit man fahren könnte. Kalibrieren Sie zuerst.
drives-controls-changed = Die Steuerung oder das Rollstuhldokument wurde inzwischen geändert. Laden Sie die Steuerung neu, und geben Sie den Rollstuhl dann frei.
# $happened and $remedy are whole sentences on the stop that is still in force: what happened, and what to do.
drives-latched = { $happened } { $remedy } Heben Sie den Stopp auf, und starten Sie dann noch einmal.
drives-speed-without-brake = Mit dieser Steuerung würde der Rollstuhl ein Tempo halten, das keine Bewegung verringern kann. Ordnen Sie auf der Seite „Steuerung“ der Gegenrichtung oder dem Stopp eine Bewegung zu, oder wählen Sie „Folgt der Bewegung“.
drives-posture-without-brake = Mit dieser Steuerung könnte der Rollstuhl weiterfahren, wenn ein Sensor auf seinem Wert stehen bleibt, während eine Bewegung gehalten wird, und keine Bewegung könnte ihn stoppen. Ordnen Sie auf der Seite „Steuerung“ dem Stopp Bewegungen anderer Gelenke zu, oder wählen Sie „Bewegen“ statt „Halten“.
# $problem says what became of the key of the pairing, without a full stop.
drives-shirt-unpaired = Das Shirt ist nicht mehr gekoppelt: { $problem }.
# $problem says what became of the key of the pairing, without a full stop.
drives-chair-unpaired = Der Rollstuhl ist nicht mehr gekoppelt: { $problem }.
drives-only-recorded = Ein echter Rollstuhl fährt nur, während aufgezeichnet wird. Beginnen Sie zuerst eine Fahrt.
# $state is a whole sentence: the state of the chair.
drives-switch-pressed = { $state } Sehen Sie sich um, lösen Sie den Stoppschalter, lassen Sie den Joystick los, und geben Sie den Rollstuhl dann noch einmal frei.
drives-switch-unproved = Mit „Hält das Tempo“ oder „Dreht weiter“ fährt ein Rollstuhl von selbst weiter. Deshalb braucht ein echter seinen Stoppschalter. Drücken und lösen Sie den Schalter einmal, um zu zeigen, dass er funktioniert, oder wählen Sie auf der Seite „Steuerung“ „Folgt der Bewegung“.
drives-virtual-chair-chosen = Der virtuelle Rollstuhl ist gewählt. Wählen Sie zuerst einen echten.
drives-not-practised = Dieses Set wurde mit dem virtuellen Rollstuhl dieser Klinik nie geübt. Fahren Sie damit zuerst einen Durchgang zu Ende, und lassen Sie ihn zählen.
drives-show-the-switch = Mit „Hält das Tempo“ oder „Dreht weiter“ fährt ein Rollstuhl von selbst weiter. Drücken und lösen Sie seinen Stoppschalter einmal, um zu zeigen, dass er funktioniert, oder wählen Sie auf der Seite „Steuerung“ „Folgt der Bewegung“.
drives-wait-for-process = Der Steuerungsprozess wird neu gestartet. Warten Sie einen Moment.
# $name is the name of a chair.
drives-chair-silent = „{ $name }“ antwortet nicht. Prüfen Sie den Strom des Rollstuhls und das Netz.
# $name is the name of a chair.
drives-stop-switch-pressed = Der Stoppschalter von „{ $name }“ ist gedrückt. Sehen Sie sich um, und lösen Sie ihn dann.

## Refused commands

# $commands lists the names of all commands.
drives-no-command = Es gibt keinen Befehl „{ $name }“. Verwenden Sie einen von diesen: { $commands }.
# $problem is a sentence without its full stop: what is wrong, and what to do.
drives-problem = { $problem }.
drives-opening = Gerade wird ein anderes Gerät geöffnet. Warten Sie einen Moment, und versuchen Sie es dann noch einmal.
drives-wrong-sender = Dieser Sender sendet keine Datenpakete dieses Shirts. Sehen Sie auf der Seite „Shirt“ nach, welcher es tut.
drives-keys-move-nobody = Die Tasten bewegen in diesem Shirt niemanden. Wählen Sie zuerst „Sie“ als Körper.
drives-no-tablet = Es wird kein Tablet als Kopftracker verwendet. Wählen Sie es zuerst auf der Seite „Shirt“.
drives-no-camera = Die Kamera ist nicht das verwendete Shirt. Wählen Sie sie zuerst auf der Seite „Shirt“.
drives-no-pose = Der Kopftracker hat noch nicht gemeldet, wohin der Kopf blickt. Warten Sie auf die erste Kopfhaltung.
drives-run-ending = Die Aufzeichnung wird gerade beendet. Beginnen Sie zuerst eine neue.
drives-another-stop = Inzwischen gab es einen weiteren Stopp. Sehen Sie sich um, und tippen Sie dann noch einmal auf „Fortsetzen“.
drives-recording = Es wird schon etwas aufgezeichnet. Beenden Sie das zuerst.
drives-armed = Der Rollstuhl ist freigegeben. Beenden Sie zuerst die Fahrt.
drives-no-body = Nur beim simulierten Shirt lässt sich ein Körper wählen. Wählen Sie zuerst das simulierte Shirt.
drives-limits-while-moving = Grenzwerte lassen sich nur erhöhen, solange der Rollstuhl steht und sich niemand bewegt. Beenden Sie zuerst die Fahrt.
drives-dial-while-moving = Der Temporegler lässt sich nur höher stellen, solange der Rollstuhl steht und der Patient in Ruhe ist.
drives-plan-on-real-chair = Ein echter Rollstuhl fährt in keinem Grundriss. Wählen Sie zuerst den virtuellen Rollstuhl.
drives-other-sensors = Diese Steuerung wurde für ein Shirt mit anderen Sensoren erstellt. Kalibrieren Sie mit diesem Shirt.
# $cutoff is in Hz; $least and $rate are frames a second.
drives-cutoff-too-high = Eine Tremordämpfung von { $cutoff } Hz braucht mehr als { $least } Datenpakete pro Sekunde, und dieses Shirt sendet { $rate }. Stellen Sie auf der Seite „Steuerung“ einen kleineren Wert ein.
drives-still-stopping = Der Rollstuhl kommt gerade erst zum Stehen. Versuchen Sie es gleich noch einmal.
drives-not-recording = Es wird nichts aufgezeichnet. Beginnen Sie zuerst eine Aufzeichnung.
# $problem is the reason that the operating system gives.
drives-cannot-record = Die Aufzeichnung kann nicht begonnen werden ({ $problem }). Schaffen Sie Speicherplatz.
drives-disk-full = Auf dem Datenträger der Aufzeichnungen sind nur { $free } MB frei, und von einer Fahrt darf nichts verloren gehen. Machen Sie { $needed } MB frei, und beginnen Sie dann noch einmal.

## Devices

drives-no-shirt = Es ist kein Shirt verbunden. Wählen Sie eines auf der Seite „Shirt“.
drives-no-tracker = Es ist kein Kopftracker verbunden: Der Blick geht geradeaus.
drives-tracker-failed = Der Kopftracker ist ausgefallen ({ $problem }). Wählen Sie ihn neu.
drives-shirt-failed = Das Shirt ist ausgefallen ({ $problem }). Wählen Sie es neu.
drives-virtual-chair =
    { $dynamics ->
        [wheelchair] Der virtuelle Rollstuhl, der wie ein echter reagiert.
       *[unicycle] Der virtuelle Rollstuhl, der sofort reagiert.
    }
drives-others-hang =
    { $device ->
        [shirt] Das Shirt wird nicht geöffnet, weil noch { $count } frühere Versuche hängen, ein Gerät zu öffnen. Starten Sie bodydrive neu.
        [body] Der Körper wird nicht geöffnet, weil noch { $count } frühere Versuche hängen, ein Gerät zu öffnen. Starten Sie bodydrive neu.
        [chair] Der Rollstuhl wird nicht geöffnet, weil noch { $count } frühere Versuche hängen, ein Gerät zu öffnen. Starten Sie bodydrive neu.
       *[tracker] Der Kopftracker wird nicht geöffnet, weil noch { $count } frühere Versuche hängen, ein Gerät zu öffnen. Starten Sie bodydrive neu.
    }
drives-opening-slow =
    { $device ->
        [shirt] Das Shirt ließ sich nicht innerhalb von { $seconds } Sekunden öffnen. Prüfen Sie seine Einstellungen.
        [body] Der Körper ließ sich nicht innerhalb von { $seconds } Sekunden öffnen. Prüfen Sie seine Einstellungen.
        [chair] Der Rollstuhl ließ sich nicht innerhalb von { $seconds } Sekunden öffnen. Prüfen Sie seine Einstellungen.
       *[tracker] Der Kopftracker ließ sich nicht innerhalb von { $seconds } Sekunden öffnen. Prüfen Sie seine Einstellungen.
    }
# $library is the name of a Python package.
drives-library-missing =
    { $device ->
        [shirt] Das Shirt braucht die Bibliothek „{ $library }“, die nicht installiert ist. Installieren Sie sie, und wählen Sie das Shirt dann neu.
        [body] Der Körper braucht die Bibliothek „{ $library }“, die nicht installiert ist. Installieren Sie sie, und wählen Sie den Körper dann neu.
        [chair] Der Rollstuhl braucht die Bibliothek „{ $library }“, die nicht installiert ist. Installieren Sie sie, und wählen Sie den Rollstuhl dann neu.
       *[tracker] Der Kopftracker braucht die Bibliothek „{ $library }“, die nicht installiert ist. Installieren Sie sie, und wählen Sie den Kopftracker dann neu.
    }
# $error is the name of an error in the program's code.
drives-cannot-open =
    { $device ->
        [shirt] Das Shirt lässt sich nicht öffnen ({ $error }). Prüfen Sie seine Einstellungen.
        [body] Der Körper lässt sich nicht öffnen ({ $error }). Prüfen Sie seine Einstellungen.
        [chair] Der Rollstuhl lässt sich nicht öffnen ({ $error }). Prüfen Sie seine Einstellungen.
       *[tracker] Der Kopftracker lässt sich nicht öffnen ({ $error }). Prüfen Sie seine Einstellungen.
    }
# $error is the name of an error in the program's code, $message is what it says.
drives-cannot-open-message =
    { $device ->
        [shirt] Das Shirt lässt sich nicht öffnen ({ $error }: { $message }). Prüfen Sie seine Einstellungen.
        [body] Der Körper lässt sich nicht öffnen ({ $error }: { $message }). Prüfen Sie seine Einstellungen.
        [chair] Der Rollstuhl lässt sich nicht öffnen ({ $error }: { $message }). Prüfen Sie seine Einstellungen.
       *[tracker] Der Kopftracker lässt sich nicht öffnen ({ $error }: { $message }). Prüfen Sie seine Einstellungen.
    }
# $action is the name of a command, $error is the name of an error in the program's code, $message is what it says.
drives-defect = Das Programm hat einen Fehler, und „{ $action }“ wurde nicht ausgeführt ({ $error }: { $message }). Bitte melden Sie ihn.

## The control process

drives-not-a-command = Das ist kein Befehl. Senden Sie in jeder Zeile ein JSON-Objekt mit einer ganzen Zahl „id“ und einem Wort „do“.
drives-no-reason = Der Steuerungsprozess hat abgelehnt, ohne einen Grund zu nennen.
# $command is the name of a command.
drives-process-silent = Der Steuerungsprozess hat auf „{ $command }“ nicht innerhalb von { $seconds } Sekunden geantwortet.
drives-process-ended = Der Steuerungsprozess wurde beendet, und ein neuer wird gestartet. Versuchen Sie es gleich noch einmal.
drives-process-not-started = Der Steuerungsprozess ist nicht gestartet. Lesen Sie seine Meldung in der Konsole.
drives-process-restarting = Der Steuerungsprozess wird neu gestartet, und der Rollstuhl steht. Versuchen Sie es gleich noch einmal.
drives-process-no-answer = Der Steuerungsprozess hat nicht geantwortet, und der Rollstuhl steht. Versuchen Sie es noch einmal.

## A recorded drive, computed again

drives-replay-no-frame = in der Aufzeichnung ist kein Datenpaket des Shirts; wählen Sie eine andere
drives-replay-empty = die Aufzeichnung ist leer; wählen Sie eine andere
# Two counts of channels.
drives-replay-channels = die Zahl der Kanäle ist in der Aufzeichnung { $recorded } und im Kalibrierungsprofil { $expected }; verwenden Sie das Profil desselben Shirts
# $stated is what stands in the file run.json; the others are in Hz.
drives-replay-rate = in run.json steht als Abtastrate { $stated }, erlaubt sind { $slowest } bis { $fastest } Hz; korrigieren Sie sie
# Begins a sentence on what is wrong: a field of the file run.json of the recording.
drives-replay-part = run.json, { $part }
