### Texte zur Bewertung von Änderungen.

verdict-range = { $low } bis { $high }
verdict-title = Besser, oder nur Schwankung?
verdict-column = Bewertung
verdict-noise = Übliche Schwankung
verdict-familiarisation = Dies ist einer der ersten drei Durchgänge dieser Aufgabe. Sie dienen der Eingewöhnung und werden nicht verglichen.
verdict-means = Schwankung ist der Unterschied zwischen den eigenen Durchgängen dieser Person bei dieser Aufgabe, wenn sich nichts geändert hat. Eine Bewertung braucht insgesamt fünf Durchgänge der Aufgabe. Von einer Sitzung zur nächsten braucht sie außerdem frühere Sitzungen oder drei andere Personen der Klinik, die diese Aufgabe gefahren sind.
verdict-chance = Bewertet werden nur die drei wichtigsten Messwerte einer Aufgabe und wie oft das Ziel erreicht wurde. Auch wenn sich nichts geändert hat, steht auf etwa einer von zwanzig Seiten durch Zufall „besser“ oder „schlechter“.
verdict-missed = Im Vergleich von Sitzungen zählt ein Durchgang, der das Ziel verfehlt hat, höchstens so gut wie das schlechteste Zehntel der früheren Durchgänge, die es erreicht haben.
verdict-unpublished = Für diese Messwerte des Rollstuhlfahrens ist keine kleinste nachweisbare Veränderung (MDC) veröffentlicht.
verdict-sessions =
    Sitzung { $later } ({ $laterDay }, { $laterTrials ->
        [one] { $laterTrials } Durchgang
       *[other] { $laterTrials } Durchgänge
    }) gegen Sitzung { $earlier } ({ $earlierDay }, { $earlierTrials ->
        [one] { $earlierTrials } Durchgang
       *[other] { $earlierTrials } Durchgänge
    })
verdict-session = Sitzung { $number }
verdict-all = Alle Messwerte
verdict-counts =
    { $count ->
        [one] { $count } von { $all } Durchgängen dieser Aufgabe lässt sich vergleichen: Die ersten drei dienen der Eingewöhnung.
       *[other] { $count } von { $all } Durchgängen dieser Aufgabe lassen sich vergleichen: Die ersten drei dienen der Eingewöhnung.
    }
verdict-counts-none = Noch kein Durchgang dieser Aufgabe lässt sich vergleichen ({ $all } gefahren): Die ersten drei dienen der Eingewöhnung.
verdict-needed = Eine Bewertung braucht { $count } vergleichbare Durchgänge aus zwei Sitzungen zusammen. Fahren Sie diese Aufgabe noch einmal.
verdict-few =
    { $count ->
        [one] Bisher lässt sich { $count } Durchgang vergleichen, { $needed } sind nötig.
       *[other] Bisher lassen sich { $count } Durchgänge vergleichen, { $needed } sind nötig.
    }
verdict-few-sessions = { $count } Durchgänge lassen sich vergleichen, das genügt. Zum Vergleich von Sitzungen fehlt noch eine weitere Sitzung, oder drei andere Personen der Klinik müssen diese Aufgabe gefahren sein.
verdict-compare = Sitzungen vergleichen
