### Texts about what a clinic stores: patients, sessions, people, chairs, screens, floor plans, the disk, the database.

store-no-patient = Es gibt keinen Patienten { $patient }. Wählen Sie einen aus der Liste der Patienten.
store-no-session = Es gibt keine Sitzung { $session }. Wählen Sie eine aus der Liste des Patienten.
store-no-trial = Es gibt keinen Durchgang { $trial }. Wählen Sie einen aus der Liste der Durchgänge.
store-no-drive = Es gibt keine Fahrt { $drive }. Wählen Sie eine aus der Liste der Fahrten.
store-no-chair = Es gibt keinen Rollstuhl { $chair }. Wählen Sie einen aus der Liste, oder koppeln Sie ihn zuerst.
store-no-screen = Es gibt keinen gekoppelten Bildschirm { $screen }. Wählen Sie einen aus der Liste.
store-no-person = Es gibt keine Person { $person }. Wählen Sie eine aus der Liste.
store-nobody-called = Niemand heißt hier „{ $name }“. Sehen Sie in der Liste der Personen nach.
store-no-incident = Es gibt kein Vorkommnis { $incident }. Sehen Sie in der Liste nach.
store-no-deleted-patient = Es gibt keinen gelöschten Patienten { $patient }. Sehen Sie in der Liste nach.
store-no-set = Es gibt kein gespeichertes Set „{ $title }“. Wählen Sie eines aus der Liste.
store-no-plan = Es gibt keinen eigenen Grundriss „{ $name }“. Wählen Sie einen aus der Liste.
store-no-deleted-plan = Es gibt keinen gelöschten Grundriss „{ $name }“. Sehen Sie in der Liste nach.
store-no-replaced-file = Eine solche ersetzte Datei gibt es nicht, oder ihre 30 Tage sind vorbei. Sehen Sie in der Liste nach.

store-code-taken = Der Code „{ $code }“ gehört schon zu { $pseudonym }. Wählen Sie einen anderen Code.
store-code-deleted = Der Code „{ $code }“ gehört zu einem gelöschten Patienten. Wählen Sie einen anderen Code, oder lassen Sie eine verantwortliche Person das Löschen auf der Seite „{ rail-backup }“ rückgängig machen.
store-patient-here = Eine Sitzung von { $pseudonym } ist offen. Beenden Sie sie zuerst, und löschen Sie dann den Patienten.
# $time: a time of day.
store-session-open =
    { $trials ->
        [one] Eine Sitzung von { $code } ist offen: begonnen um { $time }, { $trials } Durchgang. Beenden Sie sie zuerst, oder bestätigen Sie, dass die neue Sitzung sie beendet.
       *[other] Eine Sitzung von { $code } ist offen: begonnen um { $time }, { $trials } Durchgänge. Beenden Sie sie zuerst, oder bestätigen Sie, dass die neue Sitzung sie beendet.
    }
# $person: the name of the person who began the session. $time: a time of day.
store-session-open-by =
    { $trials ->
        [one] Eine Sitzung von { $code } ist offen: begonnen von { $person } um { $time }, { $trials } Durchgang. Beenden Sie sie zuerst, oder bestätigen Sie, dass die neue Sitzung sie beendet.
       *[other] Eine Sitzung von { $code } ist offen: begonnen von { $person } um { $time }, { $trials } Durchgänge. Beenden Sie sie zuerst, oder bestätigen Sie, dass die neue Sitzung sie beendet.
    }
store-trial-running = Dieser Durchgang läuft noch. Beenden Sie ihn zuerst.

store-no-consent =
    { $consent ->
        [recording] { $code } hat nicht in die Aufzeichnung eingewilligt. Fragen Sie den Patienten, und tragen Sie den Tag unter „{ record-link }“ ein. Üben mit dem simulierten Shirt braucht keine Einwilligung.
        [clinic_prior] { $code } hat nicht in die Verwendung für andere Patienten der Klinik eingewilligt. Fragen Sie den Patienten, und tragen Sie den Tag unter „{ record-link }“ ein.
       *[sharing] { $code } hat nicht in die Weitergabe nach außen eingewilligt. Fragen Sie den Patienten, und tragen Sie den Tag unter „{ record-link }“ ein.
    }

