### Titles, instructions and room labels of the floor plans and scenes that come with the program (data/floorplans,
### data/scenes). Clinicians read titles, also in reports; patients read instructions, on their own screen.
### A title has at most 80 letters, an instruction 200. The English is that of the document.

## Levels of a scene

place-level-easy = Fácil
place-level-medium = Medio
place-level-hard = Difícil
# scene: title of the scene, such as “Desert”.
scene-at-easy = { $scene }, nivel fácil
scene-at-medium = { $scene }, nivel medio
scene-at-hard = { $scene }, nivel difícil

## Labels of rooms, on the drawn plan

# A short word or two: they stand on the floor of the room.
place-room-therapy = Terapia
place-room-office = Oficina
place-room-entrance = Entrada
place-room-store = Almacén
place-room-consulting-room = Consulta
place-room-bathroom = Baño
place-room-waiting-area = Sala de espera
place-room-examination-1 = Exploración 1
place-room-examination-2 = Exploración 2
place-room-gym = Gimnasio
place-room-quiet-room = Sala de descanso
place-room-west-court = Patio oeste
place-room-east-court = Patio este
place-room-south-corridor = Pasillo sur
place-room-north-corridor = Pasillo norte
place-room-passage = Pasaje
place-room-living-room = Salón
place-room-kitchen = Cocina
place-room-hall = Vestíbulo
place-room-bedroom = Dormitorio
place-room-study = Despacho
place-room-guest-room = Cuarto de invitados

## Clinic

place-clinic-title = Planta de una clínica
place-clinic-main-title = De la sala de terapia a la consulta
place-clinic-main-instruction = Siga la línea blanca por los pasillos y el gimnasio hasta la consulta.
place-clinic-first-corner-title = Salir de la sala y doblar una esquina
place-clinic-first-corner-instruction = Salga de la sala por la puerta y siga la línea blanca hacia la derecha.
place-clinic-corridor-title = Recto por el pasillo
place-clinic-corridor-instruction = Conduzca recto por el pasillo hasta el final de la línea blanca.

## Apartment

place-apartment-title = Vivienda
place-apartment-main-title = Del sofá al cuarto de invitados
place-apartment-main-instruction = Salga del salón, siga por el vestíbulo y entre en el cuarto de invitados.
place-apartment-bedroom-title = Al dormitorio
place-apartment-bedroom-instruction = Pase por la puerta al vestíbulo y gire a la derecha para entrar en el dormitorio.

## Corridors

place-corridors-title = Pasillos anchos
place-corridors-main-title = Por dos pasillos
place-corridors-main-instruction = Siga la línea blanca hasta la esquina y gire a la izquierda.
place-corridors-straight-title = Todo recto
place-corridors-straight-instruction = Conduzca recto por el pasillo hasta el final de la línea blanca.
place-corridors-round-title = Una vuelta al edificio
place-corridors-round-instruction = Siga la línea blanca y dé una vuelta completa hasta el punto donde empezó.

## Building

place-building-title = Edificio
place-building-about = Pasillos, salas pequeñas y puertas de una clínica; en los niveles más difíciles hay cosas en medio del paso.
place-building-corridor-title = Por el pasillo
place-building-corridor-instruction = Conduzca por el pasillo hasta el final de la línea blanca.
place-building-room-title = Entrar en una sala pequeña
place-building-room-instruction = Conduzca por el pasillo y entre en el baño, a la derecha.
place-building-doors-title = Por dos puertas
place-building-doors-instruction = Salga de la sala, gire a la derecha y entre en la sala de exploración, a la izquierda.
place-building-gym-title = Por el gimnasio
place-building-gym-instruction = Siga la línea blanca por el gimnasio y de vuelta al pasillo.

## Desert

place-desert-title = Desierto
place-desert-about = Terreno abierto entre dunas, con rocas de las que hay que alejarse. Solo el propio camino guía la vista.
place-desert-way-title = A través del desierto
place-desert-way-instruction = Conduzca hasta la bandera y manténgase lejos de las rocas.

## Obstacles

