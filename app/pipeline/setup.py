"""What is connected and loaded (shirt, body, head tracker, chair, limits, parameters, world), and their chain."""

import math
from typing import Protocol, cast

from app.arrivals import Arrivals
from app.calibration.vocabulary import DriveParameters, arming_hash
from app.clock import Clock
from app.faults import State
from app.geometry import STANDSTILL, wrap_angle
from app.hardware.base import (
    ORIGIN,
    Body,
    BodyView,
    Chair,
    DrivingBody,
    HeadTracker,
    LinkedChair,
    NetworkShirt,
    PageShirt,
    ReportingShirt,
    SearchingShirt,
    Shirt,
)
from app.hardware.chair.packet import DIGEST_BYTES
from app.hardware.chair.simulator import Dynamics, VirtualChair
from app.hardware.configs import SHIRTS, BodyConfig, ChairConfig, HeadConfig, RealChairConfig
from app.hardware.registry import make_body, make_head, make_real_chair, make_shirt
from app.hardware.shirt.kind import ShirtConfig
from app.json_values import JsonDocument
from app.messages import IDLE_RATE, HeadPose, Tick
from app.pipeline.chain import Chain
from app.pipeline.opening import DeviceChange, close_meanwhile, close_quietly, message_of, open_device
from app.source import UNKNOWN, Source
from app.speed_limits import HIGHEST_SPEEDS, Speeds
from app.texts import Text, text_of
from app.world.floorplan import FloorPlan, PrescribedPath
from app.world.movers import Track
from app.world.progress import leader_of

NO_SHIRT = Text("drives-no-shirt")
NO_TRACKER = Text("drives-no-tracker")


class HeadTracking:
    """The head tracker in use: its newest pose goes into every tick; the loop never waits for it or ends by it."""

    def __init__(self, clock: Clock) -> None:
        self._clock = clock
        self._tracker: HeadTracker | None = None
        self._ahead = (0.0, 0.0, 0.0)  # yaw, pitch, roll (rad) of the pose that counts as straight ahead
        self._failed: Text | None = None
        self.kind = ""

    @property
    def description(self) -> Text:
        """The tracker's state in words."""
        return self._failed or (self._tracker.description() if self._tracker else NO_TRACKER)

    def change(self, config: HeadConfig | None) -> DeviceChange:
        """Release the head tracker in use, and return the change that opens another one."""
        before = self._release_tracker()

        def opened() -> HeadTracker | None:
            close_quietly(before)
            return None if config is None else open_device(make_head(config, self._clock))

        def use(tracker: HeadTracker | None) -> None:
            self._tracker, self.kind = tracker, config.kind if config else ""

        return DeviceChange("head tracker", opened, use)

    def close(self) -> None:
        """Close the head tracker in use."""
        close_quietly(self._release_tracker())

    def look(self, yaw: float, pitch: float, roll: float) -> bool:
        """Pass on the orientation (rad) that a tablet reports; False when the tracker in use is no tablet."""
        look = getattr(self._tracker, "look", None)
        if look is not None:
            look(yaw, pitch, roll)
        return look is not None

    def set_ahead(self) -> bool:
        """Make the newest pose straight ahead; False when there is no pose."""
        pose = self._newest()
        if pose is None:
            return False
        self._ahead = pose.yaw, pose.pitch, pose.roll
        return True

    def note(self, tick: Tick, t: float) -> None:
        """Write the newest head pose and its age at `t` (s) into a tick."""
        pose = self._newest()
        if pose is None:
            tick.head_yaw = tick.head_pitch = tick.head_roll = tick.head_age = math.nan
            return
        yaw, pitch, roll = self._ahead
        tick.head_yaw = wrap_angle(pose.yaw - yaw)
        tick.head_pitch, tick.head_roll = wrap_angle(pose.pitch - pitch), wrap_angle(pose.roll - roll)
        tick.head_age = max(0.0, t - pose.t)

    def _release_tracker(self) -> HeadTracker | None:
        """Release the head tracker in use and return it, still open."""
        before, self._tracker = self._tracker, None
        self.kind, self._failed = "", None
        self._ahead = (0.0, 0.0, 0.0)
        return before

    def _newest(self) -> HeadPose | None:
        if self._tracker is None:
            return None
        try:
            return self._tracker.newest()
        except Exception as error:  # whatever a device does, the loop turns on
            tracker, self._tracker = self._tracker, None
            self._failed = Text("drives-tracker-failed", problem=message_of(error) or type(error).__name__)
            close_meanwhile(tracker)
            return None


