"""The catalogue of measures: what each is called, its unit, which way is better, and in which trials it counts.

Pages, reports, exports, verdicts, learning curves and the command line read it; none of them has a table of its own. A
new measure is one entry here and its computation. The order is that of pages, reports and exported tables.
"""

from dataclasses import dataclass
from typing import Any, Final, Literal

from app.number_format import with_minus

Scale = Literal["log", "root", "count", "plain"]
Better = Literal["low", "high"]
Word = Literal["better", "within", "worse", "too few", "number"]

MeasureValues = dict[str, Any]
"""The measures of a trial or a test by name, as they are stored: numbers, truth values, None where one has no value."""


@dataclass(frozen=True, slots=True)
class Measure:
    """One measure. Stored values are in the unit `ucum`; people read them multiplied by `factor`, in `unit`."""

    name: str  # on pages and reports
    unit: str  # "" for a plain number
    ucum: str  # Unified Code for Units of Measure, as FHIR has it
    digits: int  # behind the point
    scale: Scale = "plain"  # on which its noise does not depend on its level
    better: Better | None = None  # None: neither way is better, so there is no verdict
    factor: float = 1.0
    subject: str = ""  # of a sentence, where it is not "The " and the name
    definition: str = ""  # in exports, where it is not the subject without "The "
    meaning: str = ""  # one more sentence for people, where the name needs it
    needs_goal: bool = True  # a trial that did not reach the goal does not count
    of_whole: bool = False  # of the whole path or task: not shown of a trial that did not reach the goal
    of: str | None = None  # the measure that is the total, as in "2 of 5 cones"

    @property
    def as_subject(self) -> str:
        """The measure as the subject of a sentence: "The area off the path"."""
        return self.subject or f"The {self.name[0].lower()}{self.name[1:]}"

    @property
    def defined_as(self) -> str:
        """What the measure is, for readers of exports."""
        subject = self.as_subject.removeprefix("The ")
        return self.definition or f"{subject[0].upper()}{subject[1:]}"

    def figure(self, value: float) -> str:
        """Return a stored value as people read it, without its unit."""
        digits = self.digits
        if not digits and not self.unit and value != round(value):
            digits = 1  # a mean of counts
        return with_minus(f"{round(value * self.factor, digits) + 0.0:.{digits}f}")  # + 0.0: never -0

    def with_unit(self, figure: str) -> str:
        """Return a figure with the unit behind it; a degree sign stands close to it."""
        return f"{figure}{self.unit}" if self.unit == "°" else f"{figure} {self.unit}".rstrip()

    def level(self, value: float) -> str:
        """Return a stored value as people read it, with its unit."""
        return self.with_unit(self.figure(value))


# Unit on screen, UCUM code, digits.
COUNT: Final = ("", "1", 0)
RATIO: Final = ("", "1", 2)
SHARE: Final = ("%", "1", 0)
METRES: Final = ("m", "m", 2)
SECONDS: Final = ("s", "s", 1)

TRIAL_MEASURES: Final[dict[str, Measure]] = {
    "stages_done": Measure(
        "Stages done", *COUNT, "count", "high", subject="The number of stages done", needs_goal=False, of="stages"
    ),
    "follow_error_rms": Measure(
        "Usual error of the distance to the leader",
        *METRES,
        "log",
        "low",
        definition="Root mean square error of the distance to the leader",
    ),
    "follow_error_max": Measure("Largest error of the distance to the leader", *METRES, "log", "low"),
    "follow_near": Measure("Share of time near the asked distance", *SHARE, "plain", "high", factor=100.0),
    "heading_error_deg": Measure(
        "Angle off the mark", "°", "deg", 0, "root", "low", definition="Error of the heading", of_whole=True
    ),
    "turn_drift": Measure(
        "Moved off the spot",
        *METRES,
        "root",
        "low",
        subject="The way off the spot",
        definition="Largest distance from the place of the turn",
    ),
    "cones_touched": Measure(
        "Cones touched", *COUNT, "count", "low", subject="The number of cones touched", of="cones"
    ),
    "gap_clearance": Measure(
        "Narrowest clearance in a gap", *METRES, "plain", "high", definition="Smallest clearance in gaps"
    ),
    "door_contacts": Measure(
        "Contacts with door or gap",
        *COUNT,
        "count",
        "low",
        subject="The number of contacts with a door or gap",
        definition="Number of contacts at doors",
    ),
    "e_diff": Measure(
        "Area off the path", "m²", "m2", 2, "log", "low", definition="Area between trajectory and path", of_whole=True
    ),
    "dist": Measure("Distance driven", *METRES, "log", "low", of_whole=True),
    "time": Measure(
        "Time", *SECONDS, "log", "low", subject="The time for a trial", definition="Time to the goal", of_whole=True
    ),
    "dist_ratio": Measure(
        "Distance over path length",
        *RATIO,
        "log",
        "low",
        subject="The distance driven over the length of the path",
        of_whole=True,
    ),
    "cross_track_rms": Measure(
        "Usual distance from the path", *METRES, "log", "low", definition="Root mean square distance to the path"
    ),
    "cross_track_max": Measure("Largest distance from the path", *METRES, "log", "low"),
    "mean_speed": Measure("Mean speed", "m/s", "m/s", 2, "log"),  # the person, the limits and the leader choose it
    "stops": Measure("Stops", *COUNT, "count", "low", subject="The number of stops"),
    "collisions": Measure(
        "Contacts",
        *COUNT,
        "count",
        "low",
        subject="The number of contacts with walls and obstacles",
        definition="Number of collisions",
    ),
    "contact_time": Measure(
        "Time in contact", *SECONDS, "root", "low", subject="The time in contact with walls and obstacles"
    ),
    "turn_reversals": Measure(
        "Changes of turning",
        *COUNT,
        "count",
        "low",
        subject="The number of changes between left and right turns",
        definition="Number of reversals of the turning command",
    ),
    "pulses_per_metre": Measure(
        "Commands per metre", "/m", "/m", 1, "log", "low", subject="The number of commands per metre"
    ),
    "sparc": Measure(
        "Smoothness",
        *RATIO,
        "plain",
        "high",
        subject="The smoothness of the speed (higher is smoother)",
        definition="Smoothness: spectral arc length",
    ),
    "ldlj": Measure(
        "Smoothness, another measure",
        *RATIO,
        "plain",
        "high",
        subject="Another measure of the smoothness of the speed (higher is smoother)",
        definition="Smoothness: logarithmic dimensionless jerk",
    ),
}
"""The measures of a trial that are compared with those of other trials."""

