### Names of joints: alone or at the beginning ("joint-..."), and within a sentence ("joint-within-...").

joint-right-shoulder = Right shoulder
joint-left-shoulder = Left shoulder
joint-right-elbow = Right elbow
joint-left-elbow = Left elbow
joint-right-wrist = Right wrist
joint-left-wrist = Left wrist
joint-head = Head
joint-trunk = Trunk
joint-within-right-shoulder = right shoulder
joint-within-left-shoulder = left shoulder
joint-within-right-elbow = right elbow
joint-within-left-elbow = left elbow
joint-within-right-wrist = right wrist
joint-within-left-wrist = left wrist
joint-within-head = head
joint-within-trunk = trunk
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
