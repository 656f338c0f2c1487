### Titles, instructions and room labels of the floor plans and scenes that come with the program (data/floorplans,
### data/scenes). Clinicians read titles, also in reports; patients read instructions, on their own screen.
### A title has at most 80 letters, an instruction 200. The English is that of the document.

## Levels of a scene

place-level-easy = Easy
place-level-medium = Medium
place-level-hard = Hard
# scene: title of the scene, such as “Desert”.
scene-at-easy = { $scene }, easy
scene-at-medium = { $scene }, medium
scene-at-hard = { $scene }, hard

## Labels of rooms, on the drawn plan

# A short word or two: they stand on the floor of the room.
place-room-therapy = Therapy
place-room-office = Office
place-room-entrance = Entrance
place-room-store = Store
place-room-consulting-room = Consulting room
place-room-bathroom = Bathroom
place-room-waiting-area = Waiting area
place-room-examination-1 = Examination 1
place-room-examination-2 = Examination 2
place-room-gym = Gym
place-room-quiet-room = Quiet room
place-room-west-court = West court
place-room-east-court = East court
place-room-south-corridor = South corridor
place-room-north-corridor = North corridor
place-room-passage = Passage
place-room-living-room = Living room
place-room-kitchen = Kitchen
place-room-hall = Hall
place-room-bedroom = Bedroom
place-room-study = Study
place-room-guest-room = Guest room

## Clinic

place-clinic-title = Clinic storey
place-clinic-main-title = From therapy to the consulting room
place-clinic-main-instruction = Follow the white line through the corridors and the gym to the consulting room.
place-clinic-first-corner-title = Out of the room and round one corner
place-clinic-first-corner-instruction = Leave the room through the door and follow the white line to the right.
place-clinic-corridor-title = Straight along the corridor
place-clinic-corridor-instruction = Drive straight along the corridor to the end of the white line.

## Apartment

place-apartment-title = Apartment
place-apartment-main-title = From the sofa to the guest room
place-apartment-main-instruction = Drive out of the living room, along the hall and into the guest room.
place-apartment-bedroom-title = To the bedroom
place-apartment-bedroom-instruction = Drive through the door into the hall and turn right into the bedroom.

## Corridors

place-corridors-title = Wide corridors
place-corridors-main-title = Along two corridors
place-corridors-main-instruction = Follow the white line to the corner and turn left.
place-corridors-straight-title = Straight ahead
place-corridors-straight-instruction = Drive straight along the corridor to the end of the white line.
place-corridors-round-title = Once round the building
place-corridors-round-instruction = Follow the white line once round, back to where you began.

## Building

place-building-title = Building
place-building-about = Corridors, small rooms and doorways of a clinic, at the harder levels with things left in the way.
place-building-corridor-title = Along the corridor
place-building-corridor-instruction = Drive along the corridor to the end of the white line.
place-building-room-title = Into a small room
place-building-room-instruction = Drive along the corridor and into the bathroom on the right.
place-building-doors-title = Through two doors
place-building-doors-instruction = Leave the room, turn right, and drive into the examination room on the left.
place-building-gym-title = Through the gym
place-building-gym-instruction = Follow the white line through the gym and back into the corridor.

## Desert

place-desert-title = Desert
place-desert-about = Open ground between dunes, with rocks to keep away from. Nothing guides the eye but the way itself.
place-desert-way-title = Across the desert
place-desert-way-instruction = Drive to the flag and keep away from the rocks.

## Obstacles

place-obstacles-title = Obstacles
place-obstacles-about = Soft cones to drive round, and gaps between crates that grow narrower.
place-obstacles-slalom-title = Slalom between cones
place-obstacles-slalom-instruction = Drive round each cone, left and right in turn, without touching one.
place-obstacles-gaps-title = Through three gaps
place-obstacles-gaps-instruction = Drive through the three gaps without touching the crates.

## Follow me

place-follow-me-title = Follow me
place-follow-me-about = Somebody goes ahead, faster and slower. Stay a metre and a half behind.
place-follow-me-person-title = Behind a person
place-follow-me-person-instruction = Follow the person at a distance of one and a half metres.

## Follow the chair

place-follow-chair-title = Follow the chair
place-follow-chair-about = Another wheelchair drives ahead through wide corridors, round corners too. Stay a metre and a half behind.
place-follow-chair-chair-title = Behind another wheelchair
place-follow-chair-chair-instruction = Follow the wheelchair ahead at a distance of one and a half metres.

## A door

place-door-title = A door
place-door-about = One doorway, straight ahead or from the side.
place-door-straight-title = Straight through
place-door-straight-instruction = Drive through the door without touching its frame.
place-door-aside-title = Round the corner and through
place-door-aside-instruction = Turn right towards the door and drive through without touching its frame.

## Turning on the spot

place-turning-title = Turning on the spot
place-turning-about = Turn until you look at the mark, and stay where you are.
place-turning-left-title = A quarter to the left
place-turning-left-instruction = Turn left on the spot until you look at the mark, then rest.
place-turning-right-title = A quarter to the right
place-turning-right-instruction = Turn right on the spot until you look at the mark, then rest.
place-turning-about-title = Half a turn to the left
place-turning-about-instruction = Turn round to the left until you look at the mark, then rest.

## Backing

place-backing-title = Backing
place-backing-about = Two metres backwards between two walls, in a straight line.
place-backing-back-title = Back two metres
place-backing-back-instruction = Drive two metres straight back, then stop.

## Wheelchair skills: a course of stages, in the order in which they are driven

place-skills-title = Wheelchair skills
# The Wheelchair Skills Test is a test of Dalhousie University; its name is not translated.
place-skills-about = A course in the style of the Wheelchair Skills Test: ahead, back, turns on the spot and while driving, a door.
place-skills-course-title = The whole course
# At the top of the page stand the title of the stage and its number.
place-skills-course-instruction = Do one task after the other, as the words at the top say.
place-skills-course-6-m-straight-ahead-title = 6 m straight ahead
place-skills-course-6-m-straight-ahead-instruction = Drive straight ahead to the flag.
place-skills-course-10-m-straight-ahead-title = 10 m straight ahead
place-skills-course-10-m-straight-ahead-instruction = Drive straight ahead to the flag.
place-skills-course-back-two-metres-title = Back two metres
place-skills-course-back-two-metres-instruction = Drive two metres straight back, then stop.
place-skills-course-forward-again-title = Forward again
place-skills-course-forward-again-instruction = Drive forward to the flag.
place-skills-course-a-quarter-turn-to-the-left-title = A quarter turn to the left
place-skills-course-a-quarter-turn-to-the-left-instruction = Turn left on the spot until you look at the mark, then rest.
place-skills-course-turn-left-while-driving-title = Turn left while driving
place-skills-course-turn-left-while-driving-instruction = Follow the white line round the bend.
place-skills-course-through-the-door-title = Through the door
place-skills-course-through-the-door-instruction = Drive through the door without touching its frame.
place-skills-course-half-a-turn-to-the-right-title = Half a turn to the right
place-skills-course-half-a-turn-to-the-right-instruction = Turn round to the right until you look at the mark, then rest.
