### Names of joints: alone or at the beginning ("joint-..."), and within a sentence ("joint-within-...").

joint-right-shoulder = Rechte Schulter
joint-left-shoulder = Linke Schulter
joint-right-elbow = Rechter Ellbogen
joint-left-elbow = Linker Ellbogen
joint-right-wrist = Rechtes Handgelenk
joint-left-wrist = Linkes Handgelenk
joint-right-fingers = Rechte Finger
joint-left-fingers = Linke Finger
joint-trunk = Rumpf
joint-head = Kopf
joint-right-hip = Rechte Hüfte
joint-left-hip = Linke Hüfte
joint-right-knee = Rechtes Knie
joint-left-knee = Linkes Knie
joint-right-ankle = Rechtes Sprunggelenk
joint-left-ankle = Linkes Sprunggelenk
joint-within-right-shoulder = rechte Schulter
joint-within-left-shoulder = linke Schulter
joint-within-right-elbow = rechter Ellbogen
joint-within-left-elbow = linker Ellbogen
joint-within-right-wrist = rechtes Handgelenk
joint-within-left-wrist = linkes Handgelenk
joint-within-right-fingers = rechte Finger
joint-within-left-fingers = linke Finger
joint-within-trunk = Rumpf
joint-within-head = Kopf
joint-within-right-hip = rechte Hüfte
joint-within-left-hip = linke Hüfte
joint-within-right-knee = rechtes Knie
joint-within-left-knee = linkes Knie
joint-within-right-ankle = rechtes Sprunggelenk
joint-within-left-ankle = linkes Sprunggelenk
# A sensor: "Right elbow 3".
joint-sensor = { $joint } { $number }
# What a channel of a camera measures of a joint: "Left shoulder: raised".
joint-channel = { $joint }: { $what }
channel-elevation = gehoben
channel-forward = nach vorn
channel-out = nach außen
channel-bend = gebeugt
channel-lift = Oberarm gehoben
channel-height = Höhe
channel-yaw = gedreht
channel-pitch = genickt
channel-roll = geneigt
channel-side = zur Seite
