### Texts of the share links of a patient, which clinicians make, list and revoke.

shares-title = Share links
shares-lead = A share link shows the records to somebody outside the clinic. It can only be read, names the patient by the code, lasts at most { $days } days, and needs a PIN. The log records each opening. A report, made on Review, is a file: whoever gets it can keep it.
shares-none = There is no link that can be opened.
shares-all = All sessions
shares-session = Session { $number }
shares-state-open = Can be opened
shares-state-closed = Closed: no consent
shares-state-revoked = Revoked
shares-state-over = Expired
shares-state-dead = Closed: five wrong PINs
shares-until = Until { $moment }
shares-openings-none = Not opened yet
shares-openings =
    { $count ->
        [one] Opened once, { $moment }
       *[other] Opened { $count } times, last { $moment }
    }
shares-wrong =
    { $count ->
        [one] { $count } wrong PIN
       *[other] { $count } wrong PINs
    }
shares-made = Made { $moment } by { $person }
shares-ended =
    { $count ->
        [one] { $count } link that has ended
       *[other] { $count } links that have ended
    }
shares-revoke = Revoke
shares-revoke-label = Revoke the link: { $what }, made { $moment }
shares-revoked = The link was revoked: it shows nothing more.
shares-what = What it shows
shares-for = How long
shares-days =
    { $count ->
        [one] { $count } day
       *[other] { $count } days
    }
shares-make = Make the link
shares-consent = A share link needs the patient's consent to sharing outside: ask, and enter it above.
shares-new = The link and its PIN, shown this once: { $what }
shares-new-lead = Send the link. Tell the PIN in another way, such as by telephone: whoever has both reads the records of { $code }.
shares-pin = PIN
shares-done = Done
