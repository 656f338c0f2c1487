### Texts of the page that says which patients to look at.

rail-attention = Who to look at
attention-lead = Patients who need attention come first, each with the reason. Tap a reason to see it.
attention-none = Nobody needs attention now.
attention-nobody = There is no patient that you may see.
attention-others = Nothing to look at
attention-pending =
    { $count ->
        [one] It is still being worked out whether { $count } patient has become worse.
       *[other] It is still being worked out whether any of { $count } patients has become worse.
    }
attention-deterioration =
    { $count ->
        [one] { $count } measure has become worse, beyond noise
       *[other] { $count } measures have become worse, beyond noise
    }
attention-drive =
    { $count ->
        [one] { $count } drive of a real chair was stopped by a fault
       *[other] { $count } drives of a real chair were stopped by a fault
    }
attention-halted =
    { $count ->
        [one] { $count } trial was stopped by a fault
       *[other] { $count } trials were stopped by a fault
    }
attention-comment =
    { $count ->
        [one] { $count } unread comment
       *[other] { $count } unread comments
    }
attention-unsigned =
    { $count ->
        [one] { $count } session not signed off
       *[other] { $count } sessions not signed off
    }
attention-absent =
    { $count ->
        [one] No session for { $count } day
       *[other] No session for { $count } days
    }
attention-open = Who to look at
