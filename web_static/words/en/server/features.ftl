### Refusals of the server: comments on trials, consents, the two-minute test, layouts; and which sensors move together.

# $number names the comment, as in the address of the page.
comments-missing = There is no comment { $number }: choose one of the trial's comments.
comments-most = A trial has at most { $count } comments: revise one of yours.
comments-not-author = Only its author changes a comment: write one of your own.
comments-withdrawn-already = This comment was withdrawn: write a new one.
comments-trial-running = This trial is still running: look at it when it has ended.
consents-future = A consent is given today or was given before: choose a day that is not in the future.
tests-missing = There is no two-minute test { $number }: choose one of the list.
tests-still-running = The two-minute test is still running: end it first, then ask how demanding it was.
tests-stop-in-force = A stop is in force: take it back first, then start the two-minute test.
# $number names the layout, as in the address of the page.
layouts-missing = There is no layout { $number }: choose one of the list.
layouts-most = A clinic has at most { $count } layouts: delete one that is not needed.
layouts-name-taken = There is a layout “{ $name }” already: give this one another name.
layouts-saved-meanwhile = “{ $name }” was saved on another screen meanwhile: open it again, and make the change there.
layouts-in-use = The shirt in use has the layout “{ $name }”: use another layout first, then delete this one.
# $count: 2 or more.
layouts-proposal-groups = { $count } groups of sensors move together.
layouts-proposal-one = All sensors that moved, moved together: they make one joint.
layouts-proposal-unclear = No clear groups: move one joint after the other, each of them several times, then propose again.
layouts-proposal-still = Fewer than two sensors moved: move every joint, then propose again.
layouts-proposal-short = Fewer than { $least } seconds of signals are too few to see which sensors move together: use a longer file, or let the shirt send for longer, then propose again.
