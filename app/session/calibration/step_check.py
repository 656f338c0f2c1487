"""Check whether a step's recording can be used: enough frames, no long gap; and whether it has to be repeated."""

import numpy as np
from numpy.typing import NDArray

from app.calibration.fit.profile_fit import joints_without_map
from app.calibration.map_grades import SIGNAL_TO_NOISE_LIMITS, UNPROMPTED
from app.calibration.profile import CalibrationProfile, JointMap
from app.calibration.script import Step
from app.texts import Figure, Text, in_sequence

ENOUGH = 0.9  # share of the frames that should have come at the shirt's sample rate
LONGEST_GAP = 0.25  # s; a movement of a second is not recognised across a longer one


def check_frames(run_t: NDArray[np.float64], duration: float, sample_rate: float) -> Text | None:
    """Return in one sentence why the frames of a step cannot be used, None when they can.

    Parameters
    ----------
    run_t : array, shape (n,)
        Time at which each frame came, s since the start of the run.
    duration : float
        How long the step should have lasted, s.
    sample_rate : float
        Of the shirt, Hz.
    """
    within = run_t[(run_t >= 0) & (run_t <= duration)]
    expected = duration * sample_rate
    if within.size < ENOUGH * expected:
        return Text("visit-step-lossy", share=Figure(100 * within.size / expected))
    gap = float(np.max(np.diff(np.concatenate(([0.0], within, [duration])))))
    if gap > LONGEST_GAP:
        return Text("visit-step-silent", seconds=Figure(gap, 1))
    return None


def advice_of(profile: CalibrationProfile, step: Step) -> Text | None:
    """Return why a step has to be repeated, in the words of the profile; None when it need not be.

    A prompted movement is judged by its joint. The free movement has to be repeated when no joint moves clearly: each
    would have to be repeated, or has a weak signal, which the noise of a shirt at rest can have by chance.
    """
    joints = {joint.name: joint for joint in profile.joints}
    if step.kind == "prompt":
        joint = joints.get(str(step.joint))
        if joint is None:
            return joints_without_map(profile)[str(step.joint)]
        return joint.description if joint.has_to_be_repeated else None
    weak = [joint for joint in profile.joints if joint.has_to_be_repeated]
    unclear = sum(joint.has_to_be_repeated or _is_weak(joint) for joint in profile.joints)
    if step.kind == "rest" or not weak or unclear < len(profile.joints):
        return None
    first = weak[0]
    findings = in_sequence(sentence for sentence in first.reason if sentence != UNPROMPTED)
    return Text("visit-no-joint-moves", joint=profile.layout.joint_titles[first.name], reason=findings)


def _is_weak(joint: JointMap) -> bool:
    return (joint.signal_to_noise or 0.0) < SIGNAL_TO_NOISE_LIMITS[0]
