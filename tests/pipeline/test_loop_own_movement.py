"""The control process arms a real chair only with maps that the person's own movement has confirmed."""

import pytest

from app.faults import State
from building import AGREES, taught_by_others

WRONG_WAY = AGREES.model_copy(update={"in_phase": 0.1})


def use(control, **taught):
    """Load the parameters with maps that other people taught, and return their hash."""
    profile = taught_by_others(control.parameters.profile, **taught)
    parameters = control.parameters.model_copy(
        update={"profile": profile, "mode_u1": "velocity", "mode_u2": "velocity"}
    )
    control.setup.use_parameters(parameters)
    return parameters.hash


def ready_chair(control, chair, folder):
    """Choose the real chair, begin a drive that is recorded, and let the chair answer."""
    control.live(0.1)
    control.done("chair", config=chair.document)
    control.done("run", run_id="r", folder=str(folder / "r"), kind="drive", cues=[], meta={})
    control.live(0.01)
    chair.commands()
    chair.say()
    control.live(0.01)


@pytest.mark.parametrize("taught", [{}, {"repetitions": 1}, {"repetitions": 3, "check": WRONG_WAY}])
def test_a_map_that_no_own_movement_confirms_arms_the_virtual_chair_and_no_real_one(control, chair, tmp_path, taught):
    digest = use(control, **taught)
    control.live(0.1)
    control.done("arm", hash=digest)
    control.done("disarm")
    ready_chair(control, chair, tmp_path)
    words = control.refused("arm", hash=digest)
    assert words.startswith("Other people taught the movement of right elbow")
    control.live(1.0)
    assert control.setup.chain.gate.state is State.DISARMED
    assert chair.commands() == []  # nothing was sent to the chair


def test_one_own_repetition_that_agrees_is_enough(control, chair, tmp_path):
    digest = use(control, repetitions=1, check=AGREES)
    ready_chair(control, chair, tmp_path)
    control.done("arm", hash=digest)
    assert control.setup.chain.gate.state is State.CHECKING


def test_a_joint_that_is_bound_to_nothing_needs_none(control, chair, tmp_path):
    bound = {control.parameters.gestures[i].joint for i in control.parameters.bound_gestures}
    others = [joint.name for joint in control.parameters.profile.joints if joint.name not in bound]
    digest = use(control, joints=others)
    ready_chair(control, chair, tmp_path)
    control.done("arm", hash=digest)
    assert control.setup.chain.gate.state is State.CHECKING
