"""The parameters of the simulated person: each with its unit and its source."""

import math
from dataclasses import dataclass, field, replace
from typing import Literal, NamedTuple

Skill = Literal["novice", "practised", "improving", "deteriorating"]

SMALLEST_RANGE, LARGEST_RANGE = 0.4, 1.25  # of the first session's range: beyond it another vocabulary is needed
LARGEST_TREMOR = 0.04  # of the range, about 5 degrees of an elbow: with a larger tremor nobody drives by strokes


class PracticeEffect(NamedTuple):
    """A quantity that changes exponentially with practice, from `first` to `last`; `strokes` is its constant."""

    first: float
    last: float
    strokes: float

    def after(self, strokes: float) -> float:
        """Return the quantity after `strokes` strokes of practice."""
        return self.last + (self.first - self.last) * math.exp(-strokes / self.strokes)


@dataclass(frozen=True, slots=True)
class PersonParameters:
    """A person who drives by strokes: short movements of one limb, each decided on its own.

    Attributes
    ----------
    reaction_time : s from seeing to moving. Simple visual reactions take 0.2 to 0.3 s
        (Woodworth and Schlosberg, Experimental Psychology, 1954).
    hesitation : s between two strokes on top of the reaction time. Early learners think about which limb to move
        (Fitts and Posner's cognitive stage, 1967); practice takes most of it away.
    stroke_noise : standard deviation of a stroke's size over its size. Noise grows with the motor command (Harris and
        Wolpert, Nature 394, 1998); about 0.1 in able reaching (van Beers, Haggard and Wolpert, J Neurophysiol 91,
        2004), several times that in unpractised movement and after cervical injury.
    constant_noise : standard deviation of a stroke's size, of the joint's range, that does not depend on the size (van
        Beers et al.).
    timing_noise : standard deviation of a stroke's duration over its duration (van Beers et al.).
    wrong_limb : chance that another limb moves than was meant; a quarter at first, hardly ever with practice
        (docs/learning/simulated-person.md).
    estimate_error : standard deviation of the logarithm of (believed / true effect) of a stroke, drawn for each limb
        at the start: 0.8 is a factor of 2.2 either way.
    correction : share of the error in a stroke's effect that is corrected at the next one. State-space fits of
        adaptation give 0.05 to 0.2 (Cheng and Sabes, Neural Computation 18, 2006; Smith et al., PLoS Biology 4, 2006).
    rise_base, rise_slope : a stroke takes rise_base + rise_slope x size seconds: larger movements last little longer
        (isochrony principle, Viviani and Terzuolo 1982).
    return_factor : duration of the return to rest over that of the stroke.
    shrug : largest share of a shoulder's stroke that goes up or down instead.
    smallest, largest : bounds of a stroke's size, of the joint's range.
    cruise_speed, corner_speed, goal_speed : m/s aimed at on the straight, in a corner and at the goal; the chair
        could do 0.8; a corridor with doors allows half of walking pace.
    braking : m/s2 that the person expects before a corner: one stroke in a second or two.
    look_ahead : m along the path to the point that is steered for; with speed_look_ahead, s, added as speed x time.
    heading_tolerance : rad of heading error that is not corrected; a learner corrects only what is plain to see.
    speed_tolerance : m/s of speed error that is not corrected.
    fatigue_noise, fatigue_hesitation : share by which noise and hesitation grow at complete fatigue.
    fatigue_strokes : strokes in one session after which fatigue has reached 63 %; it is gone at the next session.
    range_per_session : share by which the range of every joint grows (above 0) or shrinks from session to session.
    tremor : standard deviation of a 4 to 8 Hz tremor in the first session, of a joint's range; at rest and in movement.
    tremor_per_session : what every further session adds to the tremor.
    learns : whether practice changes anything at all.
    practice : strokes practised before the first one here.

    The constants of learning, 350 and 230 strokes, come from one person's 480 reaches with a body-machine interface:
    error fell with a constant of 119 reaches, time with one of 78 (docs/learning/simulated-person.md). A reach of about
    6 s has room for three strokes of 2 s. A trial of 28 m takes 50 strokes of a practised person, 100 of a novice.
    """

    reaction_time: float = 0.25
    hesitation: PracticeEffect = field(default=PracticeEffect(0.4, 0.05, 230.0))
    stroke_noise: PracticeEffect = field(default=PracticeEffect(0.5, 0.1, 350.0))
    constant_noise: float = 0.015
    timing_noise: float = 0.08
    wrong_limb: PracticeEffect = field(default=PracticeEffect(0.25, 0.01, 230.0))
    estimate_error: PracticeEffect = field(default=PracticeEffect(0.8, 0.1, 350.0))
    correction: float = 0.08
    rise_base: float = 0.35
    rise_slope: float = 0.25
    return_factor: float = 1.4
    shrug: float = 0.15
    smallest: float = 0.18
    largest: float = 0.95
    cruise_speed: float = 0.65
    corner_speed: float = 0.25
    goal_speed: float = 0.35
    braking: float = 0.2
    look_ahead: float = 0.7
    speed_look_ahead: float = 0.7
    heading_tolerance: PracticeEffect = field(default=PracticeEffect(0.3, 0.11, 350.0))
    speed_tolerance: float = 0.07
    fatigue_noise: float = 0.0
    fatigue_hesitation: float = 0.0
    fatigue_strokes: float = 400.0
    range_per_session: float = 0.0
    tremor: float = 0.0
    tremor_per_session: float = 0.0
    learns: bool = True
    practice: float = 0.0

    def range_in(self, session: int) -> float:
        """Return the range of every joint in a session (from 1), as a share of that in the first."""
        return min(LARGEST_RANGE, max(SMALLEST_RANGE, (1.0 + self.range_per_session) ** (session - 1)))

    def tremor_in(self, session: int) -> float:
        """Return the tremor's standard deviation in a session (from 1), of a joint's range."""
        return min(LARGEST_TREMOR, max(0.0, self.tremor + self.tremor_per_session * (session - 1)))

    def fatigue(self, most: float, strokes: float) -> float:
        """Return the factor, up to 1 + `most`, by which fatigue raises a quantity after `strokes` in a session."""
        return 1.0 + most * (1.0 - math.exp(-strokes / self.fatigue_strokes))


NOVICE = PersonParameters()
PRACTISED = replace(NOVICE, practice=1500.0)  # about twenty-five trials
IMPROVING = replace(NOVICE, fatigue_noise=0.2, fatigue_hesitation=0.3, range_per_session=0.01)
"""A beginner in training: learns, tires within a session, and gains a little range from session to session."""
DETERIORATING = replace(
    NOVICE,
    practice=PRACTISED.practice,
    fatigue_noise=0.3,
    fatigue_hesitation=0.4,
    range_per_session=-0.02,
    tremor_per_session=0.003,
)
"""A practised person whose joints lose 2 % of their range with every session, and whose tremor grows."""
PARAMETERS: dict[Skill, PersonParameters] = {
    "novice": NOVICE,
    "practised": PRACTISED,
    "improving": IMPROVING,
    "deteriorating": DETERIORATING,
}
