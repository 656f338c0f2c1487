"""The simulated shirt: the fabric around a simulated body, frame by frame at the pace of a clock."""

from typing import Annotated, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field
from pydantic.config import JsonDict

from app.clock import Clock
from app.hardware.base import Body, BodyView, HardwareError
from app.hardware.body.minimum_jerk import minimum_jerk
from app.hardware.shirt.kind import FieldTexts, ShirtConfig, ShirtKind, ShirtRate, SourceFacts, Trust, page_texts
from app.hardware.shirt.simulated_fabric import Fabric
from app.hardware.shirt.standard import standard_layout
from app.layout import ShirtLayout
from app.messages import SensorFrame
from app.quantities import Count, Name
from app.texts import Text, text_of

LONGEST_LAG = 1.0  # s: frames that are later than this count as lost, as of a device that went on
TRANSITION_TIME = 1.0  # s for the transition from one body's posture to the next body's


def _add_choices(schema: JsonDict) -> None:
    """Add which channels can be dead to the JSON schema of a field."""
    # Two sensors of different joints, so that the demonstration shows what left-out sensors do without spoiling a
    # joint.
    all_work, two_dead = str(Text("shirtdev-simulator-all-work")), str(Text("shirtdev-simulator-two-dead"))
    schema["format"] = "channels"
    schema["choices"] = [{"title": all_work, "at": []}, {"title": two_dead, "at": [1 / 3, 3 / 4]}]


class SimulatorConfig(ShirtConfig):
    """A fabric with 52 sensors, calculated from the body inside it."""

    model_config = page_texts(
        Text("shirtdev-simulator-title"),
        about=Text("shirtdev-simulator-about"),
        in_use=Text("shirtdev-simulator-in-use", rate="{sample_rate}"),
        facts=SourceFacts(
            Text("shirtdev-simulator-needs"), Text("shirtdev-simulator-costs"), Text("shirtdev-simulator-takes")
        ),
    )

    kind: Literal["simulator"]
    sample_rate: ShirtRate = Field(
        default=100.0, json_schema_extra={"unit": "Hz", "examples": [50, 100, 200, 500, 1000]}
    )
    seed: Annotated[Count, Field(ge=1, le=999), FieldTexts(Text("shirtdev-simulator-seed"))] = Field(
        default=1, json_schema_extra={"format": "stepper"}
    )  # of the fabric: each seed is a different shirt
    layout: ShirtLayout | None = Field(default=None, json_schema_extra={"format": "hidden"})  # None: the standard shirt
    dead_channels: Annotated[tuple[Name, ...], FieldTexts(Text("shirtdev-simulator-sensors"))] = Field(
        default=(), json_schema_extra=_add_choices
    )  # names of channels with a broken line


class Pace:
    """The deadlines of frames: the first at once, then one every period."""

    __slots__ = ("_clock", "_missed", "_number", "_period", "_start")

    def __init__(self, clock: Clock, sample_rate: float) -> None:
        self._clock = clock
        self._period = 1.0 / sample_rate
        self._start = clock.now()
        self._number = 0  # of the next frame
        self._missed = 0

    def is_due(self) -> bool:
        """Return whether a frame is due now."""
        return self._clock.now() >= self._due

    def wait(self, timeout: float) -> bool:
        """Wait at most `timeout` (s) for the next deadline; True when it has passed, and the one after it is next."""
        now, due = self._clock.now(), self._due
        if due > now:
            if due > now + timeout:
                self._clock.sleep_until(now + timeout)
                return False
            self._clock.sleep_until(due)
        elif now - due > LONGEST_LAG:
            behind = int((now - due) / self._period)
            self._missed += behind
            self._number += behind
        self._number += 1
        return True

    def missed(self) -> int:
        """Return how many frames were lost since the last call."""
        missed, self._missed = self._missed, 0
        return missed

    @property
    def _due(self) -> float:
        return self._start + self._number * self._period


