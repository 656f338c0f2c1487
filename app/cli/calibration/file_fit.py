"""The calibration of a file of signals: its stretches of time, its prompts, and the maps that are fitted to them."""

import math
from collections.abc import Collection, Sequence
from pathlib import Path

from app.calibration.clean_recording import CleanRecording
from app.calibration.fit.profile_fit import fit_profile
from app.calibration.fit.repetitions import Prompt, Stretch, repetitions_of_prompts, stretches_of_prompts
from app.calibration.guided.guided_map import GuidedFit, with_guided_maps
from app.calibration.prior.map_prior import MapPrior
from app.calibration.prior.prior_map import PriorFit, with_prior_maps
from app.cli.errors import InputError
from app.layout import ShirtLayout
from app.signals.signals import Signals
from app.texts import Text


def window(
    signals: Path, recorded: Signals, start_option: str, start: float | None, end_option: str, end: float | None
) -> slice:
    """Return the rows between the times of two options (s, None without one); InputError for an empty range."""
    for option, seconds in ((start_option, start), (end_option, end)):
        if seconds is not None and not math.isfinite(seconds):
            raise InputError(Text("cli-no-seconds", option=option, value=str(seconds)))
    rows = recorded.between(start, end)
    if rows.stop <= rows.start:
        first = recorded.t[0] if start is None else start
        last = recorded.t[-1] if end is None else end
        nothing = Text(
            "cli-nothing-there",
            start=start_option,
            first=f"{first:g}",
            end=end_option,
            last=f"{last:g}",
            signals=str(signals),
            begins=f"{recorded.t[0]:g}",
            ends=f"{recorded.t[-1]:g}",
        )
        raise InputError(nothing)
    return rows


def prompted_stretches(recorded: Signals, rows: Sequence[Prompt], until: float | None = None) -> list[Stretch]:
    """Return one stretch per joint of a table of prompts, for the maps from other people.

    Between the first and the last prompt of a joint, what is not prompted counts as rest, however long it is.
    """
    return stretches_of_prompts(recorded.t, recorded.values, rows, recorded.sample_rate, until, longest_pause=math.inf)


def fit_file(
    recorded: Signals,
    shirt: ShirtLayout,
    rows: Sequence[Prompt],
    free: slice,
    rest: slice | None,
    unused: Collection[str],
    until: float | None,
    pool: MapPrior | None,
) -> tuple[GuidedFit, PriorFit | None]:
    """Return the profile with standard and guided maps, and with maps from other people when there is a `pool`.

    Parameters
    ----------
    recorded : Signals
        The file.
    shirt : ShirtLayout
        The layout of the shirt that it was recorded in.
    rows : sequence of Prompt
        The table of prompts; it may be empty.
    free, rest : slice
        The rows of the free movement and of the rest.
    unused : collection of str
        Channels not to be used.
    until : float or None
        What follows the last prompt of a joint is used up to this time of the recording, s. Every prompt counts.
    pool : MapPrior or None
        What is known of other people.

    Raises
    ------
    ValueError
        For signals that no map can be fitted to.
    PriorError
        For a pool of another layout.
    """
    t, values, sample_rate = recorded.t, recorded.values, recorded.sample_rate
    at_rest = None if rest is None else values[rest]
    repetitions = repetitions_of_prompts(t, values, rows, sample_rate)
    stretches = stretches_of_prompts(t, values, rows, sample_rate, until=until)
    clean = CleanRecording.of(shirt, sample_rate, values[free], at_rest, repetitions, stretches, unused)
    fitted = with_guided_maps(fit_profile(clean), clean)
    if pool is None:
        return fitted, None
    joined = clean.with_stretches(prompted_stretches(recorded, rows, until))
    return fitted, with_prior_maps(fitted.profile, pool, joined)
