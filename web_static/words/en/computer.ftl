### Texts of the owner's page "This computer". What was found comes in words from the server (app/host/machine_check.py).

rail-computer = This computer
computer-lead = Whether this computer, and the screens that are open now, are good enough for driving.
computer-settings-go = Measure this computer
computer-owner = Only an owner can measure this computer: ask an owner.
computer-measured = This measures whether the control loop runs on time, which rights the system gives it, the free disk space, the clock and the ports, and how many pictures a second each open screen draws. First open the screens that you want to measure, if possible with the 3D view.
computer-go = Measure for { $seconds } s
computer-again = Measure again
computer-measuring = Measuring. { $left } s to go.
computer-counting = Measuring. The result comes in a moment.
computer-progress = How much of the measuring is done
computer-machine = This computer
computer-screens = Screens that are open now
computer-screens-bad =
    { $count ->
        [one] { $count } screen that is open now is not good enough.
       *[other] { $count } screens that are open now are not good enough.
    }
computer-no-screens = No screen is open.
computer-verdict-good = Good
computer-verdict-attention = Could be better
computer-verdict-bad = Not good enough
