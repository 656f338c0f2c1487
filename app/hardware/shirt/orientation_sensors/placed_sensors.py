"""Sensors that a person places on parts of the body: their configuration, and frames at a steady rate."""

from collections.abc import Collection, Iterable, Mapping
from typing import Annotated, Final, Self

import numpy as np
from numpy.typing import NDArray
from pydantic import Field, field_validator, model_validator

from app.arrivals import Arrivals, ArrivalVerdict
from app.clock import Clock
from app.hardware.shirt.arrival_watch import GOOD, WAITING, ArrivalWatch
from app.hardware.shirt.kind import FieldTexts, ShirtConfig, ShirtRate
from app.hardware.shirt.orientation_sensors.body_parts import PARTS, TRUNK, layout_of, part_title
from app.hardware.shirt.orientation_sensors.orientation_frames import OrientationFrames
from app.messages import ALIVE, SensorFrame
from app.quantities import Line
from app.texts import Text, in_sequence

LONGEST_HOLD_UP: Final = 1.0  # s: after a longer one, the frames meanwhile are lost, as those of a device are

PlacedSensor = Annotated[
    Annotated[Line, Field(min_length=1, max_length=40)] | None, Field(json_schema_extra={"format": "tracker"})
]
"""The name of the sensor that is on a part of the body; None: there is none."""


class PlacedSensorsConfig(ShirtConfig):
    """Which sensor is on which part of the body."""

    sample_rate: ShirtRate = 50.0
    from_neighbour: Annotated[bool, FieldTexts(Text("shirtdev-from-neighbour"))] = True
    trunk: Annotated[PlacedSensor, FieldTexts(Text("shirtdev-part-trunk"), Text("shirtdev-trunk-hint"))] = None
    chair: Annotated[PlacedSensor, FieldTexts(Text("shirtdev-part-chair"), Text("shirtdev-chair-hint"))] = None
    head: Annotated[PlacedSensor, FieldTexts(Text("shirtdev-part-head"))] = None
    left_upper_arm: Annotated[PlacedSensor, FieldTexts(Text("shirtdev-part-left-upper-arm"))] = None
    right_upper_arm: Annotated[PlacedSensor, FieldTexts(Text("shirtdev-part-right-upper-arm"))] = None
    left_forearm: Annotated[PlacedSensor, FieldTexts(Text("shirtdev-part-left-forearm"))] = None
    right_forearm: Annotated[PlacedSensor, FieldTexts(Text("shirtdev-part-right-forearm"))] = None
    left_hand: Annotated[PlacedSensor, FieldTexts(Text("shirtdev-part-left-hand"))] = None
    right_hand: Annotated[PlacedSensor, FieldTexts(Text("shirtdev-part-right-hand"))] = None
    left_fingers: Annotated[PlacedSensor, FieldTexts(Text("shirtdev-part-left-fingers"))] = None
    right_fingers: Annotated[PlacedSensor, FieldTexts(Text("shirtdev-part-right-fingers"))] = None
    left_thigh: Annotated[PlacedSensor, FieldTexts(Text("shirtdev-part-left-thigh"))] = None
    right_thigh: Annotated[PlacedSensor, FieldTexts(Text("shirtdev-part-right-thigh"))] = None
    left_lower_leg: Annotated[PlacedSensor, FieldTexts(Text("shirtdev-part-left-lower-leg"))] = None
    right_lower_leg: Annotated[PlacedSensor, FieldTexts(Text("shirtdev-part-right-lower-leg"))] = None
    left_foot: Annotated[PlacedSensor, FieldTexts(Text("shirtdev-part-left-foot"))] = None
    right_foot: Annotated[PlacedSensor, FieldTexts(Text("shirtdev-part-right-foot"))] = None

    @classmethod
    def checked_sensor(cls, name: str) -> str:
        """Return a valid name of a sensor as it is compared; ValueError for any other text."""
        return name

    @field_validator(*PARTS)
    @classmethod
    def _is_a_sensor(cls, name: str | None) -> str | None:
        return None if name is None else cls.checked_sensor(name)

    @model_validator(mode="after")
    def _a_sensor_is_on_one_part(self) -> Self:
        names = list(self.sensors.values())
        for name in names:
            if names.count(name) > 1:
                raise ValueError(Text("shirtdev-sensor-twice", sensor=name))
        return self

    @property
    def sensors(self) -> Mapping[str, str]:
        """The names of the sensors by the parts of the body (names of PARTS)."""
        named: dict[str, str | None] = {part: getattr(self, part) for part in PARTS}
        return {part: name for part, name in named.items() if name is not None}


