"""From activations to u1, u2 and the stop gesture (docs/signal-chain.md, "Controls and shaping")."""

# Compiled in a wheel (hatch_build.py).

from app.calibration.vocabulary import DriveParameters
from app.pipeline.person_brakes import STOP_ACTIVATION, Brakes


class Controls:
    """The bindings of a vocabulary, as weighted sums over gestures."""

    def __init__(self, parameters: DriveParameters) -> None:
        place = {gesture.name: i for i, gesture in enumerate(parameters.gestures)}
        self._u1: list[tuple[int, float]] = []
        self._u2: list[tuple[int, float]] = []
        self._stops: list[list[int]] = []
        self.brakes = Brakes(parameters)
        for binding in parameters.bindings:
            gestures = [place[name] for name in binding.gestures]
            if binding.control == "stop":
                if gestures:
                    self._stops.append(gestures)
                continue
            gain = binding.gain if binding.control.endswith("+") else -binding.gain
            terms = self._u1 if binding.control.startswith("u1") else self._u2
            terms.extend((i, gain) for i in gestures)
        self.bound = sorted({i for i, _ in self._u1 + self._u2} | {i for stop in self._stops for i in stop})
        """Indices of the gestures that are bound to a control."""

    @property
    def terms(self) -> tuple[list[tuple[int, float]], list[tuple[int, float]]]:
        """The sums behind u1 and u2, as (gesture index, signed gain)."""
        return self._u1, self._u2

    def step(self, activation: list[float]) -> tuple[float, float]:
        """Return (u1, u2), each within [-1, 1]."""
        u1 = u2 = 0.0
        for i, gain in self._u1:
            u1 += gain * activation[i]
        for i, gain in self._u2:
            u2 += gain * activation[i]
        # Comparisons, because the functions min and max take several times as long.
        if not -1.0 <= u1 <= 1.0:
            u1 = 1.0 if u1 > 0.0 else -1.0
        if not -1.0 <= u2 <= 1.0:
            u2 = 1.0 if u2 > 0.0 else -1.0
        return u1, u2

    def is_stop(self, activation: list[float]) -> bool:
        """Return whether all gestures of a stop are active together."""
        for stop in self._stops:
            for i in stop:
                if activation[i] < STOP_ACTIVATION:
                    break
            else:
                return True
        return False

    def is_neutral(self, activation: list[float]) -> bool:
        """Return whether every bound gesture is inside its dead-zone."""
        for i in self.bound:  # noqa: SIM110  (a generator takes three times as long)
            if activation[i]:
                return False
        return True
