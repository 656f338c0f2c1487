### Names of joints: alone or at the beginning ("joint-..."), and within a sentence ("joint-within-...").

joint-right-shoulder = Right shoulder
joint-left-shoulder = Left shoulder
joint-right-elbow = Right elbow
joint-left-elbow = Left elbow
joint-right-wrist = Right wrist
joint-left-wrist = Left wrist
joint-within-right-shoulder = right shoulder
joint-within-left-shoulder = left shoulder
joint-within-right-elbow = right elbow
joint-within-left-elbow = left elbow
joint-within-right-wrist = right wrist
joint-within-left-wrist = left wrist
# A sensor: "Right elbow 3".
joint-sensor = { $joint } { $number }