class SimulatedShirt:
    """Fabric around a simulated body; without a body its signals show no movement."""

    def __init__(self, config: SimulatorConfig, clock: Clock) -> None:
        self.sample_rate = config.sample_rate
        self.view = BodyView()  # what the simulated body sees; the loop updates it
        self.lost = 0
        self._config = config
        self._clock = clock
        self._layout: ShirtLayout | None = config.layout
        self._fabric: Fabric | None = None
        self._body: Body | None = None
        self._pace: Pace | None = None
        self._seq = 0
        self._posture: NDArray[np.float64] = np.zeros(0)
        self._left = self._posture  # the last posture of the body before
        self._transition_left = 0.0  # s of the transition from that posture that are left

    @property
    def layout(self) -> ShirtLayout:
        """Names and places of the channels."""
        if self._layout is None:
            self._layout = standard_layout()
        return self._layout

    @property
    def joints(self) -> tuple[str, ...]:
        """Names of the degrees of freedom that the fabric senses, and that its body should move."""
        return self._opened_fabric().joints

    @property
    def body(self) -> Body | None:
        """The simulated body; it may be replaced at any time."""
        return self._body

    @body.setter
    def body(self, body: Body | None) -> None:
        if body is not self._body:
            self._left = self._posture.copy() if self._transition_left <= 0.0 else self._transition(0.0)
            self._transition_left = TRANSITION_TIME if len(self._left) else 0.0
        self._body = body
        moved = [] if body is None else list(body.joints)
        sensed = self._opened_fabric().joints
        self._from = np.array([moved.index(name) for name in sensed if name in moved], dtype=np.intp)
        self._to = np.array([i for i, name in enumerate(sensed) if name in moved], dtype=np.intp)
        self._posture = np.zeros(len(sensed))

    def open(self) -> None:
        """Begin at frame 0.

        Raises
        ------
        HardwareError
            When the layout of the paper's shirt is missing, or a dead channel is not in the layout.
        """
        self.body = self._body
        self._opened_fabric().reset()
        self._seq = 0
        self.lost = 0
        self._pace = Pace(self._clock, self.sample_rate)

    def read(self, timeout: float) -> SensorFrame | None:
        """Return the next frame when it is due within `timeout` (s)."""
        if self._pace is None or self._fabric is None:
            self._clock.sleep_until(self._clock.now() + timeout)
            return None
        if not self._pace.wait(timeout):
            return None
        missed = self._pace.missed()
        self.lost += missed
        self._seq += missed
        dt = 1.0 / self.sample_rate
        if self._body is not None:
            self._posture[self._to] = self._body.step(dt, self.view)[self._from]
        values = self._fabric.step(self._posture if self._transition_left <= 0.0 else self._transition(dt), dt)
        frame = SensorFrame(self._seq & 0xFFFFFFFF, self._seq / self.sample_rate, self._clock.now(), values)
        self._seq += 1
        return frame

    def pending(self) -> bool:
        """Return whether the next frame is due already."""
        return self._pace is not None and self._pace.is_due()

    def description(self) -> Text:
        """Return the shirt's state in words."""
        if self._pace is None:
            return Text("shirtdev-simulator-closed")
        sensors, rate = len(self.layout.channels), round(self.sample_rate, 2)
        if self._body is None:
            return Text("shirtdev-simulator-empty", sensors=sensors, rate=rate)
        return Text("shirtdev-simulator", sensors=sensors, rate=rate)

    def close(self) -> None:
        """End the frames."""
        self._pace = None

    def _transition(self, dt: float) -> NDArray[np.float64]:
        """Return a posture of the transition from the body before to this one, so that no limb jumps."""
        self._transition_left -= dt
        share = minimum_jerk(1.0 - self._transition_left / TRANSITION_TIME)
        posture: NDArray[np.float64] = share * self._posture + (1.0 - share) * self._left
        return posture

    def _opened_fabric(self) -> Fabric:
        if self._fabric is None:
            try:
                self._fabric = Fabric(self.layout, self._config.seed, self._config.dead_channels)
            except ValueError as error:
                raise HardwareError(text_of(error)) from error
        return self._fabric


KIND = ShirtKind(SimulatorConfig, SimulatedShirt, Trust.NEVER, simulated=True)
