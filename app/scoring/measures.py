"""The catalogue of measures: what each is called, its unit, which way is better, and in which trials it counts.

Pages, reports, exports, verdicts, learning curves and the command line read it; none of them has a table of its own. A
new measure is one entry here and its computation. The order is that of pages, reports and exported tables.
"""

from dataclasses import dataclass
from typing import Any, Final, Literal

from app.scoring.units import (
    BITS_PER_SECOND,
    DEGREES,
    METRES,
    METRES_PER_SECOND,
    NUMBER,
    PER_METRE,
    PER_MINUTE,
    SECONDS,
    SHARE,
    SQUARE_METRES,
)
from app.texts import Figure, Text, Value

Scale = Literal["log", "root", "count", "plain"]
Better = Literal["low", "high"]
Word = Literal["better", "within", "worse", "too few", "number"]

MeasureValues = dict[str, Any]
"""The measures of a trial or a test by name, as they are stored: numbers, truth values, None where one has no value."""


@dataclass(frozen=True, slots=True)
class Measure:
    """One measure. Stored values are in the unit `ucum`; people read them multiplied by `factor`, in `unit`."""

    name: Text  # on pages and reports
    unit: str  # "" for a plain number
    ucum: str  # the code of the unit (units.py)
    digits: int  # behind the point
    scale: Scale = "plain"  # on which its noise does not depend on its level
    better: Better | None = None  # None: neither way is better, so there is no verdict
    factor: float = 1.0
    subject: Text | None = None  # within a sentence, of the measures of a trial
    definition: Text | None = None  # in exports, where it is not the name
    meaning: Text | None = None  # one more sentence for people, where the name needs it
    needs_goal: bool = True  # a trial that did not reach the goal does not count
    of_whole: bool = False  # of the whole path or task: not shown of a trial that did not reach the goal
    of: str | None = None  # the measure that is the total, as in "2 of 5 cones"

    @property
    def as_subject(self) -> Text:
        """The measure within a sentence: "the area off the path"."""
        return self.subject or self.name

    @property
    def defined_as(self) -> Text:
        """What the measure is, for readers of exports."""
        return self.definition or self.name

    def figure(self, value: float) -> Text:
        """Return a stored value as people read it, without its unit."""
        digits = self.digits
        if not digits and not self.unit and value != round(value):
            digits = 1  # a mean of counts
        return Text("measure-number", figure=Figure(value * self.factor, digits))

    def with_unit(self, figure: Value) -> Text:
        """Return a figure with the unit behind it; a degree sign stands close to it."""
        if not self.unit:
            return Text("measure-number", figure=figure)
        if self.unit == "°":
            return Text("measure-degrees", figure=figure)
        return Text("measure-with-unit", figure=figure, unit=self.unit)

    def level(self, value: float) -> Text:
        """Return a stored value as people read it, with its unit."""
        return self.with_unit(self.figure(value))

    def difference(self, value: float) -> Text:
        """Return a difference of two stored values as people read it, with its unit; of shares, percentage points."""
        return self.difference_with_unit(self.figure(value), round(value * self.factor, self.digits))

    def difference_with_unit(self, figure: Value, count: float) -> Text:
        """Return the figure of a difference with the unit behind it; `count` is the number that is written."""
        return Text("measure-points", figure=figure, count=count) if self.unit == "%" else self.with_unit(figure)


