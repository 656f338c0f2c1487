### Learning curves: what became of a measure over a person's trials, and the statistics behind it. $subject is a measure
### within a sentence, such as "the area off the path"; "it" is the measure.

learning-few = Für eine Lernkurve gibt es zu wenige Durchgänge, die das Ziel erreicht haben: { $count } von mindestens { $least }.

## The head of a sentence, before a colon. $sessions is 0 where it is not known in how many sessions the trials were driven.

learning-head-better =
    { $sessions ->
        [0] Über die Schwankung hinaus besser, in { $trials } Durchgängen
        [one] Über die Schwankung hinaus besser, in { $trials } Durchgängen aus { $sessions } Sitzung
       *[other] Über die Schwankung hinaus besser, in { $trials } Durchgängen aus { $sessions } Sitzungen
    }
learning-head-worse =
    { $sessions ->
        [0] Über die Schwankung hinaus schlechter, in { $trials } Durchgängen
        [one] Über die Schwankung hinaus schlechter, in { $trials } Durchgängen aus { $sessions } Sitzung
       *[other] Über die Schwankung hinaus schlechter, in { $trials } Durchgängen aus { $sessions } Sitzungen
    }
learning-head-within =
    { $sessions ->
        [0] Innerhalb der Schwankung, in { $trials } Durchgängen
        [one] Innerhalb der Schwankung, in { $trials } Durchgängen aus { $sessions } Sitzung
       *[other] Innerhalb der Schwankung, in { $trials } Durchgängen aus { $sessions } Sitzungen
    }
learning-head-few =
    { $sessions ->
        [0] Zu wenige Sitzungen, um eine Änderung von Schwankung zu unterscheiden, bei { $trials } Durchgängen
        [one] Zu wenige Sitzungen, um eine Änderung von Schwankung zu unterscheiden, bei { $trials } Durchgängen aus { $sessions } Sitzung
       *[other] Zu wenige Sitzungen, um eine Änderung von Schwankung zu unterscheiden, bei { $trials } Durchgängen aus { $sessions } Sitzungen
    }
# Of a measure that is not judged.
learning-head-number =
    { $sessions ->
        [0] In { $trials } Durchgängen
        [one] In { $trials } Durchgängen aus { $sessions } Sitzung
       *[other] In { $trials } Durchgängen aus { $sessions } Sitzungen
    }

## The sentence behind the head, and those that follow it.

learning-level = { $head }: Dabei lag { $subject } bei etwa { $level }.
learning-change =
    { $how ->
        [fell] { $head }: Dabei sank { $subject }.
       *[rose] { $head }: Dabei stieg { $subject }.
    }
learning-change-by =
    { $how ->
        [fell] { $head }: Dabei sank { $subject } um etwa { $amount }, von { $first } auf { $last }.
       *[rose] { $head }: Dabei stieg { $subject } um etwa { $amount }, von { $first } auf { $last }.
    }
learning-goes-on = Der Messwert ändert sich weiter, in immer kleineren Schritten.
learning-not-level-yet = Der Messwert hat noch keinen festen Wert erreicht.
learning-levels-off = Der Messwert nähert sich etwa { $level }.
learning-caution = Es sind erst { $count } Durchgänge: Das kann sich noch ändern.

## What changed within sessions, and over the pause from one to the next.

learning-sessions-noise = Weder die Änderung innerhalb einer Sitzung noch die über die Pause bis zur nächsten ist mehr als Schwankung (im Mittel von { $sessions } Sitzungen).
learning-within =
    { $how ->
        [noise] Innerhalb einer Sitzung blieb der Messwert in der Schwankung
        [fell] Innerhalb einer Sitzung sank der Messwert um etwa { $amount }
       *[rose] Innerhalb einer Sitzung stieg der Messwert um etwa { $amount }
    }
learning-between =
    { $how ->
        [noise] über die Pause bis zur nächsten blieb er in der Schwankung
        [fell] über die Pause bis zur nächsten sank er um etwa { $amount }
       *[rose] über die Pause bis zur nächsten stieg er um etwa { $amount }
    }