place-obstacles-title = Obstáculos
place-obstacles-about = Conos blandos que hay que rodear y huecos entre cajas cada vez más estrechos.
place-obstacles-slalom-title = Eslalon entre conos
place-obstacles-slalom-instruction = Rodee los conos, uno por la izquierda y otro por la derecha, sin tocar ninguno.
place-obstacles-gaps-title = Por tres huecos
place-obstacles-gaps-instruction = Pase por los tres huecos sin tocar las cajas.

## Follow me

place-follow-me-title = Sígame
place-follow-me-about = Alguien va delante, unas veces más rápido y otras más despacio. Manténgase un metro y medio por detrás.
place-follow-me-person-title = Detrás de una persona
place-follow-me-person-instruction = Siga a la persona a un metro y medio de distancia.

## Follow the chair

place-follow-chair-title = Seguir la silla
place-follow-chair-about = Otra silla de ruedas va delante por pasillos anchos y también dobla esquinas. Manténgase un metro y medio por detrás.
place-follow-chair-chair-title = Detrás de otra silla de ruedas
place-follow-chair-chair-instruction = Siga a la silla de ruedas que va delante a un metro y medio de distancia.

## A door

place-door-title = Una puerta
place-door-about = Una puerta, de frente o desde un lado.
place-door-straight-title = De frente
place-door-straight-instruction = Pase por la puerta sin tocar el marco.
place-door-aside-title = Doblar la esquina y pasar
place-door-aside-instruction = Gire a la derecha hacia la puerta y pase sin tocar el marco.

## Turning on the spot

place-turning-title = Girar en el sitio
place-turning-about = Gire hasta mirar a la marca y quédese donde está.
place-turning-left-title = Un cuarto de vuelta a la izquierda
place-turning-left-instruction = Gire en el sitio a la izquierda hasta mirar a la marca y después quédese en reposo.
place-turning-right-title = Un cuarto de vuelta a la derecha
place-turning-right-instruction = Gire en el sitio a la derecha hasta mirar a la marca y después quédese en reposo.
place-turning-about-title = Media vuelta a la izquierda
place-turning-about-instruction = Dé media vuelta a la izquierda hasta mirar a la marca y después quédese en reposo.

## Backing

place-backing-title = Marcha atrás
place-backing-about = Dos metros marcha atrás entre dos paredes, en línea recta.
place-backing-back-title = Dos metros atrás
place-backing-back-instruction = Retroceda dos metros en línea recta y después deténgase.

## Wheelchair skills: a course of stages, in the order in which they are driven

place-skills-title = Habilidades con la silla
# The Wheelchair Skills Test is a test of Dalhousie University; its name is not translated.
place-skills-about = Un circuito al estilo del Wheelchair Skills Test: avance, retroceso, giros en el sitio y en marcha, una puerta.
place-skills-course-title = El circuito completo
# At the top of the page stand the title of the stage and its number.
place-skills-course-instruction = Haga una tarea tras otra, como se indica arriba.
place-skills-course-6-m-straight-ahead-title = 6 m recto
place-skills-course-6-m-straight-ahead-instruction = Conduzca recto hasta la bandera.
place-skills-course-10-m-straight-ahead-title = 10 m recto
place-skills-course-10-m-straight-ahead-instruction = Conduzca recto hasta la bandera.
place-skills-course-back-two-metres-title = Dos metros atrás
place-skills-course-back-two-metres-instruction = Retroceda dos metros en línea recta y después deténgase.
place-skills-course-forward-again-title = Otra vez adelante
place-skills-course-forward-again-instruction = Avance hasta la bandera.
place-skills-course-a-quarter-turn-to-the-left-title = Un cuarto de vuelta a la izquierda
place-skills-course-a-quarter-turn-to-the-left-instruction = Gire en el sitio a la izquierda hasta mirar a la marca y después quédese en reposo.
place-skills-course-turn-left-while-driving-title = Girar a la izquierda en marcha
place-skills-course-turn-left-while-driving-instruction = Siga la línea blanca por la curva.
place-skills-course-through-the-door-title = Por la puerta
place-skills-course-through-the-door-instruction = Pase por la puerta sin tocar el marco.
place-skills-course-half-a-turn-to-the-right-title = Media vuelta a la derecha
place-skills-course-half-a-turn-to-the-right-instruction = Dé media vuelta a la derecha hasta mirar a la marca y después quédese en reposo.
