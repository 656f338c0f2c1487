"""What is connected and loaded: shirt, body, parameters, world; and the chain made of them."""

from typing import Protocol, cast

from app.calibration.vocabulary import DriveParameters
from app.clock import Clock
from app.faults import State
from app.geometry import STANDSTILL, Pose
from app.hardware.base import Body, BodyView, Shirt
from app.hardware.chair.simulator import VirtualChair
from app.hardware.configs import BodyConfig, ShirtConfig
from app.hardware.registry import make_body, make_shirt
from app.pipeline.chain import Chain
from app.world.floorplan import FloorPlan, PrescribedPath

ORIGIN = Pose(0.0, 0.0, 0.0)
IDLE_RATE = 50.0  # Hz: how often the loop turns while there is no shirt


class Refused(Exception):  # noqa: N818
    """Why a command is not done, in one sentence."""


class DressedShirt(Protocol):
    """What the simulated shirt has beyond others: somebody inside who sees."""

    view: BodyView
    body: Body | None


class Setup:
    """Changes one part at a time; nothing changes while the chair may move."""

    def __init__(self, clock: Clock) -> None:
        self._clock = clock
        self.shirt: Shirt | None = None
        self.shirt_kind = ""
        self.dressed: DressedShirt | None = None  # the same shirt, when it is the simulated one
        self.parameters: DriveParameters | None = None
        self.hash: str | None = None
        self.floorplan: FloorPlan | None = None
        self.path: PrescribedPath | None = None
        self.chair = VirtualChair(None, ORIGIN)
        self.chain = Chain(IDLE_RATE, None, self.chair)

    @property
    def sample_rate(self) -> float:
        """Frames per second (Hz) that the shirt promises; the loop's own pace without a shirt."""
        return self.shirt.sample_rate if self.shirt else IDLE_RATE

    @property
    def shirt_words(self) -> str:
        """The shirt's state in words."""
        return self.shirt.words() if self.shirt else "No shirt is connected: choose one on the Shirt page."

    @property
    def stands(self) -> bool:
        """Whether the chair is commanded to stand."""
        return self.chain.gate.last == STANDSTILL

    def require_still(self) -> None:
        """Raise Refused while the chair moves or may move."""
        if self.chain.gate.state in (State.ARMED, State.CHECKING) or not self.stands:
            raise Refused("The chair is armed: end the drive first.")

    def use_shirt(self, config: ShirtConfig) -> None:
        """Close the shirt in use and open this one; raise HardwareError, with no shirt open, when it cannot be had."""
        self.require_still()
        self.close_shirt()
        shirt = make_shirt(config, self._clock)
        try:
            shirt.open()
        except Exception:
            shirt.close()
            raise
        self.shirt, self.shirt_kind = shirt, config.kind
        self.dressed = cast(DressedShirt, shirt) if config.kind == "simulator" else None
        if self.parameters is not None and not self._fits(self.parameters):
            self.parameters = self.hash = None
        self._link_chain()

    def close_shirt(self) -> None:
        """Do without a shirt."""
        if self.shirt is not None:
            self.shirt.close()
        self.shirt = self.dressed = None
        self.shirt_kind = ""
        self._link_chain()

    def use_body(self, config: BodyConfig) -> None:
        """Let somebody else into the simulated shirt; raise HardwareError when the body cannot be had."""
        if self.dressed is None:
            raise Refused("Only the simulated shirt has a body to choose: choose the simulated shirt first.")
        self.dressed.body = make_body(config)
        self._show_path()

    def use_parameters(self, parameters: DriveParameters | None) -> None:
        """Drive with these from now on."""
        self.require_still()
        if parameters is not None and not self._fits(parameters):
            raise Refused("These controls were made for a shirt with other channels: calibrate with this shirt.")
        self.parameters = parameters
        self.hash = parameters.hash if parameters else None
        self._link_chain()

    def use_world(self, floorplan: FloorPlan | None, path: str | None) -> None:
        """Put the virtual chair on the start of a path, or on an endless floor."""
        self.require_still()
        chosen = None
        if floorplan is not None:
            try:
                chosen = floorplan.path_named(path) if path else floorplan.paths[0]
                chair = VirtualChair(floorplan, chosen.start)
            except ValueError as error:
                raise Refused(f"{error}.") from error
        else:
            chair = VirtualChair(None, ORIGIN)
        self.floorplan, self.path, self.chair = floorplan, chosen, chair
        self.chain.chair = chair
        self._show_path()

    def to_start(self) -> None:
        """Put the virtual chair on the start."""
        self.chair.place(self.path.start if self.path else ORIGIN)

    def _fits(self, parameters: DriveParameters) -> bool:
        """Return whether the frames of the shirt are what these parameters were made for."""
        return self.shirt is None or self.shirt.layout.channel_names == parameters.profile.layout.channel_names

    def _link_chain(self) -> None:
        """Make a new chain; a latched fault is carried over."""
        fault = self.chain.gate.fault if self.chain.gate.state is State.FAULT else None
        fitting = self.parameters if self.shirt is not None else None
        self.chain = Chain(self.sample_rate, fitting, self.chair)
        if fault is not None:
            self.chain.gate.stop(fault)

    def _show_path(self) -> None:
        """Let a body that drives by himself see the path."""
        show = getattr(self.dressed.body, "set_path", None) if self.dressed else None
        if show is not None and self.path is not None:
            show(self.path.points)
