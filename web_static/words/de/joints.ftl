### Names of joints: alone or at the beginning ("joint-..."), and within a sentence ("joint-within-...").

joint-right-shoulder = Rechte Schulter
joint-left-shoulder = Linke Schulter
joint-right-elbow = Rechter Ellbogen
joint-left-elbow = Linker Ellbogen
joint-right-wrist = Rechtes Handgelenk
joint-left-wrist = Linkes Handgelenk
joint-within-right-shoulder = rechte Schulter
joint-within-left-shoulder = linke Schulter
joint-within-right-elbow = rechter Ellbogen
joint-within-left-elbow = linker Ellbogen
joint-within-right-wrist = rechtes Handgelenk
joint-within-left-wrist = linkes Handgelenk
# A sensor: "Right elbow 3".
joint-sensor = { $joint } { $number }
