### Names of joints: alone or at the beginning ("joint-..."), and within a sentence ("joint-within-...").

joint-right-shoulder = Hombro derecho
joint-left-shoulder = Hombro izquierdo
joint-right-elbow = Codo derecho
joint-left-elbow = Codo izquierdo
joint-right-wrist = Muñeca derecha
joint-left-wrist = Muñeca izquierda
joint-right-fingers = Dedos de la mano derecha
joint-left-fingers = Dedos de la mano izquierda
joint-trunk = Tronco
joint-head = Cabeza
joint-right-hip = Cadera derecha
joint-left-hip = Cadera izquierda
joint-right-knee = Rodilla derecha
joint-left-knee = Rodilla izquierda
joint-right-ankle = Tobillo derecho
joint-left-ankle = Tobillo izquierdo
joint-within-right-shoulder = hombro derecho
joint-within-left-shoulder = hombro izquierdo
joint-within-right-elbow = codo derecho
joint-within-left-elbow = codo izquierdo
joint-within-right-wrist = muñeca derecha
joint-within-left-wrist = muñeca izquierda
joint-within-right-fingers = dedos de la mano derecha
joint-within-left-fingers = dedos de la mano izquierda
joint-within-trunk = tronco
joint-within-head = cabeza
joint-within-right-hip = cadera derecha
joint-within-left-hip = cadera izquierda
joint-within-right-knee = rodilla derecha
joint-within-left-knee = rodilla izquierda
joint-within-right-ankle = tobillo derecho
joint-within-left-ankle = tobillo izquierdo
# A sensor: "Right elbow 3".
joint-sensor = { $joint } { $number }
# What a channel of a camera measures of a joint: "Left shoulder: raised".
joint-channel = { $joint }: { $what }
channel-elevation = elevación
channel-forward = hacia delante
channel-out = hacia fuera
channel-bend = flexión
channel-lift = elevación del brazo
channel-height = altura
channel-yaw = giro
channel-pitch = inclinación adelante
channel-roll = inclinación lateral
channel-side = hacia un lado
