### Calibration: its steps, what is wrong with a sensor or a recording, why a joint has no map, and how maps are proposed
### and changed.

## Steps.

calibration-rest = Rest
calibration-rest-instruction = Sit comfortably and let your arms hang. Do not move for three seconds.
calibration-free = Move freely
calibration-free-instruction = Move your arms and shoulders any way you like for ten seconds, as far as is comfortable.
calibration-free-short-instruction = For ten seconds, turn your head to one side, lean to one side and push each shoulder forward, again and again, in any order, as far as is comfortable.
# Below an instruction to move one joint.
calibration-prompt-instruction = Follow the beat { $count } times: move when the cue says so, then come back slowly and rest.
calibration-move-elbow =
    { $side ->
        [left] Bend your left elbow
       *[right] Bend your right elbow
    }
calibration-move-shoulder =
    { $side ->
        [left] Push your left shoulder forward
       *[right] Push your right shoulder forward
    }
calibration-move-wrist =
    { $side ->
        [left] Bend your left wrist
       *[right] Bend your right wrist
    }
calibration-move-head = Turn your head to one side
calibration-move-trunk = Lean to one side
calibration-move = Move: { $joint }

## What is wrong with a sensor. The name of the sensor stands before it, as in "Channel e3 is left out: gives no numbers."

calibration-channel-no-numbers = gives no numbers
calibration-channel-nan =
    { $count ->
        [one] { $count } of { $samples } samples is not a number
       *[other] { $count } of { $samples } samples are not numbers
    }
calibration-channel-railed = reaches { $percent } % of its range
calibration-channel-near = comes near the end of its range ({ $percent } %)
calibration-channel-clipped =
    { $end ->
        [upper] sits at the upper end of its range for { $percent } % of the time
       *[lower] sits at the lower end of its range for { $percent } % of the time
    }
calibration-channel-dead = never changes: it is dead or not connected
calibration-channel-still = stands still for { $percent } % of the time while its neighbours move
calibration-channel-noisy = is mostly noise ({ $percent } % of its movement)
calibration-channel-gap = misses { $seconds } s at once, and at most { $most } s are bridged
calibration-channel-missing = misses { $percent } % of its samples, and at most { $most } % are bridged
calibration-channel-unused = marked as unused

## Recordings that cannot be used. The name of a file may stand before the sentence.

# $what is the name of a joint where it is neither free movement nor rest.
calibration-recording-channels =
    { $what ->
        [free] the recording of free movement does not have the { $count } channels of '{ $layout }'
        [rest] the recording of rest does not have the { $count } channels of '{ $layout }'
       *[other] the recording of { $what } does not have the { $count } channels of '{ $layout }'
    }
calibration-recording-short =
    { $what ->
        [free] the free movement lasts { $lasts } s, which is too short for a calibration: record at least { $least } s (10 s of free movement and 3 s of rest are usual)
       *[rest] the rest lasts { $lasts } s, which is too short for a calibration: record at least { $least } s (10 s of free movement and 3 s of rest are usual)
    }
calibration-unknown-name =
    { $what ->
        [joint] there is no joint '{ $name }' in '{ $layout }': use one of { $names }
       *[channel] there is no channel '{ $name }' in '{ $layout }': use one of { $names }
    }
calibration-no-joint = no joint of '{ $layout }' has a sensor that can be used: check that the shirt is connected and that somebody moved in it
calibration-no-sensor = None of its sensors can be used: check them on the { rail-shirt } page, then repeat the calibration.

## Where a map comes from.

calibration-source-both = from other people and own movement
calibration-source-people = from other people
calibration-source-prompts = from own prompts
calibration-source-standard = standard

## Why there is no map learnt from the cues.

calibration-guided-unprompted = Nothing is learnt from cues, because the movement of this joint was never prompted: prompt it at least { $least } times.
calibration-guided-few =
    { $count ->
        [one] Nothing is learnt from { $count } prompted repetition: prompt at least { $least }, so that it can be judged on one that it has not seen.
       *[other] Nothing is learnt from { $count } prompted repetitions: prompt at least { $least }, so that it can be judged on one that it has not seen.
    }
calibration-guided-no-rest = Nothing is learnt from cues, because this joint is nowhere at rest for { $seconds } s in all: record a rest, or leave pauses between the prompted movements.
calibration-guided-small = Nothing is learnt from cues, because the signals are too small: give them in a smaller unit.
calibration-guided-unlike = Nothing is learnt from cues: the repetitions have nothing in common, so repeat the prompts.

## Maps from other people (a prior).

calibration-prior-few =
    { $count ->
        [one] Other people's movements say nothing yet: { $count } of them is known for this joint, and { $needed } are needed.
       *[other] Other people's movements say nothing yet: { $count } of them are known for this joint, and { $needed } are needed.
    }
calibration-prior-unlike = Other people's movements have nothing in common with each other: add more people.
calibration-prior-small = The signals are too small: give them in a smaller unit.
calibration-prior-still = None of the sensors that other people are known for moves on this person: move freely for ten seconds.
calibration-not-confirmed = Other people taught the movement of { $joints }, and this person's own has not confirmed it: repeat each once on the { rail-calibrate } page, and practise again.
# Why a prior may not leave the clinic: this one and the next.
calibration-prior-few-new =
    { $count ->
        [one] there is { $count } person in all, and fewer than { $least } people are in no release yet: use the earlier release, and make another one when at least { $least } people have been added, so that nobody can be found by subtracting one from the other
       *[other] there are { $count } people in all, of whom fewer than { $least } are in no release yet: use the earlier release, and make another one when at least { $least } people have been added, so that nobody can be found by subtracting one from the other
    }
