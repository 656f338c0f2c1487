### Texts of reports (PDF and HTML) of a session or of a patient's course of sessions, and refusals to make one.

# Refusals

report-no-session-yet = Dieser Patient hat noch keine Sitzung. Starten Sie zuerst eine, und erstellen Sie dann den Bericht.
report-no-session = Dieser Patient hat keine Sitzung { $session }. Wählen Sie eine, die begonnen wurde.
report-no-language = --language { $language } wird nicht angeboten. Zur Wahl stehen: { $languages }.
# $refusal is a sentence: the patient has not consented to sharing outside the clinic.
report-needs-consent = { $refusal } Eine Kopie für den Patienten braucht keine Einwilligung.

# Head of the document

report-of-course =
    { $count ->
        [one] Verlauf über { $count } Sitzung
       *[other] Verlauf über { $count } Sitzungen
    }
report-of-session = Sitzung { $session }
report-made = { $clinic }, Bericht vom { $moment }
report-source = Quelle:
report-no-source = Kein Durchgang zählt, deshalb gibt es keine Quelle der Signale.

# Headings and labels

report-goal = Ziel
report-goals-between = Ziele der Sitzungen dazwischen
report-trials = Durchgänge
report-no-trial = Kein Durchgang zählt.
report-tests = Zwei-Minuten-Tests
report-drives = Fahrten mit echten Rollstühlen
report-condition = Bedingungen
report-scales = Assessments
report-no-scale = Es wurde kein Assessment eingetragen.
report-sessions = Sitzungen
report-notes = Notizen
report-comments = Kommentare zu Durchgängen
report-signature = Unterschrift
# Below the line on which somebody signs on paper.
report-signature-line = Name, Datum, Unterschrift

# Facts: names and values

report-fact-reader = Für wen
report-fact-reader-patient = Kopie für den Patienten
report-fact-when = Wann
# $first and $last are days.
report-days = { $first } bis { $last }
# $begun is a day with a time of day, $ended a time of the same day.
report-when-ended = { $begun } bis { $ended }
report-when-open = { $begun }, noch offen
report-fact-opened = Begonnen von
report-fact-opened-unknown = nicht erfasst
report-fact-trials = Durchgänge
report-trials-counted =
    { $count ->
        [one] { $count } Durchgang zählt
       *[other] { $count } Durchgänge zählen
    }
report-trials-left-out =
    { $count ->
        [one] { $count } Durchgang zählt, { $left } nicht ({ $reasons })
       *[other] { $count } Durchgänge zählen, { $left } nicht ({ $reasons })
    }
# A reason for which a trial was left out.
report-trial-not-measured = ließ sich nicht auswerten
report-fact-imported = Importiert
# Sessions that were held in another clinic: from $first to $last, of that clinic, imported by a person on a day.
report-imported =
    { $count ->
        [one] Sitzung { $first }, Herkunft: { $clinic }, importiert von { $person }, { $day }
       *[other] Sitzung { $first } bis { $last }, Herkunft: { $clinic }, importiert von { $person }, { $day }
    }
report-fact-software = Software
# $recorded are the versions of the program with which the sessions were recorded.
report-software = bodydrive { $version }; aufgezeichnet mit { $recorded }
report-software-unknown = bodydrive { $version }; zur Zeit der Sitzung: nicht erfasst
report-fact-fingerprint = Fingerabdruck der Steuerung (SHA-256)
report-fingerprint-none = keiner: Es wurde nichts gefahren
report-fact-head = Stand des Protokolls
# The rows of the clinic's log, and the check sum of the newest one.
report-head =
    { $count ->
        [one] { $count } Zeile, { $hash }
       *[other] { $count } Zeilen, { $hash }
    }
report-head-unknown = nicht erfasst

# What people wrote

report-no-goal = Es wurde kein Ziel eingetragen.
report-no-note = Keine Notizen.
report-note = { $written }, { $person }
report-note-revised = { $written }, { $person }, geändert { $revised }
# $remark is the head of a note or of a comment: who wrote it, and when.
report-remark-of-session = Sitzung { $session }, { $remark }
# $plan is the title of the floor plan, $time a moment of the trial.
report-comment = { $plan }, Durchgang { $number }, bei { $time } s: { $person }, { $written }
report-comment-revised = { $plan }, Durchgang { $number }, bei { $time } s: { $person }, { $written }, geändert { $revised }
report-comments-left-out =
    { $count ->
        [one] { $count } Kommentar zu früheren Durchgängen wird nicht gezeigt.
       *[other] { $count } Kommentare zu früheren Durchgängen werden nicht gezeigt.
    }
report-signed = Abgezeichnet von { $person }, { $moment }.
report-signed-all = Alle Sitzungen sind abgezeichnet, die letzte von { $person }, { $moment }.

# Tables of sessions and of outcome scales

