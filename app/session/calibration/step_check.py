"""Check whether a step's recording can be used: enough frames, no long gap."""

import numpy as np
from numpy.typing import NDArray

ENOUGH = 0.9  # share of the frames that should have come at the shirt's sample rate
LONGEST_GAP = 0.25  # s; a movement of a second is not recognised across a longer one


def check_frames(run_t: NDArray[np.float64], duration: float, sample_rate: float) -> str | None:
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
        share = 100 * within.size / expected
        return (
            f"Only {share:.0f} % of the shirt's signals arrived: "
            "check its battery and transmitter, then repeat this step."
        )
    gap = float(np.max(np.diff(np.concatenate(([0.0], within, [duration])))))
    if gap > LONGEST_GAP:
        return f"The shirt was silent for {gap:.1f} seconds: check its transmitter, then repeat this step."
    return None
