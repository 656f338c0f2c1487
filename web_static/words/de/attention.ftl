### Texte der Seite, die zeigt, bei welchen Patienten etwas anzusehen ist.

rail-attention = Auffälligkeiten
attention-lead = Patienten mit Auffälligkeiten stehen oben, jeweils mit dem Grund. Tippen Sie auf einen Grund, um ihn anzusehen.
attention-none = Zurzeit gibt es keine Auffälligkeiten.
attention-nobody = Es gibt keinen Patienten, den Sie sehen dürfen.
attention-others = Ohne Auffälligkeiten
attention-pending =
    { $count ->
        [one] Für { $count } Patienten wird noch berechnet, ob sich etwas verschlechtert hat.
       *[other] Für { $count } Patienten wird noch berechnet, ob sich etwas verschlechtert hat.
    }
attention-deterioration =
    { $count ->
        [one] { $count } Messwert schlechter, über die Schwankung hinaus
       *[other] { $count } Messwerte schlechter, über die Schwankung hinaus
    }
attention-drive =
    { $count ->
        [one] { $count } Fahrt mit einem echten Rollstuhl durch eine Störung gestoppt
       *[other] { $count } Fahrten mit einem echten Rollstuhl durch eine Störung gestoppt
    }
attention-halted =
    { $count ->
        [one] { $count } Durchgang durch eine Störung gestoppt
       *[other] { $count } Durchgänge durch eine Störung gestoppt
    }
attention-comment =
    { $count ->
        [one] { $count } ungelesener Kommentar
       *[other] { $count } ungelesene Kommentare
    }
attention-unsigned =
    { $count ->
        [one] { $count } Sitzung nicht abgezeichnet
       *[other] { $count } Sitzungen nicht abgezeichnet
    }
attention-absent =
    { $count ->
        [one] Seit { $count } Tag keine Sitzung
       *[other] Seit { $count } Tagen keine Sitzung
    }
attention-open = Auffälligkeiten
