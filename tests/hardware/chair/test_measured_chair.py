"""An emulated chair with a joystick is measured by a guided drive and a tape measure, and then does what is asked."""

import json
import math
import random
from pathlib import Path

import pytest

from app.geometry import Twist
from app.hardware.chair.chair_document import table_of
from app.hardware.chair.joystick_drive import DONE, SHORTEST_DISTANCE, SMALLEST_TURN, DrivePhase, GuidedDrive
from app.hardware.chair.readings import NO_READINGS

STEP = 0.05  # s
MARKS = 6.0  # s between the person's two marks
MOST = Twist(0.5, 0.8)
# From which speeds on the chair is how near to the speed that is asked for, as a share of that.
NEAR = ((Twist(0.15, 0.3), 0.05), (Twist(0.1, 0.2), 0.1))


class JoystickChair:
    """A chair whose speed grows with the deflection as makers let it: none in a dead band, then more and more."""

    def __init__(self, rng):
        self.dead_band, self.power = rng.uniform(0.0, 12.0), rng.uniform(1.0, 1.5)
        self.fastest = Twist(rng.uniform(0.8, 2.5), rng.uniform(1.0, 4.0))

    def twist(self, ahead, right):
        return Twist(self.fastest.v * self._share(ahead), -self.fastest.omega * self._share(right))

    def _share(self, percent):
        above = max(0.0, abs(percent) - self.dead_band) / (100.0 - self.dead_band)
        return math.copysign(above**self.power, percent)


def measured(chair):
    """Return the document that a guided drive makes of a chair, measured in whole centimetres or degrees."""
    drive, t = GuidedDrive(MOST), 0.0

    def run(seconds):
        nonlocal t
        for _ in range(round(seconds / STEP)):
            t += STEP
            deflection = drive.step(t, NO_READINGS)
        return deflection

    run(STEP)
    while drive.phase is not DrivePhase.ENDED:
        drive.hear("\n")
        _, ahead, right = run(2.0)
        drive.hear(" ")
        twist = chair.twist(ahead, right)
        turned, way = math.degrees(abs(twist.omega)) * MARKS, abs(twist.v) * MARKS
        moved = f"{turned:.0f}" if turned >= SMALLEST_TURN else f"{way:.2f}" if way >= SHORTEST_DISTANCE else "0"
        drive.told.clear()
        drive.hear("0" if moved == "0" else f"{moved} {MARKS:g}")
        if any("not faster" in sentence for sentence in drive.told):
            drive.hear(DONE)
        run(STEP)
    return drive.document


@pytest.mark.parametrize("seed", range(20))
def test_after_the_guided_drive_the_chair_is_as_fast_as_it_is_asked_to_be(seed):
    rng = random.Random(seed)
    chair = JoystickChair(rng)
    table = table_of(json.dumps(measured(chair)), Path("chair.json"))
    for least, near in NEAR:
        assert table.most.v > least.v
        assert table.most.omega > least.omega
        for _ in range(200):
            v, omega = rng.uniform(least.v, table.most.v), rng.uniform(least.omega, table.most.omega)
            assert chair.twist(*table.deflection(Twist(v, 0.0))).v == pytest.approx(v, rel=near)
            assert chair.twist(*table.deflection(Twist(0.0, -omega))).omega == pytest.approx(-omega, rel=near)