class FrameGrid:
    """Counts the instants of the nominal rate, from now on, and the frames that were made at them.

    Attributes
    ----------
    lost : int
        Instants without a frame since the first frame.
    """

    __slots__ = ("_clock", "_first", "_next", "_number", "_rate", "_start", "lost")

    def __init__(self, clock: Clock, sample_rate: float) -> None:
        self.lost = 0
        self._clock = clock
        self._rate = sample_rate
        self._start = clock.now()
        self._number = 0  # of the next instant
        self._first = -1  # number of the first frame's instant, -1 before it
        self._next = 0  # seq of the frame that would follow the last one

    @property
    def due(self) -> float:
        """The next instant, monotonic s."""
        return self._start + self._number / self._rate

    def advance(self) -> float:
        """Go on to the instant after the next one, and return the one that has passed (monotonic s)."""
        behind = self._clock.now() - self.due
        if behind > LONGEST_HOLD_UP:
            self._number += int(behind * self._rate)
        passed = self.due
        self._number += 1
        return passed

    def frame(self, values: NDArray[np.float32]) -> SensorFrame:
        """Return the frame of the instant that has passed."""
        number = self._number - 1
        if self._first < 0:
            self._first = number
        seq = number - self._first
        self.lost += seq - self._next
        self._next = seq + 1
        return SensorFrame(seq & 0xFFFFFFFF, seq / self._rate, self._clock.now(), values)


class PlacedSensorsShirt:
    """What the shirts of placed sensors have in common: frames on a grid, and sentences about the sensors."""

    def __init__(self, name: str, config: PlacedSensorsConfig, bends: Collection[str], clock: Clock) -> None:
        """`name` is that of the layout; the parts of the body in `bends` wear strain sensors."""
        # Without a sensor on the body there is a shirt all the same, so that the page can offer those that are found.
        has_signals = any(PARTS[part].joint is not None for part in config.sensors)
        self.layout = layout_of(name, config.sensors if has_signals else [TRUNK], bends)
        self.sample_rate = config.sample_rate
        self._kind = config.kind
        self._sensors = config.sensors
        self._from_neighbour = config.from_neighbour
        self._bends = bends
        self._clock = clock
        self._is_open = False
        self._begin()

    def _begin(self) -> None:
        """Forget everything that was received."""
        self._frames = OrientationFrames(self._sensors, self._bends, self.sample_rate, self._from_neighbour)
        self._grid = FrameGrid(self._clock, self.sample_rate)
        self._watch = ArrivalWatch(self._clock.now())

    @property
    def lost(self) -> int:
        """Instants of the nominal rate without a sample of any sensor, since the first frame."""
        return self._grid.lost

    def read(self, timeout: float) -> SensorFrame | None:
        """Return the next frame, waiting for it at most `timeout` (s)."""
        end = self._clock.now() + timeout
        if not self._is_open:
            self._clock.sleep_until(end)
            return None
        while True:
            self._receive_until(min(self._grid.due, end))
            if self._clock.now() < self._grid.due:
                return None
            values = self._frames.frame(self._grid.advance())
            if values is not None:
                return self._grid.frame(values)
            if self._clock.now() >= end:
                return None

    def pending(self) -> bool:
        """Return whether the next frame is due already."""
        return self._is_open and self._grid.due <= self._clock.now()

    def _receive_until(self, t: float) -> None:
        """Take in what comes until `t` (monotonic s)."""
        self._clock.sleep_until(t)

    def _arrivals(self, reasons: Mapping[ArrivalVerdict, Text], silence: ArrivalVerdict = "nothing") -> Arrivals:
        """Return what arrives; `reasons` has sentences on why no signals do.

        `silence` is the verdict while nothing comes, not even what is left out. Sensors that send and were not at rest
        yet give no signals; they may wait for a silent one that they are measured from.
        """
        now = self._clock.now()
        verdict = self._watch.verdict(now)
        verdict = silence if verdict == "nothing" else verdict
        message = GOOD if verdict == "arrives" else reasons.get(verdict, WAITING)
        silent, moving = self._frames.silent(now - ALIVE), self._moving(self._frames.silent(now))
        if verdict == "arrives" and silent:
            parts = [part_title(part) for part in silent]
            verdict, message = "partial", Text("arrivals-partial", source=self._kind, parts=parts)
        elif verdict == "arrives" and moving:
            verdict, message = "moving", Text("shirtdev-sensors-moving", parts=[part_title(part) for part in moving])
        return Arrivals(verdict, message, self._watch.accepted, self._watch.left_out)

    def _moving(self, silent: Collection[str]) -> list[str]:
        """Return the parts of the body, but the silent ones, whose sensors were not at rest yet."""
        return [part for part in self._frames.moving if part not in silent]

    def _count_sending(self) -> int:
        """Return how many sensors on the body send."""
        return len(self._sensors) - len(self._frames.silent(self._clock.now()))

    def _sentences(self, first: Text, low: Iterable[str] = (), found: Text | None = None) -> Text:
        """Return `first`, behind it what is wrong with which sensors, and `found`.

        The batteries of the parts in `low` are almost empty.
        """
        silent = self._frames.silent(self._clock.now())
        sentences = [first]
        for message, parts in (
            ("shirtdev-sensors-silent", silent),
            ("shirtdev-sensors-moving", self._moving(silent)),
            ("shirtdev-sensors-drift", self._frames.drifting),
            ("shirtdev-sensors-battery", list(low)),
        ):
            if parts:
                sentences.append(Text(message, parts=[part_title(part) for part in parts]))
        return in_sequence(sentences if found is None else [*sentences, found])
