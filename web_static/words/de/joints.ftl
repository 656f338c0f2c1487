### Names of joints: alone or at the beginning ("joint-..."), and within a sentence ("joint-within-...").

joint-right-shoulder = Rechte Schulter
joint-left-shoulder = Linke Schulter
joint-right-elbow = Rechter Ellbogen
joint-left-elbow = Linker Ellbogen
joint-right-wrist = Rechtes Handgelenk
joint-left-wrist = Linkes Handgelenk
joint-head = Kopf
joint-trunk = Rumpf
joint-within-right-shoulder = rechte Schulter
joint-within-left-shoulder = linke Schulter
joint-within-right-elbow = rechter Ellbogen
joint-within-left-elbow = linker Ellbogen
joint-within-right-wrist = rechtes Handgelenk
joint-within-left-wrist = linkes Handgelenk
joint-within-head = Kopf
joint-within-trunk = Rumpf
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