TRIAL_MEASURES: Final[dict[str, Measure]] = {
    "stages_done": Measure(
        Text("measure-stages-done"),
        *NUMBER,
        0,
        "count",
        "high",
        subject=Text("measure-stages-done-subject"),
        definition=Text("measure-stages-done-definition"),
        needs_goal=False,
        of="stages",
    ),
    "follow_error_rms": Measure(
        Text("measure-follow-error-rms"),
        *METRES,
        2,
        "log",
        "low",
        definition=Text("measure-follow-error-rms-definition"),
        subject=Text("measure-follow-error-rms-subject"),
    ),
    "follow_error_max": Measure(
        Text("measure-follow-error-max"), *METRES, 2, "log", "low", subject=Text("measure-follow-error-max-subject")
    ),
    "follow_near": Measure(
        Text("measure-follow-near"),
        *SHARE,
        0,
        "plain",
        "high",
        factor=100.0,
        subject=Text("measure-follow-near-subject"),
    ),
    "heading_error_deg": Measure(
        Text("measure-heading-error-deg"),
        *DEGREES,
        0,
        "root",
        "low",
        definition=Text("measure-heading-error-deg-definition"),
        of_whole=True,
        subject=Text("measure-heading-error-deg-subject"),
    ),
    "turn_drift": Measure(
        Text("measure-turn-drift"),
        *METRES,
        2,
        "root",
        "low",
        subject=Text("measure-turn-drift-subject"),
        definition=Text("measure-turn-drift-definition"),
    ),
    "cones_touched": Measure(
        Text("measure-cones-touched"),
        *NUMBER,
        0,
        "count",
        "low",
        subject=Text("measure-cones-touched-subject"),
        definition=Text("measure-cones-touched-definition"),
        of="cones",
    ),
    "gap_clearance": Measure(
        Text("measure-gap-clearance"),
        *METRES,
        2,
        "plain",
        "high",
        definition=Text("measure-gap-clearance-definition"),
        subject=Text("measure-gap-clearance-subject"),
    ),
    "door_contacts": Measure(
        Text("measure-door-contacts"),
        *NUMBER,
        0,
        "count",
        "low",
        subject=Text("measure-door-contacts-subject"),
        definition=Text("measure-door-contacts-definition"),
    ),
    "e_diff": Measure(
        Text("measure-e-diff"),
        *SQUARE_METRES,
        2,
        "log",
        "low",
        definition=Text("measure-e-diff-definition"),
        of_whole=True,
        subject=Text("measure-e-diff-subject"),
    ),
    "dist": Measure(
        Text("measure-dist"), *METRES, 2, "log", "low", of_whole=True, subject=Text("measure-dist-subject")
    ),
    "time": Measure(
        Text("measure-time"),
        *SECONDS,
        1,
        "log",
        "low",
        subject=Text("measure-time-subject"),
        definition=Text("measure-time-definition"),
        of_whole=True,
    ),
    "dist_ratio": Measure(
        Text("measure-dist-ratio"),
        *NUMBER,
        2,
        "log",
        "low",
        subject=Text("measure-dist-ratio-subject"),
        definition=Text("measure-dist-ratio-definition"),
        of_whole=True,
    ),
    "cross_track_rms": Measure(
        Text("measure-cross-track-rms"),
        *METRES,
        2,
        "log",
        "low",
        definition=Text("measure-cross-track-rms-definition"),
        subject=Text("measure-cross-track-rms-subject"),
    ),
    "cross_track_max": Measure(
        Text("measure-cross-track-max"), *METRES, 2, "log", "low", subject=Text("measure-cross-track-max-subject")
    ),
    "mean_speed": Measure(
        Text("measure-mean-speed"), *METRES_PER_SECOND, 2, "log", subject=Text("measure-mean-speed-subject")
    ),  # the person, the limits and the leader choose it
    "stops": Measure(
        Text("measure-stops"),
        *NUMBER,
        0,
        "count",
        "low",
        subject=Text("measure-stops-subject"),
        definition=Text("measure-stops-definition"),
    ),
    "collisions": Measure(
        Text("measure-collisions"),
        *NUMBER,
        0,
        "count",
        "low",
        subject=Text("measure-collisions-subject"),
        definition=Text("measure-collisions-definition"),
    ),
    "contact_time": Measure(
        Text("measure-contact-time"),
        *SECONDS,
        1,
        "root",
        "low",
        subject=Text("measure-contact-time-subject"),
        definition=Text("measure-contact-time-definition"),
    ),
    "turn_reversals": Measure(
        Text("measure-turn-reversals"),
        *NUMBER,
        0,
        "count",
        "low",
        subject=Text("measure-turn-reversals-subject"),
        definition=Text("measure-turn-reversals-definition"),
    ),
    "pulses_per_metre": Measure(
        Text("measure-pulses-per-metre"),
        *PER_METRE,
        1,
        "log",
        "low",
        subject=Text("measure-pulses-per-metre-subject"),
        definition=Text("measure-pulses-per-metre-definition"),
    ),
    "sparc": Measure(
        Text("measure-sparc"),
        *NUMBER,
        2,
        "plain",
        "high",
        subject=Text("measure-sparc-subject"),
        definition=Text("measure-sparc-definition"),
    ),
    "ldlj": Measure(
        Text("measure-ldlj"),
        *NUMBER,
        2,
        "plain",
        "high",
        subject=Text("measure-ldlj-subject"),
        definition=Text("measure-ldlj-definition"),
    ),
}
"""The measures of a trial that are compared with those of other trials."""