store-person-name-taken = Es gibt hier schon jemanden mit dem Namen „{ $name }“. Wählen Sie einen anderen Namen für die Anmeldung.
store-last-owner = Außer { $name } kann sich keine verantwortliche Person anmelden. Deshalb bleibt { $name } verantwortlich. Machen Sie zuerst jemand anderes verantwortlich.
store-patients-of-reviewers = Patienten werden nur für Mitlesende ausgewählt. Verantwortliche und Fachkräfte arbeiten mit allen.
# $name: of a person. The link is an invitation to choose a password.
store-invited-disabled = { $name } ist gesperrt. Entsperren Sie diese Person zuerst, und erstellen Sie dann einen Link.
store-sign-in-ended = Diese Anmeldung ist beendet. Melden Sie sich wieder an.

store-chair-name-taken = Es gibt schon einen Rollstuhl „{ $name }“. Wählen Sie einen anderen Namen, oder entkoppeln Sie jenen zuerst.
# A key: the secret that a chair shares with this computer.
store-keys-used-up = Alle Nummern für Schlüssel sind vergeben. Beginnen Sie mit einem neuen Ordner für die Klinik.

# The code pairs a screen of the patient.
store-code-over = Die Sitzung dieses Codes ist beendet. Bitten Sie um einen neuen Code.
store-screens-most = Es sind schon { $most } Bildschirme gekoppelt. Entkoppeln Sie zuerst einen auf der Seite der Fachkraft.

store-steps-mixed = Manche Schritte wurden mit einem Shirt aufgezeichnet, das niemand trägt, andere mit einem getragenen. Beginnen Sie die Kalibrierung neu, mit einem von beiden.
store-steps-mixed-sensors = Manche Schritte wurden mit anderen Sensoren aufgezeichnet als die übrigen. Beginnen Sie die Kalibrierung neu, mit einer einzigen Art von Sensoren.
store-step-interrupted = Während dieses Schritts wurde das Programm neu gestartet. Wiederholen Sie ihn.
store-not-calibrated = Noch ist nichts kalibriert. Kalibrieren Sie zuerst, und tippen Sie auf „{ result-accept }“.
store-set-of-other-version = Eine andere Version des Programms hat diese Steuerung gespeichert, und diese kann sie nicht lesen. Kalibrieren Sie neu, oder starten Sie jene Version.
# $title: the name of a saved set of controls.
store-set-of-other-joints = „{ $title }“ wurde für ein Shirt mit anderen Gelenken erstellt und passt nicht zu dieser Kalibrierung. Ordnen Sie die Gesten neu zu.
store-nothing-to-undo = Es gibt nichts rückgängig zu machen: Dies ist die erste Einstellung.
store-nothing-to-redo = Es gibt nichts zu wiederholen.
store-no-map-before = Diese Version stammt direkt aus einer Kalibrierung. Davor gibt es keine, die sich wiederherstellen lässt.

# $made: a date.
store-incident-not-erased = { $code } gehört zum Vorkommnis vom { $made } und darf nicht endgültig gelöscht werden. Zuerst muss eine verantwortliche Person die Sperre des Vorkommnisses aufheben.
# $until: a date.
store-records-kept = Die Dokumentation von { $code } muss bis { $until } aufbewahrt werden. Machen Sie das Löschen rückgängig, und löschen Sie dann noch einmal mit einem Grund.
# $until: a date.
store-records-kept-reason = Die Dokumentation von { $code } muss bis { $until } aufbewahrt werden. Um sie früher zu löschen, geben Sie einen Grund an.
store-incident-lifted = Die Sperre dieses Vorkommnisses wurde schon aufgehoben.
store-clock-hours =
    { $hours ->
        [one] Die Uhr dieses Rechners ist um { $hours } Stunde vorgerückt, in der er nicht lief: Sie wurde vorgestellt, oder der Rechner war aus. Deswegen wird nichts endgültig gelöscht: Gelöschte Patienten, ersetzte Dateien und alte Backups bleiben um so viel länger. Prüfen Sie Datum und Uhrzeit.
       *[other] Die Uhr dieses Rechners ist um { $hours } Stunden vorgerückt, in denen er nicht lief: Sie wurde vorgestellt, oder der Rechner war aus. Deswegen wird nichts endgültig gelöscht: Gelöschte Patienten, ersetzte Dateien und alte Backups bleiben um so viel länger. Prüfen Sie Datum und Uhrzeit.
    }
# $days: 2 or more.
store-clock-days = Die Uhr dieses Rechners ist um { $days } Tage vorgerückt, in denen er nicht lief: Sie wurde vorgestellt, oder der Rechner war aus. Deswegen wird nichts endgültig gelöscht: Gelöschte Patienten, ersetzte Dateien und alte Backups bleiben um so viel länger. Prüfen Sie Datum und Uhrzeit.
store-erased-list-unreadable = Die Liste der endgültig gelöschten Patienten in { $file } ist nicht lesbar. Legen Sie eine Kopie davon dorthin zurück, aus dem Ordner der Backups oder aus einem Backup.

