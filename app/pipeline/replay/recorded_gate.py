"""The gate of a recorded drive: its decisions are read from the recording, its limits are those of the loop's gate."""

from app.faults import State
from app.pipeline.safety_gate import BadGestures, Conditions, SafetyGate


class RecordedGate(SafetyGate):
    """Limits the twist as the gate does, and permits motion where the recording says that it was permitted."""

    recorded = State.DISARMED

    def decide(
        self, t: float, pause: float, neutral: bool, bad: BadGestures, frame_age: float, conditions: Conditions
    ) -> State:
        """Return the recorded decision of this tick; the arguments do not matter."""
        del t, pause, neutral, bad, frame_age, conditions
        if self.state is not self.recorded:
            self._withdraw(self.recorded)
        return self.state
