"""A recorded run through the chain again, with its signals, its decisions of the gate and its floor plan."""

import numpy as np
from pydantic import ValidationError

from app.calibration.vocabulary import DriveParameters
from app.geometry import Pose
from app.hardware.chair.simulator import VirtualChair
from app.json_values import JsonDocument
from app.pipeline.replay.batch import DecodedRun, decode_block
from app.recording.reader import RunRecording
from app.sentences import one_sentence
from app.signals.sampling_times import FASTEST, SLOWEST
from app.texts import Text
from app.world.floorplan import FloorPlan

DRIVE = "drive"  # the kind of run with decisions of the gate


def decode_run(run: RunRecording, parameters: DriveParameters) -> DecodedRun:
    """Decode the frames of a recorded run; with the parameters of the drive, its commands come out.

    Raises
    ------
    ValueError
        In one sentence, when the run has no frames, was recorded with another number of channels, or says nonsense
        of itself.
    """
    frames = run.frames()
    values = frames["values"]
    if not len(values):
        raise ValueError(Text("drives-replay-no-frame"))
    expected = len(parameters.profile.layout.channels)
    if values.shape[1] != expected:
        raise ValueError(Text("drives-replay-channels", recorded=values.shape[1], expected=expected))
    driven = run.meta.get("kind") == DRIVE
    return decode_block(
        parameters,
        sample_rate_of(run.meta, parameters.profile.sample_rate),
        frames["t"],
        values.astype(np.float32, copy=False),
        t_device=frames["t_device"],
        state=frames["state"] if driven else None,
        chair=chair_of(run.meta) if driven else None,
    )


def sample_rate_of(meta: JsonDocument, otherwise: float) -> float:
    """Return the sample rate (Hz) that a run's meta states; ValueError for an invalid one."""
    stated = meta.get("sample_rate", otherwise)
    if isinstance(stated, bool) or not isinstance(stated, int | float) or not SLOWEST <= stated <= FASTEST:
        raise ValueError(Text("drives-replay-rate", stated=repr(stated), slowest=SLOWEST, fastest=FASTEST))
    return float(stated)


def chair_of(meta: JsonDocument) -> VirtualChair | None:
    """Return the virtual chair on the start of a run's floor plan, None without one; ValueError for a broken one."""
    document = meta.get("floorplan")
    if not document:
        return None
    try:
        plan = FloorPlan.model_validate(document)
    except ValidationError as error:
        raise ValueError(one_sentence(error, Text("drives-replay-part", part="floorplan"))) from error
    path = plan.path_named(meta["path"]) if meta.get("path") else plan.paths[0]
    return VirtualChair(plan, Pose(*path.start), meta.get("dynamics", "unicycle"))
