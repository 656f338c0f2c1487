"""The simulated shirt: a body in fabric, frame by frame at the pace of a clock."""

import numpy as np
from numpy.typing import NDArray

from app.clock import Clock
from app.hardware.base import Body, BodyView, HardwareError
from app.hardware.body.minimum_jerk import minimum_jerk
from app.hardware.configs import SimulatorConfig
from app.hardware.shirt.fabric import Fabric
from app.hardware.shirt.pace import Pace
from app.hardware.shirt.standard import standard_layout
from app.layout import ShirtLayout
from app.messages import SensorFrame

GLIDE = 1.0  # s from one body's posture to the next one's


class SimulatedShirt:
    """Fabric around a body; without a body it hangs still."""

    def __init__(self, config: SimulatorConfig, clock: Clock) -> None:
        self.sample_rate = config.sample_rate
        self.view = BodyView()  # what the body sees; the loop keeps it up to date
        self.lost = 0
        self._config = config
        self._clock = clock
        self._layout: ShirtLayout | None = config.layout
        self._fabric: Fabric | None = None
        self._body: Body | None = None
        self._pace: Pace | None = None
        self._seq = 0
        self._posture: NDArray[np.float64] = np.zeros(0)
        self._left = self._posture  # the posture that another body left behind
        self._glide = 0.0  # s until it is forgotten

    @property
    def layout(self) -> ShirtLayout:
        """Names and places of the channels."""
        if self._layout is None:
            self._layout = standard_layout()
        return self._layout

    @property
    def joints(self) -> tuple[str, ...]:
        """Names of the degrees of freedom that the fabric feels: what a body for it should move."""
        return self._woven().joints

    @property
    def body(self) -> Body | None:
        """What moves inside; another may slip in at any time."""
        return self._body

    @body.setter
    def body(self, body: Body | None) -> None:
        if body is not self._body:
            self._left = self._posture.copy() if self._glide <= 0.0 else self._gliding(0.0)
            self._glide = GLIDE if len(self._left) else 0.0
        self._body = body
        known = [] if body is None else list(body.joints)
        felt = self._woven().joints
        self._from = np.array([known.index(name) for name in felt if name in known], dtype=np.intp)
        self._to = np.array([i for i, name in enumerate(felt) if name in known], dtype=np.intp)
        self._posture = np.zeros(len(felt))

    def open(self) -> None:
        """Begin at frame 0, at once.

        Raises
        ------
        HardwareError
            When the layout of the paper's shirt is not there, or a dead channel is not in the layout.
        """
        self.body = self._body
        self._woven().reset()
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
        values = self._fabric.step(self._posture if self._glide <= 0.0 else self._gliding(dt), dt)
        frame = SensorFrame(self._seq & 0xFFFFFFFF, self._seq / self.sample_rate, self._clock.now(), values)
        self._seq += 1
        return frame

    def pending(self) -> bool:
        """Return whether the next frame is due already."""
        return self._pace is not None and self._pace.is_due()

    def words(self) -> str:
        """Return the shirt's state in words."""
        if self._pace is None:
            return "The simulated shirt is closed."
        inside = "with nobody in it" if self._body is None else "with a simulated body in it"
        return f"Simulated shirt, {len(self.layout.channels)} channels at {self.sample_rate:g} Hz, {inside}."

    def close(self) -> None:
        """Stop giving frames."""
        self._pace = None

    def _gliding(self, dt: float) -> NDArray[np.float64]:
        """Return the posture on the way from the body before to this one: no limb jumps when somebody slips in."""
        self._glide -= dt
        share = minimum_jerk(1.0 - self._glide / GLIDE)
        posture: NDArray[np.float64] = share * self._posture + (1.0 - share) * self._left
        return posture

    def _woven(self) -> Fabric:
        if self._fabric is None:
            try:
                self._fabric = Fabric(self.layout, self._config.seed, self._config.dead_channels)
            except ValueError as error:
                raise HardwareError(str(error)) from error
        return self._fabric