# $within and $between are the two above.
learning-sessions = { $within }, { $between } (im Mittel von { $sessions } Sitzungen).
learning-sessions-perhaps-kept = { $within }, { $between } (im Mittel von { $sessions } Sitzungen): Das Gewonnene blieb erhalten, soweit es sich sagen lässt.
learning-sessions-kept = { $within }, { $between } (im Mittel von { $sessions } Sitzungen): Das Gewonnene blieb erhalten.
learning-sessions-part-kept = { $within }, { $between } (im Mittel von { $sessions } Sitzungen): Etwa { $percent } % des Gewonnenen blieben erhalten.
learning-sessions-lost = { $within }, { $between } (im Mittel von { $sessions } Sitzungen): Vom Gewonnenen blieb nichts erhalten.

## Statistics, in the details.

learning-medians =
    { $how ->
        [fell] Im Median der ersten und der letzten { $edge } von { $trials } Durchgängen sank { $subject } von { $first } auf { $last }.
        [rose] Im Median der ersten und der letzten { $edge } von { $trials } Durchgängen stieg { $subject } von { $first } auf { $last }.
       *[went] Im Median der ersten und der letzten { $edge } von { $trials } Durchgängen lag { $subject } zuerst bei { $first } und zuletzt bei { $last }.
    }
learning-p-small =
    { $sessions ->
        [one] Das letzte Drittel der Durchgänge gegen das erste, gemessen an der eigenen Schwankung dieser Person: p < 0,001; für eine Änderung gilt p < { $level }.
       *[other] Das letzte Drittel der Sitzungen gegen das erste, oder die neueste Sitzung gegen die davor, gemessen an der eigenen Schwankung dieser Person: p < 0,001; für eine Änderung gilt p < { $level }.
    }
learning-p =
    { $sessions ->
        [one] Das letzte Drittel der Durchgänge gegen das erste, gemessen an der eigenen Schwankung dieser Person: p = { $p }; für eine Änderung gilt p < { $level }.
       *[other] Das letzte Drittel der Sitzungen gegen das erste, oder die neueste Sitzung gegen die davor, gemessen an der eigenen Schwankung dieser Person: p = { $p }; für eine Änderung gilt p < { $level }.
    }
learning-slope =
    { $how ->
        [falls] Von Durchgang zu Durchgang sinkt der Messwert im Median um { $step }.
       *[rises] Von Durchgang zu Durchgang steigt der Messwert im Median um { $step }.
    }
learning-form-level = Keine Kurve beschreibt den Messwert besser als eine waagerechte Linie.
learning-form-power = Ein Potenzgesetz beschreibt den Messwert besser als eine Exponentialkurve: zuerst große Schritte, dann immer kleinere.
learning-form-open = Eine Exponentialkurve beschreibt den Messwert am besten. In diesen Durchgängen hat sie noch keinen festen Wert erreicht.
learning-form-constant = Eine Exponentialkurve beschreibt den Messwert am besten. Sie nähert sich { $level }, mit einer Lernkonstante von { $trials } Durchgängen (95 %: { $low } bis { $high }).
learning-form-few = Eine Exponentialkurve beschreibt den Messwert am besten. Sie nähert sich { $level }; wie schnell, lässt sich ab { $least } Durchgängen sagen.
learning-form-fast = Eine Exponentialkurve beschreibt den Messwert am besten. Sie erreicht { $level } schon in den ersten Durchgängen.
# $within and $between are the two below.
learning-statistics = { $within }, und { $between }.
learning-statistics-within =
    { $how ->
        [noise] Im Mittel von { $sessions } Sitzungen änderte sich der Messwert innerhalb einer Sitzung um { $change } (in der Schwankung; 99 %: { $low } bis { $high })
        [fell] Im Mittel von { $sessions } Sitzungen sank der Messwert innerhalb einer Sitzung um { $change } (99 %: { $low } bis { $high })
       *[rose] Im Mittel von { $sessions } Sitzungen stieg der Messwert innerhalb einer Sitzung um { $change } (99 %: { $low } bis { $high })
    }
learning-statistics-between =
    { $how ->
        [noise] von ihren letzten Durchgängen zu den ersten der nächsten änderte er sich um { $change } (in der Schwankung; 99 %: { $low } bis { $high })
        [fell] von ihren letzten Durchgängen zu den ersten der nächsten sank er um { $change } (99 %: { $low } bis { $high })
       *[rose] von ihren letzten Durchgängen zu den ersten der nächsten stieg er um { $change } (99 %: { $low } bis { $high })
    }
