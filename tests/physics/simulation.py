"""A wheelchair in MuJoCo that is driven by twists, 10 ms at a time."""

import math
from typing import Any, Final

import mujoco
import numpy as np
from numpy.typing import NDArray
from physics.chair_model import COLUMNS, LOADS, SIDES, TIME_STEP, Floor, PhysicalChair, mjcf

from app.geometry import STANDSTILL, Twist

STEP: Final = 0.01  # s, of the receiver
SUBSTEPS: Final = round(STEP / TIME_STEP)
SETTLING: Final = 1.5  # s until the tyres and the person carry their loads
BRAKE_SPEED: Final = 0.03  # m/s of a wheel, below which the parking brakes may close
TIPPED: Final = math.cos(math.radians(45.0))

Numbers = NDArray[np.float64]


class Simulation:
    """One chair on one floor; it stands with closed brakes, and has settled.

    Attributes
    ----------
    rest : (4,) N, the loads of the wheels at rest on this floor, in the order of WHEELS
    """

    def __init__(self, chair: PhysicalChair, floor: Floor) -> None:
        self.chair = chair
        self.model: Any = mujoco.MjModel.from_xml_string(mjcf(chair, floor))
        self.data: Any = mujoco.MjData(self.model)
        joints = [mujoco.mj_name2id(self.model, mujoco.mjtObj.mjOBJ_JOINT, name) for name in SIDES]
        self._dofs = [int(self.model.jnt_dofadr[joint]) for joint in joints]
        self._neutral = math.inf  # s for which the chair has been at rest and in neutral
        self._steps = 0
        self._samples: list[Numbers] = []
        for _ in range(round(SETTLING / STEP)):
            self.advance(STANDSTILL)
        self.rest: Numbers = self._samples[-1][LOADS]
        self._samples.clear()

    @property
    def samples(self) -> Numbers:
        """All samples since the chair has settled, (n, SAMPLE_WIDTH) at 1 kHz."""
        return np.array(self._samples)

    @property
    def is_tipped(self) -> bool:
        """Whether the chair leans by more than 45 degrees to its floor: from there on the model says nothing."""
        return bool(self._samples[-1][COLUMNS["up"]][2] < TIPPED)

    def advance(self, twist: Twist) -> None:
        """Drive `twist` for 10 ms.

        Raises
        ------
        RuntimeError
            When the simulation became unstable: MuJoCo then begins anew at time 0.
        """
        self._set_brakes(twist)
        radius, half = self.chair.wheel_radius, twist.omega * self.chair.track / 2
        self.data.ctrl[:] = ((twist.v - half) / radius, (twist.v + half) / radius)
        for _ in range(SUBSTEPS):
            mujoco.mj_step(self.model, self.data)
            self._samples.append(np.array(self.data.sensordata, dtype=np.float64))
        self._steps += SUBSTEPS
        if not math.isclose(self.data.time, self._steps * TIME_STEP, abs_tol=TIME_STEP / 2):
            raise RuntimeError(f"the simulation became unstable after {self._steps * TIME_STEP:.2f} s")

    def _set_brakes(self, twist: Twist) -> None:
        """Close the parking brakes once the chair has been at rest in neutral; a command to move opens them at once.

        A closed brake is dry friction at the wheel. The motors go on holding the speed 0 as well as they can.
        """
        speeds = np.abs(self.data.qvel[self._dofs]) * self.chair.wheel_radius
        is_neutral = twist == STANDSTILL and speeds.max() < BRAKE_SPEED
        self._neutral = self._neutral + STEP if is_neutral else 0.0
        closed = self._neutral >= self.chair.brake_delay
        self.model.dof_frictionloss[self._dofs] = self.chair.brake_torque if closed else self.chair.gear_friction
