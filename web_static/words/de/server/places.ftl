### Titles, instructions and room labels of the floor plans and scenes that come with the program (data/floorplans,
### data/scenes). Clinicians read titles, also in reports; patients read instructions, on their own screen.
### A title has at most 80 letters, an instruction 200. The English is that of the document.

## Levels of a scene

place-level-easy = Leicht
place-level-medium = Mittel
place-level-hard = Schwer
# scene: title of the scene, such as “Desert”.
scene-at-easy = { $scene }, leicht
scene-at-medium = { $scene }, mittel
scene-at-hard = { $scene }, schwer

## Labels of rooms, on the drawn plan

# A short word or two: they stand on the floor of the room.
place-room-therapy = Therapie
place-room-office = Büro
place-room-entrance = Eingang
place-room-store = Lager
place-room-consulting-room = Sprechzimmer
place-room-bathroom = Bad
place-room-waiting-area = Wartebereich
place-room-examination-1 = Untersuchung 1
place-room-examination-2 = Untersuchung 2
place-room-gym = Turnhalle
place-room-quiet-room = Ruheraum
place-room-west-court = Westhof
place-room-east-court = Osthof
place-room-south-corridor = Südflur
place-room-north-corridor = Nordflur
place-room-passage = Passage
place-room-living-room = Wohnzimmer
place-room-kitchen = Küche
place-room-hall = Flur
place-room-bedroom = Schlafzimmer
place-room-study = Arbeitszimmer
place-room-guest-room = Gästezimmer

## Clinic

place-clinic-title = Klinikstockwerk
place-clinic-main-title = Vom Therapieraum zum Sprechzimmer
place-clinic-main-instruction = Folgen Sie der weißen Linie durch die Flure und die Turnhalle bis zum Sprechzimmer.
place-clinic-first-corner-title = Aus dem Raum und um eine Ecke
place-clinic-first-corner-instruction = Fahren Sie durch die Tür aus dem Raum, und folgen Sie der weißen Linie nach rechts.
place-clinic-corridor-title = Geradeaus durch den Flur
place-clinic-corridor-instruction = Fahren Sie geradeaus durch den Flur bis zum Ende der weißen Linie.

## Apartment

place-apartment-title = Wohnung
place-apartment-main-title = Vom Sofa zum Gästezimmer
place-apartment-main-instruction = Fahren Sie aus dem Wohnzimmer, durch den Flur und in das Gästezimmer.
place-apartment-bedroom-title = Zum Schlafzimmer
place-apartment-bedroom-instruction = Fahren Sie durch die Tür in den Flur, und biegen Sie rechts in das Schlafzimmer ab.

## Corridors

place-corridors-title = Breite Flure
place-corridors-main-title = Durch zwei Flure
place-corridors-main-instruction = Folgen Sie der weißen Linie bis zur Ecke, und biegen Sie links ab.
place-corridors-straight-title = Geradeaus
place-corridors-straight-instruction = Fahren Sie geradeaus durch den Flur bis zum Ende der weißen Linie.
place-corridors-round-title = Einmal um das Gebäude
place-corridors-round-instruction = Folgen Sie der weißen Linie einmal herum bis zu der Stelle, an der Sie begonnen haben.

## Building

place-building-title = Gebäude
place-building-about = Flure, kleine Räume und Türen einer Klinik; auf den schwereren Stufen stehen Dinge im Weg.
place-building-corridor-title = Durch den Flur
place-building-corridor-instruction = Fahren Sie durch den Flur bis zum Ende der weißen Linie.
place-building-room-title = In einen kleinen Raum
place-building-room-instruction = Fahren Sie durch den Flur und rechts in das Bad.
place-building-doors-title = Durch zwei Türen
place-building-doors-instruction = Fahren Sie aus dem Raum, biegen Sie rechts ab, und fahren Sie links in den Untersuchungsraum.
place-building-gym-title = Durch die Turnhalle
place-building-gym-instruction = Folgen Sie der weißen Linie durch die Turnhalle und zurück in den Flur.

## Desert

place-desert-title = Wüste
place-desert-about = Offenes Gelände zwischen Dünen, mit Felsen, von denen man Abstand hält. Nur der Weg selbst führt das Auge.
place-desert-way-title = Durch die Wüste
place-desert-way-instruction = Fahren Sie zur Flagge, und halten Sie Abstand zu den Felsen.

## Obstacles

place-obstacles-title = Hindernisse
place-obstacles-about = Weiche Kegel, um die man herumfährt, und Engstellen zwischen Kisten, die immer schmaler werden.
place-obstacles-slalom-title = Slalom zwischen Kegeln
place-obstacles-slalom-instruction = Fahren Sie abwechselnd links und rechts um die Kegel, ohne einen zu berühren.
place-obstacles-gaps-title = Durch drei Engstellen
place-obstacles-gaps-instruction = Fahren Sie durch die drei Engstellen, ohne die Kisten zu berühren.

