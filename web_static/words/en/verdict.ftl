### Texts of the verdicts on changes.

verdict-range = { $low } to { $high }
verdict-title = Better, or noise?
verdict-column = Verdict
verdict-noise = Within noise
verdict-familiarisation = This is one of the first three trials of this task. They are for getting used to the task and are not compared.
verdict-means = Noise is how much this person's own trials of this task differ without a change. A verdict needs five trials of the task in all. A verdict between two sessions also needs earlier sessions, or the trials of three other people of the clinic in this task.
verdict-chance = Only the three leading measures of a task, and how often the goal was reached, have a verdict. Where nothing changed, about one page in twenty says better or worse by chance.
verdict-missed = Between sessions, a trial that missed the goal counts at most as much as the worst tenth of the earlier trials that reached it.
verdict-unpublished = No minimal detectable change has been published for these measures of wheelchair driving.
verdict-sessions =
    Session { $later } ({ $laterDay }, { $laterTrials ->
        [one] { $laterTrials } trial
       *[other] { $laterTrials } trials
    }) against session { $earlier } ({ $earlierDay }, { $earlierTrials ->
        [one] { $earlierTrials } trial
       *[other] { $earlierTrials } trials
    })
verdict-session = Session { $number }
verdict-all = All measures
verdict-counts =
    { $count ->
        [one] { $count } of the { $all } trials of this task can be compared: the first three are for getting used to it.
       *[other] { $count } of the { $all } trials of this task can be compared: the first three are for getting used to it.
    }
verdict-counts-none = No trial of this task can be compared yet ({ $all } driven): the first three are for getting used to it.
verdict-needed = A verdict needs { $count } trials that can be compared, from two sessions together: drive this task again.
verdict-few =
    { $count ->
        [one] { $count } trial can be compared so far, { $needed } are needed.
       *[other] { $count } trials can be compared so far, { $needed } are needed.
    }
verdict-few-sessions = { $count } trials can be compared, which is enough. To compare sessions, one more session is needed, or the trials of three other people of the clinic in this task.
verdict-compare = Compare sessions
