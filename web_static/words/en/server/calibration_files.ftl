### Errors in files: a calibration profile, a set of controls, a table of prompts, a prior of other people. They name the
### fields as the file does, and the name of the file may stand before the sentence.

## Profile and controls.

calibration-full-too-low = gesture '{ $gesture }': “{ tune-full }” ({ $full } %) must be at least { $least } %, which is 1 % above “{ tune-from }”: raise it
calibration-gesture-twice = gesture '{ $gesture }' stands there twice
calibration-gesture-joint = gesture '{ $gesture }' reads joint '{ $joint }', which the calibration does not have: use one of { $joints }
# $control is u1+, u1-, u2+, u2- or stop.
calibration-binding = { $control } is bound to gesture '{ $gesture }', which does not exist: use one of { $gestures }
calibration-profile-means = joint '{ $joint }': channels and mean must be of one length
calibration-profile-map = joint '{ $joint }': map says '{ $map }', but the joint has no '{ $map }': add it
calibration-profile-parts = joint '{ $joint }': the { $map } map must have one number per channel in each part
calibration-profile-pca = joint '{ $joint }': the pca map reads no channel
calibration-profile-covariance = joint '{ $joint }': covariance must have { $count } rows of { $count } numbers
calibration-profile-symmetric = joint '{ $joint }': covariance must be symmetric
calibration-profile-variance = joint '{ $joint }': covariance has a variance below 0
calibration-profile-range = low and high must have { $count } numbers, one per channel of the layout
calibration-profile-noise = noise must have { $count } numbers, one per channel of the layout
calibration-profile-channel = joint '{ $joint }' reads a channel that the layout does not have

## Table of prompts.

calibration-prompts-no-joint = { $file }: there is no column 'joint', add it with the name of the joint that moved
# $place is a file and its line.
calibration-prompts-joint = { $place }: there is no joint '{ $joint }' in '{ $layout }', use one of { $names }
calibration-prompts-order = { $place }: the prompt ends at { $end } s, which is not after its start at { $start } s, correct or remove it
calibration-prompts-outside = { $place }: the prompt from { $start } to { $end } s lies outside the recording, which goes from { $first } to { $last } s, correct or remove it

## Prior.

calibration-prior-short = there are { $seconds } s of movement, and the scale of the channels needs { $least } s: record longer
calibration-prior-no-joint = no joint was prompted and has a channel that can be used: prompt it, or check the shirt
calibration-prior-moments = the moments do not fit together: make the entry again with `bodydrive prior add`
calibration-prior-ring = the ring's numbers do not fit together: make the entry again with `bodydrive prior add`
# The next two stand as $where in the three below them.
calibration-prior-entry = the entry of '{ $code }'
calibration-prior-release = the release
calibration-prior-unknown-joint = { $where } names joint '{ $joint }', which '{ $layout }' does not have
calibration-prior-size = { $where } does not have one number for each channel of joint '{ $joint }': make it again
calibration-prior-ring-size = { $where } has { $count } sensors in ring '{ $ring }', and '{ $layout }' has another number
calibration-prior-release-own = a release holds sums and no entries of people: merge it without --own
calibration-prior-two-entries = two of them have different entries for the person '{ $code }': give one another code
calibration-prior-none = there is no prior to merge: name at least one
calibration-prior-layouts = the layouts '{ $first }' and '{ $second }' have other channels, joints or rings: each shirt needs a prior of its own
calibration-prior-no-file = { $file }: there is no such prior, check its name
calibration-prior-unreadable = { $file }: this prior cannot be read ({ $problem }), check it
