### Grades of a calibration: how well the movement of one joint can be used, and what to do. "It" is the joint.

# As in "Signal: strong".
grade-signal-strong = stark
grade-signal-fair = mittel
grade-signal-weak = schwach
# As in "Repeats well".
grade-repeats-well = gut
grade-repeats-fairly = mittel
grade-repeats-poorly = schlecht
# $signal is one of the three words above.
grade-good = Klare Hauptbewegung: { $percent } %. Signal: { $signal }.
grade-good-repeats = Wiederholbar: { $how }.
grade-unprompted = Die Bewegung wurde nicht vorgegeben. Deshalb ist nicht bekannt, in welcher Richtung sie zählt. Geben Sie sie vor.
grade-directed = Die Bewegung wurde nicht vorgegeben. In welcher Richtung sie zählt, ist von anderen Personen bekannt.
grade-no-movement = Die Bewegung hebt sich nicht vom Rauschen ab. Wiederholen Sie sie größer und schneller.
# $rating is "repeat" where the movement has to be repeated, "usable" where it need not.
grade-signal =
    { $rating ->
        [repeat] Die Bewegung ist nur { $ratio }-mal so stark wie das Rauschen. Bleiben Sie zuerst ganz ruhig, und wiederholen Sie sie dann größer.
       *[usable] Die Bewegung ist nur { $ratio }-mal so stark wie das Rauschen. Eine größere oder schnellere wäre sicherer.
    }
grade-clear =
    { $rating ->
        [repeat] Die Hauptbewegung ist nur zu { $percent } % klar, weniger als die üblichen 80 %. Wiederholen Sie die freie Bewegung, und bewegen Sie dieses Gelenk dabei nur auf eine Art.
       *[usable] Die Hauptbewegung ist nur zu { $percent } % klar, weniger als die üblichen 80 %. Bleiben Sie bei einer einzigen Bewegung dieses Gelenks.
    }
grade-no-rest = Es wurde keine Ruhe aufgezeichnet. Als Rauschen gilt das der ruhigsten halben Sekunde.
grade-agreement = Die vorgegebenen Bewegungen gehen in beide Richtungen ({ $percent } % davon in eine). Wiederholen Sie sie im Takt der Vorgabe.
grade-small-prompts = Die vorgegebenen Bewegungen nutzen nur { $percent } % des Bereichs der freien. Wiederholen Sie sie größer und im Takt der Vorgabe.
grade-uneven =
    { $rating ->
        [repeat] Die Wiederholungen unterscheiden sich um { $percent } %. Wiederholen Sie sie gleichmäßig.
       *[usable] Die Wiederholungen unterscheiden sich um { $percent } %. Mit gleichmäßigeren fährt der Rollstuhl gleichmäßiger.
    }
grade-angle = Die vorgegebene Bewegung weicht um { $degrees } Grad von der freien ab. Verwendet wird die vorgegebene Richtung. Prüfen Sie sie unter „{ try-title }“.
grade-cross-talk = Mitbewegung von „{ $joint }“: { $percent } % der eigenen Stärke. Bewegen Sie das verlangte Gelenk allein, oder ordnen Sie nicht beide zu.
grade-span-of-prompts = In der freien Bewegung kam diese Richtung kaum vor. Als Bereich gilt der der Vorgaben.
grade-one-sensor = Nur einer der Sensoren ist übrig. Prüfen Sie die anderen auf der Seite „{ rail-shirt }“.
grade-sensors-out = Ausgelassene Sensoren: { $count } von { $every }.
