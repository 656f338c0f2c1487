### Names of joints: alone or at the beginning ("joint-..."), and within a sentence ("joint-within-...").

joint-right-shoulder = Hombro derecho
joint-left-shoulder = Hombro izquierdo
joint-right-elbow = Codo derecho
joint-left-elbow = Codo izquierdo
joint-right-wrist = Muñeca derecha
joint-left-wrist = Muñeca izquierda
joint-within-right-shoulder = hombro derecho
joint-within-left-shoulder = hombro izquierdo
joint-within-right-elbow = codo derecho
joint-within-left-elbow = codo izquierdo
joint-within-right-wrist = muñeca derecha
joint-within-left-wrist = muñeca izquierda
# A sensor: "Right elbow 3".
joint-sensor = { $joint } { $number }