calibration-prior-few-released =
    { $count ->
        [one] there is { $count } person in all, and only sums over at least { $least } people may leave a clinic: add more people
       *[other] there are { $count } people in all, and only sums over at least { $least } people may leave a clinic: add more people
    }

## The earlier calibration, fitted to how the shirt sits today. $joint is as in "left elbow".

calibration-fit-rate = The shirt sends at another rate than it was calibrated at: calibrate again.
calibration-fit-mirrored = At the { $joint } the shirt is inside out or on the other side since this was calibrated: put it on as then, and repeat the free movement. Or go on with the movements that follow: they make a new calibration.
calibration-fit-turned = At the { $joint } the shirt is turned by { $places } of { $sensors } sensors since this was calibrated: turn it back, and repeat the free movement. Or go on with the movements that follow: they make a new calibration.

## A change of the calibration that is proposed after trials. $applied and $refused are lists of joints.

calibration-proposal =
    { $trials ->
        [one] After the last trial, { $applied } would change.
       *[other] After the last { $trials } trials, { $applied } would change.
    }
calibration-proposal-some =
    { $trials ->
        [one] After the last trial, { $applied } would change; { $refused } may not.
       *[other] After the last { $trials } trials, { $applied } would change; { $refused } may not.
    }
calibration-proposal-refused =
    { $trials ->
        [one] After the last trial, nothing changes: what { $refused } would need may not be done.
       *[other] After the last { $trials } trials, nothing changes: what { $refused } would need may not be done.
    }
calibration-proposal-none =
    { $trials ->
        [one] After the last trial, the calibration fits as well as before, and stays as it is.
       *[other] After the last { $trials } trials, the calibration fits as well as before, and stays as it is.
    }
calibration-proposal-no-trial = No trial was driven yet.

## Why the calibration of one joint changes, and how; or why it does not. "It" is the joint.

calibration-loss-noise = Its noise at rest has come near to where it counts, so it may act by itself.
calibration-loss-missed = { $percent } % of the time of its movements does not count, though its noise at rest is low.
calibration-loss-weaker = Its movements have become weaker by { $percent } % since the first trials.
calibration-loss-stronger = Its movements have become stronger by { $percent } % since the first trials.
calibration-loss-direction = { $percent } % of its movement goes in another direction than the one that drives.
calibration-loss-silent = A sensor lay outside its range for { $percent } % of the last trial, and nothing counted then.
calibration-change-no-trial = No trial was driven since the calibration last changed.
calibration-change-none = The calibration fits it as well as before.
calibration-change-sensor = Sensor { $sensor } is dead or at the end of its range: check the shirt, then calibrate again.
calibration-change-felt = The patient would feel a change of { $percent } %, and from { $limit } % on it is refused: calibrate this joint again.
calibration-change-at-end = It cannot follow any further: calibrate this joint again.
calibration-change-unclear = Its main movement is clear to only { $percent } %, less than { $least } %.
calibration-change-away = It would be { $degrees } degrees away from the calibration: calibrate this joint again.
calibration-change-cross-talk = It would answer more to other joints ({ $before } % before, { $after } % after).
calibration-change-range = The range in which its sensors are believed follows the shirt.
calibration-change-turned = Turned by { $degrees } degrees.
calibration-change-turned-part = Turned by { $degrees } degrees of the { $proposed } that its movements ask for.
calibration-change-from = { tune-from } { $after } % / s instead of { $before } % / s.
calibration-change-full = { tune-full } { $after } % / s instead of { $before } % / s.
# A sentence that says why follows.
calibration-change-unturned = The direction stays.

## The suggested movements to drive with.

calibration-suggested = Suggested: { $gestures }.
# In the list above: a joint whose movement back is the gesture.
calibration-gesture-back = { $joint } going back
calibration-suggested-one =
    It has { $signal ->
        [strong] a strong signal
        [fair] a fair signal
       *[weak] a weak signal
    }.
calibration-suggested-unprompted =
    The weakest of these movements has { $signal ->
        [strong] a strong signal
        [fair] a fair signal
       *[weak] a weak signal
    }; nothing was prompted, so it is not known what moves along.
calibration-suggested-several =
    The weakest of these movements has { $signal ->
        [strong] a strong signal
        [fair] a fair signal
       *[weak] a weak signal
    }; on average { $percent } % of another's activation appears while one moves.
calibration-suggested-without = { $joint } is left out because of { $partner }: up to { $percent } % of the activation of one appears while the other moves.
calibration-suggested-hits = At least { $hits } of 100 movements should be answered.
calibration-suggested-false = At rest, { $rate } false activations a minute are expected of all of them together; { $seconds } s of rest prove only fewer than { $bound } of each (95 %).
calibration-suggested-hardly-false = At rest, fewer than { $rate } false activations a minute are expected of all of them together; { $seconds } s of rest prove only fewer than { $bound } of each (95 %).
calibration-recordings-gone = The recordings of this calibration are not here, so only the movements there are ranked, not those back, by the calibration's own numbers: calibrate again to see all.
