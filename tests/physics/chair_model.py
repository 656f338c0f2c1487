"""A powered wheelchair with a person in it as MJCF, the text that MuJoCo reads.

x ahead, y left, z away from the floor; SI units. The origin lies on the floor, below the middle of the driven axle. The
floor is the plane z = 0 in every model: a slope tilts gravity. Each wheel touches the floor as a sphere, at one point,
with friction against twisting for the width of its tyre. Only wheels touch anything: the model has no anti-tip wheels.
"""

import math
from dataclasses import dataclass
from typing import Final

from app.hardware.chair.outputs import SimulatedDrive
from app.world.dynamics import Wheelchair

Vector = tuple[float, float, float]

TIME_STEP: Final = 0.001  # s
GRAVITY: Final = 9.81  # m/s2
SIDES: Final = {"left": 1.0, "right": -1.0}  # the driven wheels, and the sign of their y
WHEELS: Final = ("left", "right", "left_castor", "right_castor")
BUILT_IN: Final = Wheelchair()
FRICTIONS, MOTOR_LAGS = (0.4, 0.9), (0.08, 0.2)  # s; the ranges from which a random drive draws

# Shares of a person's mass and stature: head, arms and trunk as one, from hip to shoulder. D. A. Winter, Biomechanics
# and Motor Control of Human Movement, 4th edition (2009), table 4.1 and figure 4.1.
TRUNK_MASS, TRUNK_LENGTH, TRUNK_CENTRE, TRUNK_GYRATION = 0.678, 0.288, 0.626, 0.496
LEGS_AHEAD, LEGS_BELOW = 0.28, 0.1  # m from the hip to the centre of both seated legs, by the same tables
SHOULDERS: Final = 0.13  # m, radius of gyration of the trunk about its length

# Choices for which no chair was measured.
WHEEL_MASS, FORK_MASS, CASTOR_MASS = 5.0, 1.0, 1.5  # kg, each
SWIVEL_FRICTION, SWIVEL_DAMPING = 0.2, 0.02  # Nm, Nm s/rad
TWIST_FRICTION: Final = 0.002  # m: times a wheel's load, the torque against its twisting on the floor while it rolls
CHEST: Final = 0.72  # of the length from hip to shoulder, where the person is measured


@dataclass(frozen=True, slots=True)
class PhysicalChair:
    """Masses, lengths and motors of a rear-wheel driven chair and its person; the defaults are one plausible chair.

    Wheel base, castors and trail are those of `app.world.dynamics`, the track that of the simulated drive: the models
    differ in their physics and not in their size. Powered chairs weigh up to 115 kg (Characteristics of Emerging Road
    and Trail Users and Their Safety, Federal Highway Administration, 2004). What holds the chair where it stands are
    its parking brakes, which close by themselves in neutral; makers' manuals say so, one of them "within two seconds".
    """

    chair_mass: float = 110.0  # kg
    person_mass: float = 80.0  # kg
    stature: float = 1.75  # m
    track: float = SimulatedDrive.WHEEL_DISTANCE  # m between the driven wheels
    wheel_radius: float = 0.178  # m: 14 inches across
    castor_radius: float = 0.102  # m: 8 inches across
    wheelbase: float = BUILT_IN.wheelbase  # m from the driven axle to the castors' stems
    stems: float = BUILT_IN.track  # m between the stems
    trail: float = BUILT_IN.trail  # m
    frame_ahead: float = 0.15  # m from the axle to the centre of frame and batteries
    frame_height: float = 0.30  # m
    hip_ahead: float = 0.10  # m from the axle
    hip_height: float = 0.60  # m
    recline: float = math.radians(10.0)
    pitch_frequency: float = 3.5  # Hz of the belted trunk, forwards and backwards
    roll_frequency: float = 1.5  # Hz, sideways
    trunk_damping: float = 0.3  # of the critical damping
    motor_lag: float = 0.14  # s until a wheel's set speed has followed 63 % of a change
    speed_loop: float = 0.01  # s in which a wheel reaches its set speed, as far as its torque goes
    tyre_stiffness: float = 1e5  # N/m of each tyre with its part of the frame: 6 mm under 60 kg
    tyre_damping: float = 600.0  # N s/m
    largest_torque: float = 80.0  # Nm at each driven wheel
    rotor_inertia: float = 0.2  # kg m2, as felt at the wheel behind its gear
    gear_friction: float = 0.5  # Nm
    brake_torque: float = 100.0  # Nm of a closed parking brake
    brake_delay: float = 0.2  # s at rest and in neutral until the brakes close


