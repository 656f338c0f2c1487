"""A rehearsal without a chair: a real receiver's process, the chair link, and an emulated far end."""

import signal
import subprocess
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory

from app.child_process import command
from app.clock import Clock
from app.faults import State
from app.geometry import STANDSTILL, Twist
from app.hardware.base import HardwareError
from app.hardware.chair.link import ChairLink
from app.hardware.chair.packet import Telemetry
from app.hardware.chair.receiver import ReceiverState
from app.hardware.chair.rehearsal import RehearsalStep, StepResult, judged
from app.hardware.chair.whill_emulator import EmulatedWhillLine
from app.hardware.configs import RealChairConfig
from app.speed_limits import FIRST_CHAIR_SPEEDS
from app.texts import Text

HOST = "127.0.0.1"
STEP = 0.005  # s
DRIVEN = Twist(0.3, 0.0)
STANDS = 0.01  # m/s
PATIENCE = 1.0  # s beyond the limit of a step for which it is still measured
REST = 0.4  # s without an arming before the next
PREPARATION = 5.0  # s to arm and drive before a step
TREAD = "0.5"  # m, of the emulated chair


class Rehearsal:
    """A receiver's process with its chair link; `close` ends all."""

    def __init__(self, key_file: Path, output: str, clock: Clock) -> None:
        """Start all; raise HardwareError when the receiver or the link does not start."""
        self._clock = clock
        self._folder = TemporaryDirectory(prefix="bodydrive-rehearsal-")
        self._switch = Path(self._folder.name) / "switch"
        self._press(False)
        self._whill = EmulatedWhillLine() if output == "whill" else None
        options = ["--key-file", str(key_file), "--output", output, "--port", "0", "--stop-input", str(self._switch)]
        if self._whill is not None:
            options += ["--device", self._whill.device, "--tread", TREAD, "--backward-motor", "right"]
        self._process = subprocess.Popen(
            command("app.hardware.chair.receive", *options),
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
        )
        self._link: ChairLink | None = None
        try:
            said = self._process.stderr.readline().strip() if self._process.stderr else ""
            port = said.rpartition(":")[2]
            if not (said.startswith("listening on ") and port.isdecimal()):
                raise HardwareError(Text("cli-rehearsal-no-receiver", reason=said))
            config = {"kind": "udp", "name": output, "host": HOST, "port": int(port), "key_file": str(key_file)}
            link = ChairLink(RealChairConfig.model_validate({**config, "speeds": FIRST_CHAIR_SPEEDS.model_dump()}))
            link.open()
            self._link = link
        except BaseException:
            self.close()
            raise

    def run(self, step: RehearsalStep) -> StepResult:
        """Do a step, and return what happened."""
        actions: dict[str, Callable[[float], float | None]] = {
            "paired": lambda limit: self._until(lambda: self._newest is not None, limit, State.DISARMED),
            "armed": lambda limit: self._until(lambda: self._chair.ready, limit, State.CHECKING),
            "driven": lambda limit: self._until(self._drives, limit, State.ARMED, DRIVEN),
            "stopped": lambda limit: self._until(self._stands, limit, State.FAULT),
            "switch": self._press_switch,
            "silence": self._fall_silent,
            "hand": self._move_joystick,
            "cable": self._pull_cable,
            "plugged": self._plug_in,
            "killed": self._kill,
        }
        return judged(step, actions[step.name](step.limit / 1000 + PATIENCE))

    def close(self) -> None:
        """End the receiver, and remove all that was made."""
        if self._link is not None:
            self._link.close()
        self._process.kill()
        self._process.wait()
        if self._process.stderr is not None:
            self._process.stderr.close()
        if self._whill is not None:
            self._whill.close()
        self._folder.cleanup()

    @property
    def _chair(self) -> ChairLink:
        if self._link is None:
            raise RuntimeError("the rehearsal was closed")
        return self._link

    @property
    def _newest(self) -> Telemetry | None:
        return self._chair.telemetry.newest

    @property
    def _speed(self) -> float:
        """The speed of the emulated wheels, m/s; of `sim` as its receiver measures it."""
        if self._whill is not None:
            return self._whill.v
        return self._newest.measured_v if self._newest is not None else 0.0

    def _drives(self) -> bool:
        return self._speed >= 0.9 * DRIVEN.v

    def _stands(self) -> bool:
        return abs(self._speed) <= STANDS

    def _until(
        self,
        condition: Callable[[], bool],
        limit: float,
        state: State,
        twist: Twist = STANDSTILL,
        *,
        sends: bool = True,
    ) -> float | None:
        """Return after how many seconds a condition holds; None when it does not within `limit` (s)."""
        begun = self._clock.now()
        while (t := self._clock.now()) - begun <= limit:
            self._chair.listen(t)
            if condition():
                return t - begun
            self._chair.drive(twist, STEP)
            if sends:
                self._chair.send(state, FIRST_CHAIR_SPEEDS, t)
            self._clock.sleep_until(t + STEP)
        return None

    def _is_prepared(self) -> bool:
        """Arm anew, and drive; return whether the chair does."""
        self._until(lambda: False, REST, State.DISARMED)
        return (
            self._until(lambda: self._chair.ready, PREPARATION, State.CHECKING) is not None
            and self._until(self._drives, PREPARATION, State.ARMED, DRIVEN) is not None
        )

    def _press(self, pressed: bool) -> None:
        new = self._switch.with_suffix(".new")
        new.write_text("1" if pressed else "0", encoding="ascii")
        new.replace(self._switch)

    def _press_switch(self, limit: float) -> float | None:
        if not self._is_prepared():
            return None
        self._press(True)
        took = self._until(self._stands, limit, State.ARMED, DRIVEN)
        self._press(False)
        return took

    def _fall_silent(self, limit: float) -> float | None:
        return self._until(self._stands, limit, State.ARMED, DRIVEN, sends=False) if self._is_prepared() else None

    def _move_joystick(self, limit: float) -> float | None:
        if self._whill is None or not self._is_prepared():
            return None
        self._whill.joystick = (40, 0)
        took = self._until(self._stands, limit, State.ARMED, DRIVEN)
        self._whill.joystick = (0, 0)
        return took

    def _pull_cable(self, limit: float) -> float | None:
        if self._whill is None or not self._is_prepared():
            return None
        self._whill.unplugged = True
        return self._until(self._is_in_fault, limit, State.ARMED, DRIVEN)

    def _is_in_fault(self) -> bool:
        return self._newest is not None and self._newest.state == ReceiverState.FAULT and self._newest.v == 0.0

    def _plug_in(self, limit: float) -> float | None:
        if self._whill is None:
            return None
        self._whill.unplugged = False
        return self._until(self._is_let_go, limit, State.DISARMED)

    def _is_let_go(self) -> bool:
        return self._stands() and self._newest is not None and self._newest.state == ReceiverState.DISARMED

    def _kill(self, limit: float) -> float | None:
        if not self._is_prepared():
            return None
        self._process.send_signal(signal.SIGKILL)
        return self._until(lambda: self._chair.silent, limit, State.ARMED, DRIVEN)