INTERRUPTIONS: Final[dict[str, Measure]] = {
    "halts": Measure(
        "Halts by the machine",
        *COUNT,
        definition="Number of halts by the machine; no other measure includes their time",
    ),
    "halt_time": Measure("Time halted by the machine", *SECONDS),
    "pauses": Measure("Pauses for the screen", *COUNT, definition="Number of pauses because of the screen"),
    "pause_time": Measure("Time paused for the screen", *SECONDS, definition="Time paused because of the screen"),
    "person_stops": Measure("Stops by a person", *COUNT, subject="The number of stops by a person"),
    "person_stop_time": Measure("Time stopped by a person", *SECONDS),
}
"""What interrupted a trial: exported with its measures, and never compared."""

EXPORTED: Final = TRIAL_MEASURES | INTERRUPTIONS

CIRCUMSTANCES: Final[dict[str, Measure]] = {
    "path_length": Measure("Length of the path", *METRES),
    "cross_track_mean": Measure("Mean distance from the path, left positive", *METRES),
    "stages": Measure("Stages", *COUNT),
    "cones": Measure("Cones", *COUNT),
    "gaps": Measure("Gaps", *COUNT),
}
"""Further numbers of a trial that say what its measures are of."""

TEST_MEASURES: Final[dict[str, Measure]] = {
    "acquisitions_per_minute": Measure(
        "Targets per minute",
        "",
        "/min",
        1,
        "root",
        "high",
        definition="Two-minute test: targets per minute",
        meaning="How many targets were reached and kept for a second, for each minute of the test.",
    ),
    "throughput": Measure(
        "Speed and precision together",
        "bit/s",
        "bit/s",
        2,
        "log",
        "high",
        definition="Two-minute test: throughput (ISO 9241-411, effective width)",
        meaning="How much information the movements carry: who is twice as fast at the same precision has "
        "twice as much. Higher is better; it is not given for fewer than eight targets.",
    ),
    "first_entry": Measure(
        "Time to a target",
        "s",
        "s",
        2,
        "log",
        "low",
        definition="Two-minute test: time to the first entry into a target",
        meaning="From the appearance of a target until the dot is in it for the first time: "
        "the mean of the targets reached.",
    ),
    "dial_in": Measure(
        "Time to settle in it",
        "s",
        "s",
        2,
        "root",
        "low",
        definition="Two-minute test: time from the first entry to the last one",
        meaning="From there until the dot stays in it: 0 when the dot leaves no target again.",
    ),
    "path_efficiency": Measure(
        "Straightness of the way",
        *SHARE,
        "plain",
        "high",
        factor=100.0,
        definition="Two-minute test: straight way divided by the way of the cursor",
        meaning="The straight way over the way that the dot took: 100 % is straight.",
    ),
}
"""The measures of a two-minute test."""

LEADING: Final[tuple[tuple[tuple[str, ...], tuple[str, ...]], ...]] = (
    (("stages_done",), ("stages_done", "time", "collisions")),
    (("heading_error_deg",), ("heading_error_deg", "turn_drift", "time")),
    (("follow_error_rms",), ("follow_error_rms", "follow_near", "e_diff")),
    (("gaps", "gap_clearance"), ("gap_clearance", "e_diff", "time")),  # of a task with gaps, not at every door
    (("cones_touched",), ("cones_touched", "e_diff", "time")),
    ((), ("e_diff", "dist", "time")),
)
"""The measures that lead in a task, by what its trials have: the first row whose named measures are all there."""

LEADING_OF_TESTS: Final = ("acquisitions_per_minute", "throughput", "first_entry")

REACHED: Final = "reached"
"""Whether a trial reached its goal; of a session, the share of its trials that did. It stands beside the measures."""
REACHED_NAME: Final = "Goal reached"
WORKLOAD_NAME: Final = "Workload, 0 to 100"
"""The mean of the answers about workload after a two-minute test."""

VERDICT_WORDS: Final[dict[Word, str]] = {
    "better": "better than noise",
    "within": "within noise",
    "worse": "worse than noise",
    "too few": "too few trials",
    "number": "–",
}
VERDICT_WORDS_OF_TESTS: Final[dict[Word, str]] = {**VERDICT_WORDS, "too few": "too few tests"}


def is_number(value: object) -> bool:
    """Return whether a measure was measured, and is no truth value."""
    return isinstance(value, int | float) and not isinstance(value, bool)
