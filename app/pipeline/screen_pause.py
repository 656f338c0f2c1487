"""The pause of the virtual chair while the screen that drives it does not report in time (S7).

A slow picture pauses the virtual chair in place of stopping it, because nobody sits in it: nobody has to take a stop
back. The pause does not apply to a real chair, and clears no fault. It disarms the gate, and arms it again, which
begins a neutral check.
"""

# Compiled in a wheel (hatch_build.py).

import math
from typing import Final

from app.faults import Fault, State
from app.pipeline.safety_gate import SCREEN_SILENT, WEB_SILENT, Conditions, SafetyGate

PUNCTUAL: Final = 1.0  # s of reports in time after which a pause ends


class ScreenPause:
    """Pauses and resumes an armed drive of the virtual chair.

    Attributes
    ----------
    reason : Fault
        Why the drive is paused; NONE while it is not.
    """

    def __init__(self) -> None:
        self.reason = Fault.NONE
        self._punctual_since = math.inf

    def end(self) -> None:
        """Forget the pause: a person has ended, stopped or disarmed the drive, or a real chair is driven."""
        self.reason = Fault.NONE

    def decide(self, t: float, gate: SafetyGate, conditions: Conditions) -> bool:
        """Pause the drive at `t` (s) when the screen is late; return whether it is to be armed again.

        The screen's part of `conditions` is replaced by a good one: what the pause has answered is no fault any more.
        """
        late = _late(conditions)
        web_age, conditions.screen_age, conditions.screen = conditions.supervisor_age, 0.0, Fault.NONE
        if gate.state is State.CHECKING or gate.state is State.ARMED:
            self.reason = late
            if late is not Fault.NONE:
                gate.disarm()
                self._punctual_since = math.inf
            return False
        if self.reason is Fault.NONE or gate.state is State.FAULT:
            self.reason = Fault.NONE
            return False
        if not web_age <= WEB_SILENT:
            gate.stop(Fault.WEB_SILENT)  # the gate itself looks only while motion is permitted
            self.reason = Fault.NONE
            return False
        if late is not Fault.NONE:
            self.reason, self._punctual_since = late, math.inf
            return False
        self._punctual_since = min(self._punctual_since, t)
        if t - self._punctual_since < PUNCTUAL:
            return False
        self.reason = Fault.NONE
        return True


def _late(conditions: Conditions) -> Fault:
    """Return what is wrong with the screen, as the gate says it; NONE when it reports in time."""
    # The comparison is written so that a NaN leads to the fault.
    return conditions.screen if conditions.screen_age <= SCREEN_SILENT else Fault.SCREEN_LOST
