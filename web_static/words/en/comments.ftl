### Texts of comments on moments of a trial.

comments-title = Comments
comments-none = Nobody has commented on this trial.
comments-lost = The moments cannot be shown, because there is no replay.
comments-go = Go to { $t } s, the comment of { $person }
comments-at = { $t } s
comments-new = New
comments-write = Comment on this moment
comments-text = Comment at { $t } s
comments-hint = Everybody who may see this patient can read it, also by a share link.
comments-add = Add the comment
comments-added = The comment was added.
comments-change = Revise or withdraw
comments-change-label = Revise or withdraw your comment at { $t } s
comments-save = Save the revision
comments-revised = The comment was revised.
comments-withdraw = Withdraw
comments-withdrawn = The comment was withdrawn.
comments-by = { $person }, { $moment }
comments-by-revised = { $person }, revised { $moment }
comments-history =
    { $count ->
        [one] { $count } earlier text
       *[other] { $count } earlier texts
    }
comments-unread =
    { $count ->
        [one] { $count } unread comment
       *[other] { $count } unread comments
    }
