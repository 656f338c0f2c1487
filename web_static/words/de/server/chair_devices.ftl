### What chairs say of themselves, and why one cannot be used.

# $x and $y are the place in m.
chairdev-no-room = der Rollstuhl kann nicht bei ({ $x }; { $y }) stehen, dort ist etwas im Weg; wählen Sie eine freie Stelle
# The virtual chair's pose can be reported to another program, at the address $place.
chairdev-no-report =
    an { $place } lassen sich keine Meldungen senden ({ $why ->
        [no-address] es gibt diese Adresse nicht
       *[other] { $why }
    }); geben Sie Host und Port an

# $name is the chair's name, $place its address HOST:PORT; $problem is a message device-key-...
chairdev-not-opened = der Rollstuhl „{ $name }“ lässt sich nicht verwenden: { $problem }
chairdev-not-reached =
    der Rollstuhl „{ $name }“ ist unter { $place } nicht erreichbar ({ $why ->
        [no-address] es gibt diesen Host nicht
       *[other] { $why }
    }); korrigieren Sie seine Adresse
chairdev-silent = „{ $name }“ unter { $place } antwortet nicht. Prüfen Sie den Strom des Rollstuhls und das Netz.
chairdev-switch-refuted = „{ $name }“ unter { $place }: Die Meldung seines Stoppschalters war veraltet. Drücken und lösen Sie den Schalter noch einmal.
# $reason is a message chairdev-reason.
chairdev-telemetry =
    „{ $name }“ unter { $place }, { $state ->
        [stop-switch] Stoppschalter gedrückt
        [disarmed] gesperrt
        [checking] wartet auf Ruhe
        [armed] freigegeben
       *[fault] nicht bereit
    }{ $battery ->
        [unknown] {""}
       *[other] , Akku { $battery } %
    }.{ $reason ->
        [none] {""}
       *[other] {" "}{ $reason }
    }
# Why a chair stands, as it reports itself. “Sender” is the program that commands it.
chairdev-reason =
    { $reason ->
        [silent] Zu lange kam kein neuer Fahrbefehl beim Rollstuhl an.
        [stop_command] Der Rollstuhl erhielt einen Stopp.
        [withdrawn] Das steuernde Programm hat die Erlaubnis zum Fahren zurückgenommen.
        [stop_input] Der Rollstuhl wurde mit seinem eigenen Schalter gestoppt.
        [not_neutral] Nach der Freigabe verlangten die Fahrbefehle nicht lange genug Stillstand (eine halbe Sekunde).
        [late] Der Rechner des Rollstuhls stand zu lange still.
        [output] Die Elektronik des Rollstuhls nahm keine Fahrbefehle an.
        [own_joystick] Jemand hat den Joystick des Rollstuhls bewegt.
        [chair_error] Der Rollstuhl meldet einen eigenen Fehler. Sehen Sie auf seine Anzeige.
        [chair_off] Der Rollstuhl ist ausgeschaltet.
       *[ending] Der Empfänger des Rollstuhls wurde beendet.
    }
