### Refusals of the server: comments on trials, consents, the two-minute test.

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
