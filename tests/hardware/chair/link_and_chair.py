"""A chair link, tick by tick on a simulated time, and a chair that notes what comes."""

import itertools

from hardware.chair.chair_stand_in import ARMED, DISARMED, StandInChair

from app.faults import State
from app.geometry import STANDSTILL, Twist
from app.hardware.chair.link import ChairLink
from app.speed_limits import Speeds

LIMITS = Speeds(forward=0.5, reverse=0.2, turn=1.0)
AHEAD = Twist(0.25, -0.5)


class LinkAndChair:
    """A chair link, its chair, and the time of both."""

    def __init__(self, folder):
        self.chair = StandInChair(folder)
        self.link = ChairLink(self.chair.config)
        self.link.open()
        self.t = 100.0

    def turn(self, state, twist=STANDSTILL, dt=0.005):
        """Make one turn of a loop; return the commands that came."""
        self.t += dt
        self.link.listen(self.t)
        self.link.drive(twist, dt)
        self.link.send(state, LIMITS, self.t)
        return self.chair.commands()

    def during(self, seconds, state, twist=STANDSTILL, dt=0.005):
        return list(itertools.chain.from_iterable(self.turn(state, twist, dt) for _ in range(round(seconds / dt))))

    def hear(self, state=DISARMED, epoch=0, sequence=0, **changes):
        self.chair.say(state, epoch, sequence, **changes)
        self.link.listen(self.t)

    def meet(self):
        self.turn(State.DISARMED)
        self.hear()

    def check(self):
        """Begin the neutral check, and return its first command."""
        return self.turn(State.CHECKING)[0]

    def arm(self):
        """Arm both sides, and return the arming's epoch."""
        self.meet()
        first = self.check()
        last = self.during(0.1, State.CHECKING)[-1]
        self.hear(ARMED, first.epoch, last.sequence)
        assert self.link.telemetry.ready
        return first.epoch

    def close(self):
        self.link.close()
        self.chair.close()
