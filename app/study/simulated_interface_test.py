"""The interface test of a study: through the chain with the chair disarmed, measured as any interface test."""

from app.calibration.vocabulary import DriveParameters
from app.geometry import Pose
from app.hardware.chair.simulator import VirtualChair
from app.pipeline.chain import Chain
from app.pipeline.safety_gate import Conditions
from app.scoring.interface_test.interface_measures import InterfaceMeasures, interface_measures
from app.study.participant import Participant
from app.world.cursor_task import CursorPlan, CursorTask


def do_interface_test(participant: Participant, parameters: DriveParameters, plan: CursorPlan) -> InterfaceMeasures:
    """Let the participant do one interface test, and return its measures. Nothing drives."""
    chain = Chain(participant.sample_rate, parameters, VirtualChair(None, Pose(0.0, 0.0, 0.0)))
    conditions = Conditions()
    task = CursorTask(plan)
    frame = participant.rest()
    begin = frame.t
    while task.phase != "over":
        tick = chain.step(frame, frame.t, conditions)
        task.step(frame.t - begin, tick.u1, tick.u2)
        frame = participant.point(task)
    return interface_measures(task)