store-disk-full = Der Datenträger der Aufzeichnungen ist voll. Es wird nichts mehr aufgezeichnet, gefahren oder gespeichert. Die Sitzung lässt sich noch beenden, und Abmelden ist möglich. Schaffen Sie Platz auf dem Rechner, auf dem bodydrive läuft.
store-disk-little = Auf dem Datenträger der Aufzeichnungen sind nur { $free } GB frei. Unter { $needed } GB wird nichts mehr aufgezeichnet oder gefahren. Schaffen Sie Platz.
store-disk-no-session = Es wird keine Sitzung geöffnet: Auf dem Datenträger der Aufzeichnungen sind nur { $free } MB frei. Machen Sie auf dem Rechner, auf dem bodydrive läuft, { $needed } MB frei, und öffnen Sie die Sitzung dann noch einmal.
store-no-room-to-make =
    { $what ->
        [archive] Für dieses Archiv reicht der Platz nicht: { $needed } MB müssen auf dem Datenträger frei sein, auf dem es erstellt wird, frei sind { $free } MB. Schaffen Sie Platz, und versuchen Sie es dann noch einmal. Es wurde nichts erstellt.
       *[export] Für diesen Export reicht der Platz nicht: { $needed } MB müssen auf dem Datenträger frei sein, auf dem er erstellt wird, frei sind { $free } MB. Schaffen Sie Platz, und versuchen Sie es dann noch einmal. Es wurde nichts erstellt.
    }

# $name: of a file or floor plan.
store-name-taken = „{ $name }“ gibt es schon. Behalten Sie beide.
# $name: of a file or floor plan.
store-name-taken-replace = „{ $name }“ gibt es schon. Behalten Sie beide, oder ersetzen Sie, was da ist.
store-plan-name-bundled = Der Name „{ $name }“ gehört zu einem mitgelieferten Plan. Wählen Sie einen anderen.
store-plans-most = Es gibt schon { $most } eigene Grundrisse. Löschen Sie zuerst einige.
store-plan-bundled-kept = Ein mitgelieferter Plan bleibt, wie er ist. Speichern Sie Ihren als neuen Plan.
store-plan-bundled-not-deleted = Ein mitgelieferter Plan lässt sich nicht löschen.
store-plan-saved-meanwhile = Jemand anderes hat diesen Grundriss inzwischen gespeichert. Speichern Sie Ihren als neuen Plan.

store-database-held = Ein anderes Programm hält die Datenbank belegt. Warten Sie, bis es beendet ist, und versuchen Sie es dann noch einmal.
store-database-damaged = Die Datenbank ist beschädigt. Legen Sie eine Kopie davon zurück, oder beginnen Sie mit einem neuen Ordner.
# The write-ahead log is a file of the database, not the log of who did what.
store-erased-but-read = Das endgültige Löschen ist erledigt. Die Datenbank wird aber gerade gelesen, deshalb enthält ihre Write-Ahead-Log-Datei noch Bytes des Gelöschten. Sie verschwinden, wenn das Programm endet.
store-copy-unequal = Die Kopie der Datenbank { $database } ist ihr nicht gleich. Prüfen Sie den Datenträger, und versuchen Sie es dann noch einmal.
store-copy-no-room = Für eine Kopie der Datenbank, die vor allem anderen nötig ist, reicht der Platz nicht. Machen Sie auf dem Datenträger von { $folder } { $needed } MB frei, und versuchen Sie es dann noch einmal. Nichts wurde geändert.
# $revision, $newest: numbers of schemas, such as 0002. $version: of this program.
store-schema-newer = Die Datenbank { $database } wurde zuletzt von einem neueren bodydrive geöffnet: Das Schema ist { $revision }, und dieses Programm ({ $version }) kennt Schemas bis { $newest }. Nichts wurde geändert. Starten Sie wieder das neuere Programm.
# $revision, $newest: numbers of schemas, such as 0002. $problem: the error of the database, in English. $copy: the name of a file.
store-schema-failed = Die Datenbank { $database } konnte nicht von Schema { $revision } auf { $newest } gebracht werden ({ $problem }). Sie ist, wie sie war, mit einer Kopie in { $copy }. Starten Sie das Programm, das sie zuletzt geöffnet hat, und melden Sie dies.
