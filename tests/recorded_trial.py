"""Records a trial as the control process does: with the real chain, by the strokes of a simulated body."""

import math
import uuid

from clinic_rows import ClinicRows

from app.calibration.vocabulary import DriveParameters
from app.faults import Fault
from app.hardware.chair.simulator import VirtualChair
from app.messages import NO_CUE, SensorFrame
from app.pipeline.chain import Chain
from app.pipeline.safety_gate import Conditions
from app.process.ring import RING_SLOTS, TickRing
from app.recording.writer import RunWriter
from building import make_signals, plan_of

STARTED = 5000.0  # s on the monotonic clock


def record_trial(
    folder,
    parameters: DriveParameters,
    *,
    seconds=12.0,
    seed=0,
    plan=None,
    dynamics="unicycle",
    dials=(),
    missing=(),
    without_frame=(),
    stop_at=None,
    values=None,
    source=None,
):
    """Record a trial into `folder` and return its meta.

    dials: (s, share) of each change of the speed dial; missing: lost frames; without_frame: ticks in which no frame
    came; stop_at: s at which Stop is pressed; it is cleared a second later.
    """
    rate = parameters.profile.sample_rate
    plan = plan or plan_of()
    path = plan.paths[0]
    values = make_signals(parameters, int(seconds * rate), seed) if values is None else values
    chair = VirtualChair(plan, path.start, dynamics)
    chain = Chain(rate, parameters, chair)
    layout = parameters.profile.layout
    meta = {
        **({} if source is None else {"source": source}),
        "run_id": "trial",
        "kind": "drive",
        "software": "test",
        "layout": layout.model_dump(mode="json"),
        "sample_rate": rate,
        "gestures": [gesture.name for gesture in parameters.gestures],
        "cues": [],
        "parameters": parameters.model_dump(mode="json"),
        "floorplan": plan.model_dump(mode="json"),
        "path": path.name,
        "dynamics": dynamics,
        "clinic": chain.clinic.model_dump(mode="json"),
    }
    ring = TickRing.create(f"bodydrive-test-{uuid.uuid4().hex}")
    ring.unlink()
    writer = RunWriter(folder, meta, len(layout.channels), len(parameters.gestures))
    writer.start(ring, 0, 1)
    assert len(values) < RING_SLOTS  # then nothing is lost, however slow the recorder is
    dials, conditions = list(dials), Conditions()
    chain.arm()
    for i, frame in enumerate(values):
        run_t = i / rate
        t = STARTED + run_t + 1e-4 * math.sin(i)  # ticks of a real loop jitter by microseconds
        if i in missing:
            continue
        if dials and run_t >= dials[0][0]:
            assert chain.set_dial(dials.pop(0)[1])
        if stop_at is not None and i == int(stop_at * rate):
            chain.gate.stop(Fault.STOP_TABLET)
        if stop_at is not None and i == int((stop_at + 1) * rate):
            chain.gate.clear(chain.gate.stops)
            chain.arm()
        came = None if i in without_frame else SensorFrame(i, run_t, t, frame)
        tick = chain.step(came, t, conditions)
        tick.driven_v, tick.driven_omega, tick.dial = chair.state.v, chair.state.omega, chain.dial
        ring.write(tick, 1, run_t, NO_CUE, 0, 0)
    writer.close(ring.number)
    ring.close()
    assert (writer.dropped, writer.damage) == (0, None)
    return meta


def store_trial(db, run, owners, plan, source, measures):
    """Store a finished trial on the first path of `plan`; `owners`: the rows of its session and its parameters."""
    return ClinicRows(db).trial(owners[0], measures, plan=plan, source=source, run=run, end="by hand")
