### Texts about studies with simulated people: refusals, tables, sentences on the results, and labels of the figures.

## Refusals

study-folder-is-file = { $folder } is a file and not a folder: name another place
# --overwrite: an option of the command, not translated.
study-folder-not-empty = { $folder } is not empty: name another folder, or replace it with --overwrite
study-no-prior = no prior ships for the simulated shirt: make one with `make shipped FILE=prior`

## Several people, each with their own seed (a number from which a simulated person is made)

# measure: the name of a measure, as in “Area off the path”. first, last: its median with its unit, or study-none-reached.
study-over-seeds = { $measure }, median: { $first } in trial 1, { $last } in trial { $trials }; of { $seeds } people it fell in { $falls }, rose in { $rises } and stayed within noise in { $no_trend }; the largest step is among the first { $early } trials in { $early_steps }.
study-over-seeds-step = { $measure }, median: { $first } in trial 1, { $last } in trial { $trials }; of { $seeds } people it fell in { $falls }, rose in { $rises } and stayed within noise in { $no_trend }; the largest step is among the first { $early } trials in { $early_steps }, the median's from trial { $step } on.
study-none-reached = nobody reached the goal
study-left-out =
    { $missed ->
        [one] { $missed } of { $count } trials did not reach the goal in time and is left out of these figures.
       *[other] { $missed } of { $count } trials did not reach the goal in time and are left out of these figures.
    }

## A fixed and an adapted map

study-area-title = Area off the path, m²
# Titles of columns. fixed, adapted: medians with the fixed and the adapted map; reached: how many trials reached the goal
# with each; both drove: how many people always reached the goal with both, relative there: the difference for these;
# 95 %: an interval.
study-column-session = session
study-column-seed = seed
study-column-fixed = fixed
study-column-adapted = adapted
study-column-reached-fixed = reached, fixed
study-column-reached-adapted = reached, adapted
study-column-both-drove = both drove
study-column-relative = relative
study-column-relative-there = relative there
study-column-interval = 95 %
study-session = session { $session }
# The bounds of an interval, in percent.
study-interval = { $low } to { $high }
# relative: a difference in percent; interval: a text study-interval, or a dash.
study-later-sessions = All trials from session 2 on: mean { $fixed } m² fixed, { $adapted } m² adapted: { $relative } (95 % { $interval }); reached { $reached_fixed } % and { $reached_adapted } %.
study-last-session = Median over { $seeds } seeds in the last session: { $relative } (95 % { $interval }). Proposals for a person: median { $median }, most { $most }. Steps applied: { $steps }; largest felt change { $felt_change } %, largest turn { $turn } degrees, sign flips { $flips }.

## The two-minute test

study-test-title = Two-minute test, medians over people
# Titles of columns. first entry: seconds until the target is entered first; dial-in: from then until it is held.
study-test-targets = targets/min
study-test-missed = missed
study-test-first-entry = first entry, s
study-test-dial-in = dial-in, s
study-test-straightness = straightness
study-test-throughput = throughput, bit/s (10 to 90 %)
study-test-area = area off the path, m²
study-test-reached = reached
study-spread = ({ $low } to { $high })
# between, within: a number from −1 to 1, or a dash.
study-rank-correlation = Rank correlation of throughput with the area off the path in the trials of the same session: between people { $between }, within people { $within }.

## Figures. Dist is the symbol of the distance driven; letter: of a panel of the figure.

study-panel-trial = ({ $letter }) Trial { $number }
study-panel-all = ({ $letter }) All { $count } trials
study-panel-people = ({ $letter }) Trial { $number }, { $count } people
study-panel-dist = ({ $letter }) Dist: distance driven
study-panel-area = ({ $letter }) { $symbol }: area between trajectory and path
study-prescribed-path = prescribed path, { $length } m (● start, ■ goal)
study-trajectory = trajectory
study-path-length = length of the path
study-one-person = one person
study-middle-half = middle half
study-median = median of { $count }
study-band = 95 % band
study-learning-curve = learning curve
study-trial = trial
