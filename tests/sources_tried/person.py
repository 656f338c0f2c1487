"""A scripted person at a far end: does what the page of the calibration asks for, and drives the straight corridor."""

import json
import threading
from contextlib import suppress

from processes.served_demo import ProgramClient
from websockets.exceptions import ConnectionClosed

from app.clock import monotonic
from app.cues import Cue
from app.geometry import Pose
from app.hardware.base import BodyView
from app.hardware.body.person import SimulatedPerson
from app.world.scene import find_place

FLOORPLAN, PATH = "corridors", "straight"
STEPS = frozenset({"rest", "free", "prompt"})  # kinds of runs that have cues
METRE = 1.0  # m


class Eyes(threading.Thread):
    """Sees what the pages of a demonstration show, by its live socket.

    Attributes
    ----------
    view : BodyView
        What the person sees now; another one with each message.
    ages : list of float
        Of the newest frame, while the chair may move, s.
    seen : list of (float, list)
        When a tick was made during the calibration (monotonic s), and the channels' values in it.
    metre_t : float or None
        When the chair had driven a metre (monotonic s).
    """

    def __init__(self, program, plays):
        """`program` is a ProgramClient that is signed in, `plays` that of ScriptedPerson."""
        super().__init__(name="eyes", daemon=True)
        self.view = BodyView()
        self.ages, self.seen, self.metre_t = [], [], None
        self._plays = plays
        self._cues = ()
        self._client = program.client
        self._socket = program.socket("live")

    def run(self):
        with suppress(ConnectionClosed):
            for text in self._socket:
                self.take(json.loads(text))

    def take(self, message):
        """Look at a message of the live socket."""
        run, trial = message["run"], message["trial"]
        is_step = run is not None and run["kind"] in STEPS
        if not is_step:
            self._cues = ()
        elif not self._cues:
            self._cues = self._read_cues()
        cue = self._cues[run["cue"]] if is_step and self._cues and run["cue"] is not None else None
        drives = trial is not None and message["state"] == "armed"
        self.view = BodyView(
            cue=cue,
            driving=drives,
            pose=Pose(*message["pose"]),
            v=message["v"],
            omega=message["omega"],
            in_contact=message["in_contact"],
        )
        if is_step and message["values"] is not None:
            self.seen.append((message["t"], message["values"]))
        if drives and message["shirt"]["age"] is not None:
            self.ages.append(message["shirt"]["age"])
        if drives and self.metre_t is None and (trial["done"] or 0.0) >= METRE:
            self.metre_t = monotonic()

    def close(self):
        """See nothing more."""
        self._socket.close()
        self._client.close()

    def _read_cues(self):
        """Return the cues of the step that is recorded, with the joints that the person moves for them."""
        calibration = self._client.get("/calibration").json()
        running = calibration["running"]
        cues = [
            Cue.model_validate(cue)
            for step in calibration["steps"]
            if running is not None and step["id"] == running["step"]
            for cue in step["cues"]
        ]
        return tuple(cue.model_copy(update={"joint": self._plays.get(cue.joint, cue.joint)}) for cue in cues)


def visitor(base, code):
    """Return a client of the demonstration at `base`, signed in by the code of its link."""
    program = ProgramClient(base)
    answer = program.client.post("/auth/demo", json={"code": code})
    assert answer.is_success, answer.text
    return program


class ScriptedPerson:
    """The simulated person, who moves as the eyes see; `levels` has the joints by the names of the shirt's.

    `plays` names the person's joint that a joint of the shirt moves as, where the person has none of its name.
    """

    def __init__(self, plays):
        self._plays = plays
        self._person = SimulatedPerson("practised", 1)
        plan = find_place(FLOORPLAN)
        assert plan is not None
        self._person.show_task(plan, plan.path_named(PATH))

    def levels(self, dt, view):
        """Advance by `dt` (s) and return the level of each joint, 0 at rest, 1 in a full movement."""
        posture = dict(zip(self._person.joints, self._person.step(dt, view).tolist(), strict=True))
        return posture | {joint: posture[own] for joint, own in self._plays.items()}
