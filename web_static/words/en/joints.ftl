### Names of joints: alone or at the beginning ("joint-..."), and within a sentence ("joint-within-...").

joint-right-shoulder = Right shoulder
joint-left-shoulder = Left shoulder
joint-right-elbow = Right elbow
joint-left-elbow = Left elbow
joint-right-wrist = Right wrist
joint-left-wrist = Left wrist
joint-right-fingers = Right fingers
joint-left-fingers = Left fingers
joint-trunk = Trunk
joint-head = Head
joint-right-hip = Right hip
joint-left-hip = Left hip
joint-right-knee = Right knee
joint-left-knee = Left knee
joint-right-ankle = Right ankle
joint-left-ankle = Left ankle
joint-within-right-shoulder = right shoulder
joint-within-left-shoulder = left shoulder
joint-within-right-elbow = right elbow
joint-within-left-elbow = left elbow
joint-within-right-wrist = right wrist
joint-within-left-wrist = left wrist
joint-within-right-fingers = right fingers
joint-within-left-fingers = left fingers
joint-within-trunk = trunk
joint-within-head = head
joint-within-right-hip = right hip
joint-within-left-hip = left hip
joint-within-right-knee = right knee
joint-within-left-knee = left knee
joint-within-right-ankle = right ankle
joint-within-left-ankle = left ankle
# A sensor: "Right elbow 3".
joint-sensor = { $joint } { $number }
# What a channel of a camera measures of a joint: "Left shoulder: raised".
joint-channel = { $joint }: { $what }
channel-elevation = raised
channel-forward = forward
channel-out = outwards
channel-bend = bent
channel-lift = upper arm raised
channel-height = height
channel-yaw = turned
channel-pitch = nodding
channel-roll = tilted
channel-side = to the side
