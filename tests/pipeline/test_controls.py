from hypothesis import given
from hypothesis import strategies as st

from app.calibration.vocabulary import Binding
from app.pipeline.controls import Controls
from building import make_parameters

FASTER, SLOWER, LEFT, RIGHT = range(4)  # the order of the paper's joints in the test profile
activations = st.lists(st.floats(0, 1), min_size=4, max_size=4)


def test_the_papers_vocabulary():
    controls = Controls(make_parameters())
    assert controls.step([1.0, 0.0, 0.0, 0.0]) == (1.0, 0.0)
    assert controls.step([0.0, 1.0, 0.0, 0.0]) == (-1.0, 0.0)
    assert controls.step([0.0, 0.0, 1.0, 0.0]) == (0.0, 1.0)
    assert controls.step([0.0, 0.0, 0.0, 1.0]) == (0.0, -1.0)
    assert controls.step([0.5, 0.25, 0.25, 0.5]) == (0.25, -0.25)


@given(activations)
def test_controls_stay_within_one(activation):
    bindings = (Binding(control="u1+", gestures=("right_elbow", "left_elbow", "right_shoulder"), gain=5.0),)
    controls = Controls(make_parameters().model_copy(update={"bindings": bindings}))
    u1, u2 = controls.step(activation)
    assert -1 <= u1 <= 1
    assert u2 == 0


def test_a_stop_needs_all_of_its_gestures_together():
    controls = Controls(make_parameters())
    assert controls.is_stop([0.5, 0.5, 0.0, 0.0])
    assert not controls.is_stop([1.0, 0.49, 0.0, 0.0])
    assert not controls.is_stop([0.0, 0.0, 1.0, 1.0])


def test_neutral_looks_at_bound_gestures_only():
    bindings = (Binding(control="u1+", gestures=("right_elbow",)),)
    controls = Controls(make_parameters().model_copy(update={"bindings": bindings}))
    assert controls.bound == [0]
    assert controls.is_neutral([0.0, 1.0, 1.0, 1.0])
    assert not controls.is_neutral([0.001, 0.0, 0.0, 0.0])