report-sessions-session = Sitzung
report-sessions-date = Datum
report-sessions-opened = Begonnen von
report-sessions-trials = Durchgänge
report-sessions-discarded = Zählen nicht
report-sessions-signed = Abgezeichnet von
report-scales-scale = Assessment
report-scales-total = Gesamtwert
report-scales-totals = Gesamtwerte, der älteste zuerst
report-scales-day = Datum

# Condition: the calibration, the controls and their settings

report-condition-none = Es wurde nichts gefahren, deshalb gibt es keine Bedingungen zu berichten.
report-condition-others =
    { $count ->
        [one] Gezeigt wird das neueste Set. Auch mit { $count } anderen Set wurde gefahren.
       *[other] Gezeigt wird das neueste Set. Auch mit { $count } anderen Sets wurde gefahren.
    }
report-fact-calibration = Kalibrierung
# $origin is how this version of the calibration came about, $parent the version that it was made from (0: none),
# $methods how it was calibrated, $source what was worn, or saw the movements.
report-calibration =
    Version { $version }{ $origin ->
        [adaptation] , angepasst
        [donning] , an den Sitz des Shirts angepasst
        [back] , wiederhergestellt
       *[calibration] { "" }
    }{ $parent ->
        [0] { "" }
       *[other] { " " }{ $origin ->
            [back] statt Version { $parent }
           *[other] aus Version { $parent }
        }
    }, { $methods }{ $source ->
        [camera] , mit einer Kamera
        [phones] , mit Telefonen
        [slimevr] , mit Trackern
        [bluetooth] , mit Bluetooth-Sensoren
        [brainflow] , mit einer Platine (BrainFlow)
        [lsl] , mit Signalen über LSL
        [simulated] , mit simuliertem Shirt
        [unknown] , Quelle nicht erfasst
       *[worn] { "" }
    }
report-method-pca = Standard
report-method-guided = aus den Vorgaben gelernt
report-method-prior = von anderen Personen gelernt
report-fact-modes = Fahrverhalten
report-modes =
    Vor und zurück: { $forward ->
        [acceleration] hält das Tempo
        [velocity] folgt der Bewegung
       *[unknown] nicht erfasst
    }. Drehen: { $turning ->
        [acceleration] dreht weiter
        [velocity] folgt der Bewegung
       *[unknown] nicht erfasst
    }
report-fact-set = Set
report-fact-stops = Hält von selbst an nach
report-stops = { $time } s
report-stops-turning = { $time } s, beim Drehen { $turning } s
report-fact-speeds = Geschwindigkeiten
report-speeds = Vorwärts { $forward } m/s, rückwärts { $reverse } m/s, Drehen { $turn } °/s
report-fact-damping = Tremordämpfung
report-damping = { $frequency } Hz
report-setting-unknown = nicht erfasst
report-controls-control = Wirkung
report-controls-movement = Bewegung
report-controls-from = Zählt ab
report-controls-full = Voll ab
report-controls-gain = Verstärkung
report-control-faster = Schneller
report-control-slower = Langsamer
report-control-left = Links drehen
report-control-right = Rechts drehen
report-control-stop = Stopp
# A movement of a joint, for example "Right wrist, going back, held".
report-movement =
    { $joint }{ $direction ->
        [back] , zurück
       *[forth] { "" }
    }{ $feature ->
        [displacement] , gehalten
       *[rate] { "" }
    }
report-share = { $share } %
# A share of the person's full movement in each second.
report-share-rate = { $share } % / s

# Drives of real chairs

report-drives-drive = Fahrt
report-drives-chair = Rollstuhl
report-drives-begun = Beginn
report-drives-lasted = Dauer
report-drives-distance = Gefahrener Weg
report-drives-end = Ende
report-drives-session = Sitzung
report-drives-count = Fahrten
report-drives-chairs = Rollstühle
report-drives-faults = Durch Stopp oder Störung beendet
report-drive-ended = von Hand beendet
report-drive-fault = durch Stopp oder Störung beendet
report-drive-goes-on = läuft noch
report-drive-end-unknown = nicht erfasst
report-drive-minutes = { $minutes } min { $seconds } s
report-drive-seconds = { $seconds } s
report-drive-distance = { $distance } m
report-drive-distance-unknown = vom Rollstuhl nicht gemeldet

# A task: its measures, trajectories and learning curve

report-measures-measure = Messwert
report-measures-now = Jetzt
report-measures-band = Schwankung
report-measures-verdict = Bewertung
report-nothing-before = kein Vergleich möglich
report-task-trials =
    { $count ->
        [one] { $count } Durchgang zählt; Ziel erreicht: { $reached }.
       *[other] { $count } Durchgänge zählen; Ziel erreicht: { $reached }.
    }
