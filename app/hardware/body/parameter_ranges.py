"""The plausible range of each parameter of the simulated person, with its source.

docs/learning/simulated-person.md has the titles of the publications, and the 480 reaches.
"""

from dataclasses import fields
from typing import NamedTuple

from app.hardware.body.person_parameters import PersonParameters, PracticeEffect

SKETCH = "the design's sketch of a novice"
CHOSEN = "chosen"
REACHES = "one person's 480 reaches, a third to three times"
VAN_BEERS = "Harris and Wolpert 1998; van Beers, Haggard and Wolpert 2004"
HICK = "Hick 1952; Fitts and Posner 1967"
STATE_SPACE = "Cheng and Sabes 2006; Smith et al. 2006"
ISOCHRONY = "Viviani and Terzuolo 1982"
LOOKING = "Land and Lee 1994"
TIRED = "Missenard, Mottet and Perrey 2008"
TREMORS = "Deuschl, Bain and Brin 1998"


class Range(NamedTuple):
    """The range of a parameter in `unit`; `source` is a publication, or CHOSEN with the reason."""

    low: float
    high: float
    unit: str
    source: str


RANGES: dict[str, Range] = {
    "reaction_time": Range(0.18, 0.5, "s", "Woodworth and Schlosberg 1954 (simple); Hick 1952 (among four)"),
    "hesitation.first": Range(0.1, 1.5, "s", HICK),
    "hesitation.last": Range(0.0, 0.3, "s", HICK),
    "hesitation.strokes": Range(80.0, 700.0, "strokes", REACHES),
    "stroke_noise.first": Range(0.2, 0.6, "of the stroke", VAN_BEERS + ", several times that unpractised"),
    "stroke_noise.last": Range(0.05, 0.2, "of the stroke", VAN_BEERS),
    "stroke_noise.strokes": Range(120.0, 1050.0, "strokes", REACHES),
    "constant_noise": Range(0.0, 0.04, "of the range", VAN_BEERS),
    "timing_noise": Range(0.03, 0.15, "of the duration", VAN_BEERS),
    "wrong_limb.first": Range(0.05, 0.3, "of the strokes", SKETCH + ": a quarter"),
    "wrong_limb.last": Range(0.0, 0.05, "of the strokes", "Rabbitt 1966: a few in a hundred choices"),
    "wrong_limb.strokes": Range(80.0, 700.0, "strokes", REACHES),
    "estimate_error.first": Range(0.3, 1.0, "of the logarithm", CHOSEN + ": a new map is strange to everybody"),
    "estimate_error.last": Range(0.0, 0.2, "of the logarithm", CHOSEN),
    "estimate_error.strokes": Range(120.0, 1050.0, "strokes", REACHES),
    "correction": Range(0.05, 0.2, "of the error", STATE_SPACE),
    "rise_base": Range(0.2, 0.6, "s", ISOCHRONY),
    "rise_slope": Range(0.1, 0.5, "s", ISOCHRONY),
    "return_factor": Range(1.0, 2.0, "of the way there", SKETCH + ": more slowly"),
    "shrug": Range(0.0, 0.3, "of the stroke", CHOSEN + ": EVR comes out at 0.80 to 0.90, as in the paper"),
    "smallest": Range(0.1, 0.3, "of the range", CHOSEN + ": above the dead-zone"),
    "largest": Range(0.8, 1.0, "of the range", CHOSEN),
    "cruise_speed": Range(0.3, 0.8, "m/s", CHOSEN + ": up to the chair's highest speed"),
    "corner_speed": Range(0.15, 0.5, "m/s", CHOSEN),
    "goal_speed": Range(0.15, 0.5, "m/s", CHOSEN),
    "braking": Range(0.1, 0.5, "m/s²", CHOSEN + ": what strokes can take away"),
    "look_ahead": Range(0.4, 1.5, "m", CHOSEN),
    "speed_look_ahead": Range(0.5, 2.0, "s", LOOKING),
    "heading_tolerance.first": Range(0.1, 0.4, "rad", CHOSEN + ": a learner corrects what is plain to see"),
    "heading_tolerance.last": Range(0.05, 0.2, "rad", CHOSEN),
    "heading_tolerance.strokes": Range(120.0, 1050.0, "strokes", REACHES),
    "speed_tolerance": Range(0.03, 0.15, "m/s", CHOSEN),
    "fatigue_noise": Range(0.0, 0.5, "of the noise", TIRED),
    "fatigue_hesitation": Range(0.0, 0.5, "of the hesitation", CHOSEN),
    "fatigue_strokes": Range(100.0, 1500.0, "strokes", CHOSEN + ": two trials to a long session"),
    "range_per_session": Range(-0.03, 0.03, "of the range", CHOSEN + ": a fifth in ten sessions"),
    "tremor": Range(0.0, 0.04, "of the range", TREMORS + " (4 to 8 Hz); size chosen"),
    "tremor_per_session": Range(-0.005, 0.005, "of the range", CHOSEN),
}
"""By parameter name; a quantity that practice changes has three entries: `first`, `last` and `strokes`."""


def numbers_of(person: PersonParameters) -> dict[str, float]:
    """Return every parameter of a person that has a range, by the names of `RANGES`."""
    numbers: dict[str, float] = {}
    for field in fields(person):
        value = getattr(person, field.name)
        if isinstance(value, PracticeEffect):
            numbers |= {f"{field.name}.{part}": number for part, number in value._asdict().items()}
        elif field.name in RANGES:
            numbers[field.name] = value
    return numbers


def out_of_range(person: PersonParameters) -> tuple[str, ...]:
    """Return a sentence for every parameter of a person that lies outside its range."""
    return tuple(
        f"{name} is {value:g} {RANGES[name].unit}: choose {RANGES[name].low:g} to {RANGES[name].high:g}"
        for name, value in numbers_of(person).items()
        if not RANGES[name].low <= value <= RANGES[name].high  # also catches NaN
    )