class CommandRefused(Exception):  # noqa: N818
    """Why a command is refused, in one sentence."""


class ShirtWithBody(Protocol):
    """What the simulated shirt has beyond other shirts: a simulated body, and what that body sees."""

    view: BodyView
    body: Body | None


class Setup:
    """The parts in use; one part changes at a time, and none while the chair may move."""

    def __init__(self, clock: Clock) -> None:
        self._clock = clock
        self.head = HeadTracking(clock)
        self.shirt: Shirt | None = None
        self.shirt_config: ShirtConfig | None = None  # of the shirt in use, or of the one whose driver failed
        self._shirt_failed: Text | None = None  # why the shirt in use was released, None when it was not
        self.body_kind: str | None = None  # of the body inside the simulated shirt
        self.simulated_shirt: ShirtWithBody | None = None  # the shirt in use, when it is the simulated one
        self.parameters: DriveParameters | None = None
        self.hash: str | None = None
        self.floorplan: FloorPlan | None = None
        self.path: PrescribedPath | None = None
        self.leader: Track | None = None  # of a task to follow a leader
        self.chair: Chair = VirtualChair(None, ORIGIN)
        self.link: LinkedChair | None = None  # the chair in use when it is a real one
        self._dynamics: Dynamics = "unicycle"  # of the newest virtual chair
        self._clinic = HIGHEST_SPEEDS
        self._dial = 1.0
        self.chain = Chain(IDLE_RATE, None, self.chair)

    @property
    def sample_rate(self) -> float:
        """Frames per second (Hz) that the shirt states; the loop's own rate without a shirt."""
        return self.shirt.sample_rate if self.shirt else IDLE_RATE

    @property
    def shirt_kind(self) -> str:
        """The kind of the shirt in use, or of the one whose driver failed, in its configuration's word; else empty."""
        return self.shirt_config.kind if self.shirt_config else ""

    @property
    def mistrust(self) -> Text | None:
        """Why the shirt in use arms no real chair, None when it may; its line may be of another device now (S29)."""
        config = self.shirt_config
        return NO_SHIRT if self.shirt is None or config is None else SHIRTS[config.kind].mistrust(config)

    @property
    def layout_document(self) -> JsonDocument | None:
        """The layout of the shirt as a document, None without a shirt."""
        return self.shirt.layout.model_dump(mode="json") if self.shirt else None

    @property
    def network_shirt(self) -> NetworkShirt | None:
        """The shirt in use when it is a shirt over the network, else None."""
        return self.shirt if isinstance(self.shirt, NetworkShirt) else None

    @property
    def found_sensors(self) -> list[str]:
        """The names of the sensors that the shirt has found, and that nobody has placed on the body."""
        return self.shirt.found if isinstance(self.shirt, SearchingShirt) else []

    @property
    def arrivals(self) -> Arrivals | None:
        """What arrives at the shirt in use; None without one, or when it does not say."""
        return self.shirt.arrivals() if isinstance(self.shirt, ReportingShirt) else None

    @property
    def page_shirt(self) -> PageShirt | None:
        """The shirt in use when a page sends its samples, else None."""
        return self.shirt if isinstance(self.shirt, PageShirt) else None

    @property
    def shirt_description(self) -> Text:
        """The shirt's state in words."""
        return self.shirt.description() if self.shirt else self._shirt_failed or NO_SHIRT

    @property
    def source(self) -> Source:
        """What is connected, as every run records it; "unknown" without a shirt."""
        kind = SHIRTS.get(self.shirt_kind)
        return Source(
            shirt=self.shirt_kind or UNKNOWN,
            body=self.body_kind,
            chair=self.chair_kind,
            simulated=None if kind is None else kind.simulated,
        )

    @property
    def chair_kind(self) -> str:
        """The kind of the chair in use, as its configuration names it."""
        return "virtual" if self.link is None else "udp"

    @property
    def chair_description(self) -> Text:
        """The chair's state in words."""
        return Text("drives-virtual-chair", dynamics=self._dynamics) if self.link is None else self.link.description()

    @property
    def dynamics(self) -> Dynamics | None:
        """How the virtual chair moves; None for a real chair."""
        return self._dynamics if self.link is None else None

    @property
    def arming_hash(self) -> str | None:
        """The hash with which the chair is armed: of the set and a real chair's document; None without a set."""
        return None if self.hash is None else arming_hash(self.hash, "" if self.link is None else self.link.document)

    @property
    def stands(self) -> bool:
        """Whether the chair is commanded to stand, and stands."""
        return self.chain.gate.last == STANDSTILL and (self.link is None or self.link.stands)

    def require_still(self) -> None:
        """Raise CommandRefused while the chair moves or may move."""
        if self.chain.gate.state in (State.ARMED, State.CHECKING) or not self.stands:
            raise CommandRefused(Text("drives-armed"))

    def change_shirt(self, config: ShirtConfig) -> DeviceChange:
        """Release the shirt in use, and return the change that opens another one."""
        self.require_still()
        before = self._release_shirt()

        def opened() -> Shirt:
            close_quietly(before)  # first: the next shirt may use the same port
            return open_device(make_shirt(config, self._clock))

        def use(shirt: Shirt) -> None:
            self.shirt, self.shirt_config = shirt, config
            self.simulated_shirt = cast(ShirtWithBody, shirt) if config.kind == "simulator" else None
            if self.parameters is not None and self._misfit(self.parameters):
                self.parameters = self.hash = None
            self._make_chain()

        return DeviceChange("shirt", opened, use)

    def release_failed_shirt(self, error: Exception) -> None:
        """Release a shirt whose driver failed; without frames the gate stops the chair, as with a silent shirt."""
        failed, self.shirt, self.simulated_shirt = self.shirt, None, None
        self._shirt_failed = Text("drives-shirt-failed", problem=message_of(error) or type(error).__name__)
        close_meanwhile(failed)

    def close(self) -> None:
        """Release all devices."""
        self.head.close()
        self._close_link()
        close_quietly(self.shirt)

    def change_body(self, config: BodyConfig) -> DeviceChange:
        """Return the change to another body inside the simulated shirt."""
        self.require_still()
        if self.simulated_shirt is None:
            raise CommandRefused(Text("drives-no-body"))
        return DeviceChange("body", lambda: make_body(config), lambda body: self._use_body(body, config.kind))

    def change_chair(self, config: ChairConfig) -> DeviceChange:
        """Return the change that opens another chair; until then, and when that fails, the chair in use stays."""
        self.require_still()
        if isinstance(config, RealChairConfig):
            return DeviceChange("chair", lambda: open_device(make_real_chair(config)), self._use_real_chair)
        dynamics = config.dynamics
        return DeviceChange("chair", lambda: None, lambda _: self._use_virtual_chair(dynamics))

    def use_clinic(self, speeds: Speeds) -> None:
        """Set the clinic's limits: lower ones at once, higher ones only while nothing moves."""
        if not self.chain.set_clinic(speeds):
            raise CommandRefused(Text("drives-limits-while-moving"))
        self._clinic = speeds

    def use_dial(self, share: float) -> None:
        """Set the speed dial: a lower share at once, a higher share only while nothing moves."""
        if not self.chain.set_dial(share):
            raise CommandRefused(Text("drives-dial-while-moving"))
        self._dial = share

    def use_parameters(self, parameters: DriveParameters | None) -> None:
        """Use these parameters from now on; None: none."""
        self.require_still()
        misfit = self._misfit(parameters) if parameters is not None else None
        if misfit is not None:
            raise CommandRefused(misfit)
        self.parameters = parameters
        self.hash = parameters.hash if parameters else None
        self._make_chain()

    def use_world(self, floorplan: FloorPlan | None, path: str | None) -> None:
        """Put the virtual chair on the start of a path, or on an endless floor; a real chair knows no other floor."""
        self.require_still()
        if self.link is not None:
            if floorplan is not None:
                raise CommandRefused(Text("drives-plan-on-real-chair"))
            return
        chosen = None
        if floorplan is not None:
            try:
                chosen = floorplan.path_named(path) if path else floorplan.paths[0]
                chair = VirtualChair(floorplan, chosen.start, self._dynamics)
            except ValueError as error:
                raise CommandRefused(Text("drives-problem", problem=text_of(error))) from error
        else:
            chair = VirtualChair(None, ORIGIN, self._dynamics)
        self.floorplan, self.path, self.chair = floorplan, chosen, chair
        self.leader = leader_of(floorplan, chosen) if floorplan and chosen else None
        self.chain.chair = chair
        self._show_path()

    def to_start(self) -> None:
        """Put the virtual chair on the start; integrate the way of a real chair from where it stands."""
        self.chair.place(self.path.start if self.path else ORIGIN)

    def _release_shirt(self) -> Shirt | None:
        """Release the shirt in use and return it, still open."""
        before, self.shirt, self.simulated_shirt, self.body_kind = self.shirt, None, None, None
        self.shirt_config = self._shirt_failed = None
        self._make_chain()
        return before

    def _use_body(self, body: Body, kind: str) -> None:
        if self.simulated_shirt is not None:
            self.simulated_shirt.body, self.body_kind = body, kind
            self._show_path()

    def _close_link(self) -> None:
        """Close the link to the real chair in use, if there is one."""
        if self.link is not None:
            self.link.close()
            self.link = None

    def _use_real_chair(self, chair: LinkedChair) -> None:
        self._close_link()
        self.chair = self.link = chair
        self.floorplan = self.path = self.leader = None
        self._make_chain()

    def _use_virtual_chair(self, dynamics: Dynamics) -> None:
        self._close_link()
        self._dynamics = dynamics
        self.chair = VirtualChair(self.floorplan, self.path.start if self.path else ORIGIN, dynamics)
        self._make_chain()

    def _misfit(self, parameters: DriveParameters) -> Text | None:
        """Return in a sentence why parameters cannot decode the frames of the shirt; None when they can."""
        if self.shirt is None:
            return None
        if not self.shirt.layout.fits(parameters.profile.layout):
            return Text("drives-other-sensors")
        cutoff, rate = parameters.cutoff, self.sample_rate
        if rate <= 2.0 * cutoff:  # no filter has a cutoff above half the sample rate
            return Text("drives-cutoff-too-high", cutoff=cutoff, least=2.0 * cutoff, rate=rate)
        return None

    def _make_chain(self) -> None:
        """Make a new chain; keep a latched fault, the count of stops and the limits."""
        gate = self.chain.gate
        fitting = self.parameters if self.shirt is not None else None
        self.chain = Chain(self.sample_rate, fitting, self.chair)
        self.chain.set_clinic(self._clinic)
        self.chain.set_dial(self._dial)
        if gate.state is State.FAULT:
            self.chain.gate.stop(gate.fault)
        self.chain.gate.stops = gate.stops  # a new chain is no further stop
        if self.link is not None:
            self.link.use_parameters(bytes.fromhex(self.hash)[:DIGEST_BYTES] if self.hash else bytes(DIGEST_BYTES))

    def _show_path(self) -> None:
        """Show the task to a body that drives by itself."""
        body = self.simulated_shirt.body if self.simulated_shirt else None
        if isinstance(body, DrivingBody) and self.floorplan is not None and self.path is not None:
            body.show_task(self.floorplan, self.path)