INTERRUPTIONS: Final[dict[str, Measure]] = {
    "halts": Measure(Text("measure-halts"), *NUMBER, 0, definition=Text("measure-halts-definition")),
    "halt_time": Measure(Text("measure-halt-time"), *SECONDS, 1),
    "pauses": Measure(Text("measure-pauses"), *NUMBER, 0, definition=Text("measure-pauses-definition")),
    "pause_time": Measure(Text("measure-pause-time"), *SECONDS, 1, definition=Text("measure-pause-time-definition")),
    "person_stops": Measure(
        Text("measure-person-stops"), *NUMBER, 0, definition=Text("measure-person-stops-definition")
    ),
    "person_stop_time": Measure(Text("measure-person-stop-time"), *SECONDS, 1),
}
"""What interrupted a trial: exported with its measures, and never compared."""

EXPORTED: Final = TRIAL_MEASURES | INTERRUPTIONS

CIRCUMSTANCES: Final[dict[str, Measure]] = {
    "path_length": Measure(Text("measure-path-length"), *METRES, 2),
    "cross_track_mean": Measure(Text("measure-cross-track-mean"), *METRES, 2),
    "stages": Measure(Text("measure-stages"), *NUMBER, 0),
    "cones": Measure(Text("measure-cones"), *NUMBER, 0),
    "gaps": Measure(Text("measure-gaps"), *NUMBER, 0),
}
"""Further numbers of a trial that say what its measures are of."""

TEST_MEASURES: Final[dict[str, Measure]] = {
    "acquisitions_per_minute": Measure(
        Text("measure-acquisitions-per-minute"),
        *PER_MINUTE,
        1,
        "root",
        "high",
        definition=Text("measure-acquisitions-per-minute-definition"),
        meaning=Text("measure-acquisitions-per-minute-meaning"),
    ),
    "throughput": Measure(
        Text("measure-throughput"),
        *BITS_PER_SECOND,
        2,
        "log",
        "high",
        definition=Text("measure-throughput-definition"),
        meaning=Text("measure-throughput-meaning"),
    ),
    "first_entry": Measure(
        Text("measure-first-entry"),
        *SECONDS,
        2,
        "log",
        "low",
        definition=Text("measure-first-entry-definition"),
        meaning=Text("measure-first-entry-meaning"),
    ),
    "dial_in": Measure(
        Text("measure-dial-in"),
        *SECONDS,
        2,
        "root",
        "low",
        definition=Text("measure-dial-in-definition"),
        meaning=Text("measure-dial-in-meaning"),
    ),
    "path_efficiency": Measure(
        Text("measure-path-efficiency"),
        *SHARE,
        0,
        "plain",
        "high",
        factor=100.0,
        definition=Text("measure-path-efficiency-definition"),
        meaning=Text("measure-path-efficiency-meaning"),
    ),
}
"""The measures of a two-minute test."""

REACHED: Final = "reached"
"""Whether a trial reached its goal; of a session, the share of its trials that did. It stands beside the measures."""
REACHED_NAME: Final = Text("measure-reached")
WORKLOAD_NAME: Final = Text("measure-workload")
"""The mean of the answers about workload after a two-minute test."""

VERDICT_WORDS: Final[dict[Word, Text]] = {
    "better": Text("verdict-word-better"),
    "within": Text("verdict-word-within"),
    "worse": Text("verdict-word-worse"),
    "too few": Text("verdict-word-few-trials"),
    "number": Text("verdict-word-none"),
}
VERDICT_WORDS_OF_TESTS: Final[dict[Word, Text]] = {**VERDICT_WORDS, "too few": Text("verdict-word-few-tests")}


def is_number(value: object) -> bool:
    """Return whether a measure was measured, and is no truth value."""
    return isinstance(value, int | float) and not isinstance(value, bool)