@dataclass(frozen=True, slots=True)
class Floor:
    """What the chair stands on at the start, heading along x."""

    friction: float = 0.7
    slope: float = 0.0  # rad
    uphill: float = 0.0  # rad from ahead, counter-clockwise: where the slope rises; pi: the chair heads downhill
    kerb: float = 0.0  # m, height of a step up across the way; 0: none
    kerb_ahead: float = 1.0  # m from the axle to the kerb

    @property
    def gravity(self) -> Vector:
        """Gravity in the frame of the floor, m/s2."""
        along = -GRAVITY * math.sin(self.slope)
        return along * math.cos(self.uphill), along * math.sin(self.uphill), -GRAVITY * math.cos(self.slope)


_OF_CHAIR = 'objtype="xbody" objname="chair"'
SENSORS: Final = {
    "place": ("framepos", _OF_CHAIR, 3),  # m
    "ahead": ("framexaxis", _OF_CHAIR, 3),
    "up": ("framezaxis", _OF_CHAIR, 3),
    "axle": ("velocimeter", 'site="axle"', 3),  # m/s in the chair's own directions
    "turn": ("gyro", 'site="axle"', 3),  # rad/s
    "chest": ("framelinvel", 'objtype="site" objname="chest"', 3),  # m/s
    **{f"load_{name}": ("touch", f'site="{name}"', 1) for name in WHEELS},  # N
}
"""Name of a sensor: its element, what it is attached to, how many numbers it gives."""


def _columns() -> dict[str, slice]:
    found: dict[str, slice] = {}
    first = 0
    for name, (_, _, width) in SENSORS.items():
        found[name] = slice(first, first + width)
        first += width
    return found


COLUMNS: Final = _columns()
"""Where each sensor stands in a sample, `MjData.sensordata`."""
LOADS: Final = slice(COLUMNS["load_left"].start, COLUMNS["load_right_castor"].stop)
SAMPLE_WIDTH: Final = LOADS.stop


def mjcf(chair: PhysicalChair, floor: Floor) -> str:
    """Return the model of a chair on a floor, as `mujoco.MjModel.from_xml_string` takes it.

    A high `impratio` keeps a standing wheel from creeping down a slope.
    """
    frame = chair.chair_mass - 2 * (WHEEL_MASS + FORK_MASS + CASTOR_MASS)
    speed_gain = (chair.chair_mass + chair.person_mass) / 2 * chair.wheel_radius**2 / chair.speed_loop
    motor = (
        f'dyntype="filterexact" dynprm="{_text(chair.motor_lag)}" gaintype="fixed" gainprm="{_text(speed_gain)}" '
        f'biastype="affine" biasprm="{_text(0, 0, -speed_gain)}" '
        f'forcerange="{_text(-chair.largest_torque, chair.largest_torque)}"'
    )
    sensors = [f'<{element} name="{name}" {of}/>' for name, (element, of, _) in SENSORS.items()]
    lines = [
        '<mujoco model="wheelchair"><compiler angle="radian"/>',
        f'<option timestep="{TIME_STEP}" gravity="{_text(*floor.gravity)}" integrator="implicitfast" cone="elliptic" '
        'impratio="10"/>',
        '<default><joint solreffriction="0.004 1" solimpfriction="0.99 0.99 0.001 0.5 2"/></default>',
        "<worldbody>",
        f'<geom name="floor" type="plane" size="0 0 1" {_surface(floor)}/>',
        _kerb(floor),
        '<body name="chair"><freejoint/>',
        _inertial(frame, (chair.frame_ahead, 0.0, chair.frame_height), _box(frame, 0.8, 0.5, 0.35)),
        f'<site name="axle" pos="{_text(0, 0, chair.wheel_radius)}"/>',
        *(_driven_wheel(chair, name, side) for name, side in SIDES.items()),
        *(_castor(chair, f"{name}_castor", side) for name, side in SIDES.items()),
        _person(chair),
        "</body></worldbody><actuator>",
        *(f'<general name="{name}" joint="{name}" {motor}/>' for name in SIDES),
        "</actuator><sensor>",
        *sensors,
        "</sensor></mujoco>",
    ]
    return "\n".join(lines)


def _surface(floor: Floor) -> str:
    """The floor's own friction counts, whatever a wheel's is."""
    friction = _text(floor.friction, TWIST_FRICTION, 0.0)
    return f'contype="1" conaffinity="0" priority="1" condim="4" friction="{friction}"'


def _kerb(floor: Floor) -> str:
    """A step up over the whole width, long enough for every drive to end on it."""
    if not floor.kerb:
        return ""
    place = _text(floor.kerb_ahead + 10.0, 0.0, floor.kerb - 0.1)
    return f'<geom name="kerb" type="box" size="10 10 0.1" pos="{place}" {_surface(floor)}/>'