## Follow me

place-follow-me-title = Folgen Sie mir
place-follow-me-about = Jemand geht voraus, mal schneller, mal langsamer. Bleiben Sie eineinhalb Meter dahinter.
place-follow-me-person-title = Hinter einer Person
place-follow-me-person-instruction = Folgen Sie der Person mit eineinhalb Metern Abstand.

## Follow the chair

place-follow-chair-title = Dem Rollstuhl folgen
place-follow-chair-about = Ein anderer Rollstuhl fährt durch breite Flure voraus, auch um Ecken. Bleiben Sie eineinhalb Meter dahinter.
place-follow-chair-chair-title = Hinter einem anderen Rollstuhl
place-follow-chair-chair-instruction = Folgen Sie dem Rollstuhl vor Ihnen mit eineinhalb Metern Abstand.

## A door

place-door-title = Eine Tür
place-door-about = Eine Tür, geradeaus oder von der Seite.
place-door-straight-title = Geradeaus hindurch
place-door-straight-instruction = Fahren Sie durch die Tür, ohne den Rahmen zu berühren.
place-door-aside-title = Um die Ecke und hindurch
place-door-aside-instruction = Biegen Sie rechts zur Tür ab, und fahren Sie hindurch, ohne den Rahmen zu berühren.

## Turning on the spot

place-turning-title = Drehen auf der Stelle
place-turning-about = Drehen Sie, bis Sie auf die Markierung sehen, und bleiben Sie, wo Sie sind.
place-turning-left-title = Eine Vierteldrehung nach links
place-turning-left-instruction = Drehen Sie auf der Stelle nach links, bis Sie auf die Markierung sehen. Bleiben Sie dann ruhig.
place-turning-right-title = Eine Vierteldrehung nach rechts
place-turning-right-instruction = Drehen Sie auf der Stelle nach rechts, bis Sie auf die Markierung sehen. Bleiben Sie dann ruhig.
place-turning-about-title = Eine halbe Drehung nach links
place-turning-about-instruction = Drehen Sie sich nach links um, bis Sie auf die Markierung sehen. Bleiben Sie dann ruhig.

## Backing

place-backing-title = Rückwärtsfahren
place-backing-about = Zwei Meter rückwärts zwischen zwei Wänden, in gerader Linie.
place-backing-back-title = Zwei Meter zurück
place-backing-back-instruction = Fahren Sie zwei Meter gerade zurück, und halten Sie dann an.

## Wheelchair skills: a course of stages, in the order in which they are driven

place-skills-title = Fahrkönnen
# The Wheelchair Skills Test is a test of Dalhousie University; its name is not translated.
place-skills-about = Ein Parcours in der Art des Wheelchair Skills Test: vorwärts, rückwärts, Drehen auf der Stelle und während der Fahrt, eine Tür.
place-skills-course-title = Der ganze Parcours
# At the top of the page stand the title of the stage and its number.
place-skills-course-instruction = Machen Sie eine Aufgabe nach der anderen, wie es oben steht.
place-skills-course-6-m-straight-ahead-title = 6 m geradeaus
place-skills-course-6-m-straight-ahead-instruction = Fahren Sie geradeaus zur Flagge.
place-skills-course-10-m-straight-ahead-title = 10 m geradeaus
place-skills-course-10-m-straight-ahead-instruction = Fahren Sie geradeaus zur Flagge.
place-skills-course-back-two-metres-title = Zwei Meter zurück
place-skills-course-back-two-metres-instruction = Fahren Sie zwei Meter gerade zurück, und halten Sie dann an.
place-skills-course-forward-again-title = Wieder vorwärts
place-skills-course-forward-again-instruction = Fahren Sie vorwärts zur Flagge.
place-skills-course-a-quarter-turn-to-the-left-title = Eine Vierteldrehung nach links
place-skills-course-a-quarter-turn-to-the-left-instruction = Drehen Sie auf der Stelle nach links, bis Sie auf die Markierung sehen. Bleiben Sie dann ruhig.
place-skills-course-turn-left-while-driving-title = Links abbiegen während der Fahrt
place-skills-course-turn-left-while-driving-instruction = Folgen Sie der weißen Linie durch die Kurve.
place-skills-course-through-the-door-title = Durch die Tür
place-skills-course-through-the-door-instruction = Fahren Sie durch die Tür, ohne den Rahmen zu berühren.
place-skills-course-half-a-turn-to-the-right-title = Eine halbe Drehung nach rechts
place-skills-course-half-a-turn-to-the-right-instruction = Drehen Sie sich nach rechts um, bis Sie auf die Markierung sehen. Bleiben Sie dann ruhig.
