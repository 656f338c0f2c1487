### Learning curves: what became of a measure over a person's trials, and the statistics behind it. $subject is a measure
### within a sentence, such as "the area off the path"; "it" is the measure.

learning-few = Not enough trials for a learning curve: { $count } of at least { $least } that reached the goal.

## The head of a sentence, before a colon. $sessions is 0 where it is not known in how many sessions the trials were driven.

learning-head-better =
    { $sessions ->
        [0] Better than noise over { $trials } trials
        [one] Better than noise over { $trials } trials in { $sessions } session
       *[other] Better than noise over { $trials } trials in { $sessions } sessions
    }
learning-head-worse =
    { $sessions ->
        [0] Worse than noise over { $trials } trials
        [one] Worse than noise over { $trials } trials in { $sessions } session
       *[other] Worse than noise over { $trials } trials in { $sessions } sessions
    }
learning-head-within =
    { $sessions ->
        [0] Within noise over { $trials } trials
        [one] Within noise over { $trials } trials in { $sessions } session
       *[other] Within noise over { $trials } trials in { $sessions } sessions
    }
learning-head-few =
    { $sessions ->
        [0] Too few sessions to tell a change from noise, over { $trials } trials
        [one] Too few sessions to tell a change from noise, over { $trials } trials in { $sessions } session
       *[other] Too few sessions to tell a change from noise, over { $trials } trials in { $sessions } sessions
    }
# Of a measure that is not judged.
learning-head-number =
    { $sessions ->
        [0] Over { $trials } trials
        [one] Over { $trials } trials in { $sessions } session
       *[other] Over { $trials } trials in { $sessions } sessions
    }

## The sentence behind the head, and those that follow it.

learning-level = { $head }: { $subject } was about { $level }.
learning-change =
    { $how ->
        [fell] { $head }: { $subject } fell.
       *[rose] { $head }: { $subject } rose.
    }
learning-change-by =
    { $how ->
        [fell] { $head }: { $subject } fell by about { $amount }, from { $first } to { $last }.
       *[rose] { $head }: { $subject } rose by about { $amount }, from { $first } to { $last }.
    }
learning-goes-on = It goes on changing, in ever smaller steps.
learning-not-level-yet = It has not levelled off yet.
learning-levels-off = It levels off at about { $level }.
learning-caution = { $count } trials are few: this may yet change.

## What changed within sessions, and over the pause from one to the next.

learning-sessions-noise = Neither the change within a session nor the one over the pause to the next is more than noise (on average of { $sessions } sessions).
learning-within =
    { $how ->
        [noise] Within a session it stayed within noise
        [fell] Within a session it fell by about { $amount }
       *[rose] Within a session it rose by about { $amount }
    }
learning-between =
    { $how ->
        [noise] over the pause to the next one it stayed within noise
        [fell] over the pause to the next one it fell by about { $amount }
       *[rose] over the pause to the next one it rose by about { $amount }
    }
# $within and $between are the two above.
learning-sessions = { $within }, { $between } (on average of { $sessions } sessions).
learning-sessions-perhaps-kept = { $within }, { $between } (on average of { $sessions } sessions): what was gained was kept, as far as can be told.
learning-sessions-kept = { $within }, { $between } (on average of { $sessions } sessions): what was gained was kept.
learning-sessions-part-kept = { $within }, { $between } (on average of { $sessions } sessions): about { $percent } % of what was gained was kept.
learning-sessions-lost = { $within }, { $between } (on average of { $sessions } sessions): nothing of what was gained was kept.

## Statistics, in the details.

learning-medians =
    { $how ->
        [fell] In the medians of the first and the last { $edge } of { $trials } trials, { $subject } fell from { $first } to { $last }.
        [rose] In the medians of the first and the last { $edge } of { $trials } trials, { $subject } rose from { $first } to { $last }.
       *[went] In the medians of the first and the last { $edge } of { $trials } trials, { $subject } went from { $first } to { $last }.
    }
learning-p-small =
    { $sessions ->
        [one] The last third of the trials against the first, beside this person's own noise: p < 0.001; a change has p < { $level }.
       *[other] The last third of the sessions against the first, or the newest session against those before, beside this person's own noise: p < 0.001; a change has p < { $level }.
    }
learning-p =
    { $sessions ->
        [one] The last third of the trials against the first, beside this person's own noise: p = { $p }; a change has p < { $level }.
       *[other] The last third of the sessions against the first, or the newest session against those before, beside this person's own noise: p = { $p }; a change has p < { $level }.
    }
learning-slope =
    { $how ->
        [falls] From trial to trial it falls by { $step } in the median.
       *[rises] From trial to trial it rises by { $step } in the median.
    }
learning-form-level = No curve describes it better than a level line.
learning-form-power = A power law describes it better than an exponential: large steps at first, then ever smaller ones.
learning-form-open = An exponential describes it best, and it has not levelled off within these trials.
learning-form-constant = An exponential describes it best, levelling off at { $level }, with a learning constant of { $trials } trials (95 %: { $low } to { $high }).
learning-form-few = An exponential describes it best, levelling off at { $level }; how fast is told from { $least } trials on.
learning-form-fast = An exponential describes it best, levelling off at { $level } within the first trials.
# $within and $between are the two below.
learning-statistics = { $within }, and { $between }.
learning-statistics-within =
    { $how ->
        [noise] In the mean of { $sessions } sessions it changed by { $change } (within noise; 99 %: { $low } to { $high }) within a session
        [fell] In the mean of { $sessions } sessions it fell by { $change } (99 %: { $low } to { $high }) within a session
       *[rose] In the mean of { $sessions } sessions it rose by { $change } (99 %: { $low } to { $high }) within a session
    }
learning-statistics-between =
    { $how ->
        [noise] changed by { $change } (within noise; 99 %: { $low } to { $high }) from its last trials to the first of the next
        [fell] fell by { $change } (99 %: { $low } to { $high }) from its last trials to the first of the next
       *[rose] rose by { $change } (99 %: { $low } to { $high }) from its last trials to the first of the next
    }
