### Grades of a calibration: how well the movement of one joint can be used, and what to do. "It" is the joint.

# As in "Signal: strong".
grade-signal-strong = strong
grade-signal-fair = fair
grade-signal-weak = weak
# As in "Repeats well".
grade-repeats-well = well
grade-repeats-fairly = fairly
grade-repeats-poorly = poorly
# $signal is one of the three words above.
grade-good = Clear main movement: { $percent } %. Signal: { $signal }.
grade-good-repeats = Repeats { $how }.
grade-unprompted = It was not prompted, so which way it counts is not known: prompt it.
grade-directed = It was not prompted: which way its movement counts is known from other people.
grade-no-movement = The movement does not rise above the noise: repeat it larger and quicker.
# $rating is "repeat" where the movement has to be repeated, "usable" where it need not.
grade-signal =
    { $rating ->
        [repeat] It moves only { $ratio } times above the noise: rest quite still, then repeat it larger.
       *[usable] It moves only { $ratio } times above the noise: a larger or quicker movement would be safer.
    }
grade-clear =
    { $rating ->
        [repeat] The main movement is clear to { $percent } % only, below the usual 80 %: repeat the free movement with this joint moved one way only.
       *[usable] The main movement is clear to { $percent } % only, below the usual 80 %: keep to one movement of it.
    }
grade-no-rest = No rest was recorded: the noise is that of the stillest half second.
grade-agreement = The prompted movements point both ways ({ $percent } % of them one way): repeat them in time with the cue.
grade-small-prompts = The prompted movements go through only { $percent } % of the free one's span: repeat them larger, and in time with the cue.
grade-uneven =
    { $rating ->
        [repeat] The repetitions differ by { $percent } %: repeat them evenly.
       *[usable] The repetitions differ by { $percent } %: more even ones would drive more evenly.
    }
grade-angle = The prompted movement is { $degrees } degrees away from the free one: the prompted direction is used, check it in “{ try-title }”.
grade-cross-talk = { $joint } answers too, with { $percent } % of its own activation: move this joint alone, or do not bind both.
grade-span-of-prompts = It moved little this way in the free movement: the span is that of the prompts.
grade-one-sensor = Only one of its sensors is left: check the others on the { rail-shirt } page.
grade-sensors-out = Sensors left out: { $count } of { $every }.