# Of these trials, $used were for getting used to the task.
report-task-trials-used =
    { $count ->
        [one] { $count } Durchgang zählt, davon { $used } zur Eingewöhnung; Ziel erreicht: { $reached }.
       *[other] { $count } Durchgänge zählen, davon { $used } zur Eingewöhnung; Ziel erreicht: { $reached }.
    }
# $trials are trials with what interrupted them.
report-interrupted = Unterbrochen: { $trials }.
report-interrupted-more = Unterbrochen: { $trials } und { $more } weitere.
report-interrupted-trial = Durchgang { $number } ({ $interruption })
report-compared =
    Sitzung { $later } ({ $second ->
        [one] { $second } Durchgang
       *[other] { $second } Durchgänge
    }) gegen Sitzung { $earlier } ({ $first ->
        [one] { $first } Durchgang
       *[other] { $first } Durchgänge
    }).
report-compared-none = Zum Vergleich gibt es keine frühere Sitzung mit Durchgängen dieser Aufgabe.
# For those who do not see the drawing. $before, $now are levels of the measure with their unit, $noise a range.
report-band = { $measure }: { $before }, jetzt { $now }; übliche Schwankung { $noise }.
# A range of a measure; a unit may follow.
report-range = { $low } bis { $high }
# plan: title of a floor plan or scene; path: title of one of its paths.
report-task-title = { $plan }: { $path }
report-trajectories-title = Fahrspuren über der Strecke
# $others are the trajectories that those of session $newest are compared with; $chosen is 0 when all are drawn.
report-trajectories =
    { $count ->
        [one] { $count } Fahrspur
       *[other] { $count } Fahrspuren
    } aus Sitzung { $newest } (orange){ $others ->
        [none] { "" }
        [sessions] { " " }über { $before } aus früheren Sitzungen (grau)
       *[session] { " " }über { $before } aus Sitzung { $earlier } (grau)
    }{ $chosen ->
        [0] { "" }
       *[other] , gleichmäßig aus { $chosen } Durchgängen gewählt
    }{ $lost ->
        [0] { "" }
        [one] ; { $lost } Aufzeichnung ist nicht lesbar
       *[other] ; { $lost } Aufzeichnungen sind nicht lesbar
    }.
report-curve-title = Lernkurve: { $measure } in jedem Durchgang
report-curve-words =
    { $count ->
        [one] { $count } Durchgang; Sitzung { $session } ist orange. Ringe: zur Eingewöhnung. S: Eine Sitzung beginnt.
       *[other] { $count } Durchgänge; Sitzung { $session } ist orange. Ringe: zur Eingewöhnung. S: Eine Sitzung beginnt.
    }
# For those who do not see the drawing.
report-curve-of =
    { $count ->
        [one] { $measure } über { $count } Durchgang.
       *[other] { $measure } über { $count } Durchgänge.
    }
# Below the axis of a learning curve, between two numbers of trials.
report-curve-axis = Durchgang
report-scale-bar = { $length } m

# Two-minute tests

report-tests-test = Test
report-tests-complete =
    { $count ->
        [one] { $count } vollständiger Test.
       *[other] { $count } vollständige Tests.
    }
report-tests-complete-until =
    { $count ->
        [one] { $count } vollständiger Test bis Sitzung { $session }.
       *[other] { $count } vollständige Tests bis Sitzung { $session }.
    }
report-tests-left-out =
    { $count ->
        [one] { $count } Test wird nicht gezeigt.
       *[other] { $count } Tests werden nicht gezeigt.
    }
report-test-of-session = { $number }, Sitzung { $session }
# Two tests by their numbers.
report-test-against = { $later } gegen { $earlier }
report-test-ended = vorzeitig beendet: zählt nicht
report-test-stopped = gestoppt: zählt nicht
report-test-interrupted = unterbrochen: zählt nicht
report-test-unreadable = seine Aufzeichnung ist nicht lesbar

# Foot of the document

report-explanation = Schwankung ist der Unterschied zwischen den eigenen Durchgängen dieser Person bei der Aufgabe, wenn sich nichts geändert hat. Auch dann steht auf etwa einer von zwanzig Seiten durch Zufall „besser“ oder „schlechter“. Ein Durchgang, der das Ziel verfehlt hat, zählt höchstens so gut wie das schlechteste Zehntel der früheren Durchgänge, die es erreicht haben. Die ersten drei Durchgänge einer Aufgabe dienen der Eingewöhnung und werden nicht verglichen. Für diese Messwerte des Rollstuhlfahrens ist keine kleinste nachweisbare Veränderung (MDC) veröffentlicht.
# $characters are numbers of characters with their English names.
report-missing-characters = Keine Schrift hat hier diese Zeichen, deshalb stehen an ihrer Stelle ihre Nummern: { $characters }.
report-missing-characters-more = Keine Schrift hat hier diese Zeichen, deshalb stehen an ihrer Stelle ihre Nummern: { $characters } und { $more } weitere.
report-character-nameless = unbenannt