def _driven_wheel(chair: PhysicalChair, name: str, side: float) -> str:
    place = _text(0.0, side * chair.track / 2, chair.wheel_radius)
    return (
        f'<body name="{name}" pos="{place}">{_tyre(chair)}<joint name="{name}" axis="0 1 0" '
        f'armature="{_text(chair.rotor_inertia)}" frictionloss="{_text(chair.gear_friction)}"/>'
        f"{_wheel(name, WHEEL_MASS, chair.wheel_radius)}</body>"
    )


def _castor(chair: PhysicalChair, name: str, side: float) -> str:
    """A fork that turns about its stem, and its wheel, which trails behind."""
    place = _text(chair.wheelbase, side * chair.stems / 2, chair.castor_radius)
    return (
        f'<body name="{name}_fork" pos="{place}">{_tyre(chair)}<joint name="{name}_swivel" axis="0 0 1" '
        f'frictionloss="{_text(SWIVEL_FRICTION)}" damping="{_text(SWIVEL_DAMPING)}"/>'
        f"{_inertial(FORK_MASS, (-chair.trail / 2, 0.0, chair.castor_radius), _box(FORK_MASS, 0.1, 0.06, 0.2))}"
        f'<body name="{name}" pos="{_text(-chair.trail, 0.0, 0.0)}"><joint name="{name}" axis="0 1 0" damping="0.01"/>'
        f"{_wheel(name, CASTOR_MASS, chair.castor_radius)}</body></body>"
    )


def _tyre(chair: PhysicalChair) -> str:
    """What gives between floor and seat: without it, one of four wheels hardly touches the floor."""
    return (
        f'<joint type="slide" axis="0 0 1" stiffness="{_text(chair.tyre_stiffness)}" '
        f'damping="{_text(chair.tyre_damping)}"/>'
    )


def _wheel(name: str, mass: float, radius: float) -> str:
    """A disc that touches the floor as a sphere; the site around it measures its load."""
    across = mass * radius**2 / 4
    return (
        f"{_inertial(mass, (0.0, 0.0, 0.0), (across, 2 * across, across))}"
        f'<geom type="sphere" size="{_text(radius)}" contype="0" conaffinity="1"/>'
        f'<site name="{name}" size="{_text(1.2 * radius)}"/>'
    )


def _person(chair: PhysicalChair) -> str:
    """Legs that are fixed to the seat, and a trunk on springs at the hip: back support and belt."""
    trunk, length = TRUNK_MASS * chair.person_mass, TRUNK_LENGTH * chair.stature
    legs, centre = chair.person_mass - trunk, TRUNK_CENTRE * length
    about_centre = trunk * (TRUNK_GYRATION * length) ** 2
    about_hip = about_centre + trunk * centre**2

    def sway(name: str, axis: str, frequency: float) -> str:
        rate = math.tau * frequency
        stiffness = about_hip * rate**2 + trunk * GRAVITY * centre  # the second part carries the trunk's weight
        damping = 2 * chair.trunk_damping * about_hip * rate
        return f'<joint name="{name}" axis="{axis}" stiffness="{_text(stiffness)}" damping="{_text(damping)}"/>'

    def along(distance: float) -> Vector:
        return -distance * math.sin(chair.recline), 0.0, distance * math.cos(chair.recline)

    return (
        f'<body name="person" pos="{_text(chair.hip_ahead, 0.0, chair.hip_height)}">'
        f"{_inertial(legs, (LEGS_AHEAD, 0.0, -LEGS_BELOW), _box(legs, 0.6, 0.35, 0.4))}"
        '<body name="trunk">'
        f"{sway('pitch', '0 1 0', chair.pitch_frequency)}{sway('roll', '1 0 0', chair.roll_frequency)}"
        f"{_inertial(trunk, along(centre), (about_centre, about_centre, trunk * SHOULDERS**2))}"
        f'<site name="chest" pos="{_text(*along(CHEST * length))}"/></body></body>'
    )


def _inertial(mass: float, place: Vector, moments: Vector) -> str:
    return f'<inertial mass="{_text(mass)}" pos="{_text(*place)}" diaginertia="{_text(*moments)}"/>'


def _box(mass: float, x: float, y: float, z: float) -> Vector:
    """Return the moments of inertia of a box of these lengths."""
    return mass * (y * y + z * z) / 12, mass * (x * x + z * z) / 12, mass * (x * x + y * y) / 12


def _text(*numbers: float) -> str:
    return " ".join(f"{number:.9g}" for number in numbers)
