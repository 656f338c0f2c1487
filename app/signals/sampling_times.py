"""The sampling times of a file: its sample rate, and times that were stamped in bursts or coarsely made even.

A device stamps a sample when it is taken. Other programs stamp it when a radio delivers several at once, or in whole
seconds. Then neither the median nor the mean of the steps is the sample period: the median is the step within a burst,
and the mean includes pauses. The period is what several samples together take, from the first row of one group of
samples to the first row of the next.
"""

from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.recording.reader import both
from app.signals.row_places import RowPlaces
from app.texts import Figure, Text, Value

SLOWEST: Final = 10.0  # Hz; a slower sample rate does not suffice for a low-pass of 3 Hz
FASTEST: Final = 5000.0  # Hz
GAP: Final = 1.5  # periods: a longer step is a gap
NEW_GROUP: Final = 3.0  # of the first quartile of the steps: a longer one begins another group of samples
FEWEST_GROUPS: Final = 4  # of which the first and the last may be cut
OFTEN: Final = 0.8  # share of groups that have equally many samples
FEW: Final = 0.1  # share of steps that may differ from whole periods, or be gaps, without a check of the whole file
FEW_EQUAL: Final = 3  # equal times that are mended where they stand: rows that were written twice
UNEVEN: Final = 1 / 3  # of a period: what a step may differ from whole periods
MOST_GAPS: Final = 0.25  # share of steps that are gaps; beyond it, nobody knows the rate
RATE_CHANGE: Final = 20  # gaps in succession: no loss does this, another sample rate does
LONGEST_HOLE: Final = 3600.0  # s
NOTED_HOLE: Final = 1.0  # s
NOTED_GAPS: Final = 0.01  # share of steps
LARGEST_TIME: Final = 1e20  # larger than the nanoseconds since 1970
SHORTEST_SPAN: Final = 1e-12  # of the whole column: less than ten samples in days, and divisible by
ROUNDING: Final = 1e-5  # of a period: what sums of rounded steps may differ
UNITS: Final = (
    ("milliseconds", 1e-3),
    ("microseconds", 1e-6),
    ("nanoseconds", 1e-9),
    ("minutes", 60.0),
    ("hours", 3600.0),
    ("days", 86400.0),
)  # and how many seconds each is
FAST: Final = 600.0  # Hz, and a rate of 10 Hz in minutes
SHORT, BRIEF = (
    1.0,
    20.0,
)  # s: at such a rate shorter recordings count as minutes: all below SHORT, below BRIEF those at 60 times a usual rate
USUAL_RATES: Final = (10.0, 12.5, 15.0, 16.0, 20.0, 24.0, 25.0, 30.0, 32.0, 40.0, 50.0, 60.0, 64.0, 75.0, 80.0)  # Hz


class TimeSource(NamedTuple):
    """Where times come from: the rows of a file, and the name of their column."""

    places: RowPlaces
    column: str = "t"

    def file_text(self, message: str, /, **values: Value) -> Text:
        """Return a sentence about the column of the file."""
        return Text(message, file=self.places.file, column=self.column, **values)

    def row_text(self, message: str, row: int, /, **values: Value) -> Text:
        """Return a sentence about a row of the column (from 0)."""
        return Text(message, place=self.places.row(row), column=self.column, **values)


class SamplingTimes(NamedTuple):
    """Times of samples, strictly rising."""

    t: NDArray[np.float64]  # (n,) s
    sample_rate: float  # Hz
    note: Text | None  # what was changed, or is missing


def sampling_times(
    written: NDArray[np.float64], places: RowPlaces, column: str = "t", is_unit_stated: bool = False
) -> SamplingTimes:
    """Return the times and the sample rate of a column of times.

    Parameters
    ----------
    written : ndarray, shape (n,)
        The column, in s: finite numbers, n >= 2.
    places : RowPlaces
        Where the rows stand, for the sentence of a refusal.
    column : str
        The name of the column, for the sentence.
    is_unit_stated : bool
        Whether the file, or a person, says the unit: then a short and fast recording is not taken for minutes.

    Raises
    ------
    ValueError
        One sentence for times that run backwards, are in another unit than seconds, jump, or have no even rate.
    """
    source = TimeSource(places, column)
    t, period, note = _even_times(written, source)
    _refuse_units(t, period, source)
    if not is_unit_stated:
        _refuse_minutes(t, period, source)
    if note is None:
        t, period, note = _without_clock_steps(t, period, source)
    return SamplingTimes(t, round(1.0 / period, 6), both(note, _gap_note(t, period, source)))


def _even_times(written: NDArray[np.float64], source: TimeSource) -> tuple[NDArray[np.float64], float, Text | None]:
    """Return strictly rising times, the period, and what was done about samples that share a time or come in bursts."""
    if np.abs(written).max() > LARGEST_TIME:
        first, last = _rounded(written[0]), _rounded(written[-1])
        raise ValueError(source.file_text("signals-time-large", first=first, last=last))
    refuse_falling_times(written, source)
    steps = np.diff(written)
    if written[-1] - written[0] < SHORTEST_SPAN:
        raise ValueError(source.file_text("signals-time-constant", time=_rounded(written[0])))
    shared = int((steps == 0.0).sum())
    starts = np.flatnonzero(np.concatenate(([True], steps > 0))) if shared else _bursts(steps)
    if starts is None:
        return written, _period(steps), None
    even = None if 0 < shared <= FEW_EQUAL else _evenly_spread(written, starts)
    if even is None and 0 < shared <= max(FEW_EQUAL, FEW * len(steps)):
        even = strictly_rising(written), _period(steps[steps > 0])
    if even is None:
        if shared:
            raise ValueError(source.file_text("signals-shared-uneven", shared=shared, count=len(written)))
        raise ValueError(source.file_text("signals-bursts-uneven"))
    t, period = even
    rate = _rounded(1.0 / period)
    if shared:
        return t, period, Text("signals-shared-spread", shared=shared, count=len(written), rate=rate)
    return t, period, Text("signals-bursts-spread", rate=rate)


def refuse_falling_times(t: NDArray[np.float64], source: TimeSource) -> None:
    """Raise ValueError with the first row at which times (n,) are smaller than before."""
    falls = np.flatnonzero(np.diff(t) < 0)
    if len(falls):
        row = int(falls[0]) + 1
        before, after = _rounded(t[row - 1]), _rounded(t[row])
        raise ValueError(source.row_text("signals-time-backwards", row, before=before, after=after))


def _bursts(steps: NDArray[np.float64]) -> NDArray[np.intp] | None:
    """Return the first row of each burst; None when samples come one by one.

    In bursts most of the time passes between one burst and the next. Between two losses it passes sample by sample.
    """
    starts = np.concatenate(([0], np.flatnonzero(steps > NEW_GROUP * np.quantile(steps, 0.25)) + 1))
    if len(starts) < FEWEST_GROUPS:
        return None
    between_bursts = steps[starts[1:] - 1]
    intervals = np.add.reduceat(steps, starts[:-1])[1:]  # from a burst's first row to the next one's
    often = np.median(np.diff(starts)[1:]) >= 2 and np.median(between_bursts[1:] / intervals) > 0.5
    return starts if often else None


def _evenly_spread(t: NDArray[np.float64], starts: NDArray[np.intp]) -> tuple[NDArray[np.float64], float] | None:
    """Return even times and their period for groups of samples that begin at the rows `starts`; None if there are none.

    Where no sample is missing, one even grid agrees with the beginnings of all groups to within the time of one group.
    Where groups are missing, most of the others have equally many samples, and each stretch without a loss is a grid.
    """
    if len(starts) < FEWEST_GROUPS:
        return None
    first, counts, intervals = t[starts], np.diff(starts), np.diff(t[starts])
    interval, count = float(np.median(intervals[1:])), float(np.median(counts[1:]))
    rows = np.arange(len(t), dtype=np.float64)
    period = float(first[-1] - first[1]) / float(starts[-1] - starts[1])
    if count == 1.0 and abs(interval - period) * (starts[-1] - starts[1]) <= 2.0 * float(intervals.max()):
        period = round(interval, 9)  # most times are exact, and only others have too few digits
    offset = float(np.median(first[1:] - starts[1:] * period))
    is_full = intervals <= GAP * counts * interval / count  # its samples fill the time up to the next group
    resolution = float(intervals[is_full].max(initial=interval))
    is_even = np.abs(first - offset - starts * period).max() <= resolution + 2 * period
    if is_even and not _has_lost_groups(intervals / interval, is_full):
        return offset + rows * period, period
    is_whole = (np.abs(counts - count) <= max(1.0, 0.02 * count)) & (intervals <= GAP * interval)
    if is_whole[1:].mean() < OFTEN:
        return (offset + rows * period, period) if is_even else None
    is_whole[0] = False  # it may be cut
    period = float(intervals[is_whole].sum() / counts[is_whole].sum())
    offsets = np.empty(len(starts), dtype=np.float64)
    breaks = np.flatnonzero(~is_whole) + 1  # the group after a loss begins another stretch
    for stretch in np.split(np.arange(len(starts)), breaks):
        offsets[stretch] = np.median(first[stretch] - starts[stretch] * period)
    even: NDArray[np.float64] = np.repeat(offsets, np.diff(np.append(starts, len(t)))) + rows * period
    return (even, period) if (np.diff(even) > 0).all() else None


def _has_lost_groups(intervals: NDArray[np.float64], is_full: NDArray[np.bool_]) -> bool:
    """Return whether long intervals (n,), in median ones, are those of losses.

    After a delay a short interval follows. A single long one may be where later times are written with fewer digits.
    """
    long = intervals[(intervals > GAP) & ~is_full]
    late = int((intervals < 0.5).sum())
    return len(long) > late + 1 and bool(np.median(np.abs(long - np.rint(long))) < 0.2)


def strictly_rising(t: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return times (n,) in which samples with one time are spread evenly up to the next time."""
    steps = np.diff(t)
    if steps.all():
        return t
    firsts = np.flatnonzero(np.concatenate(([True], steps > 0)))
    end = t[-1] + float(np.median(steps[steps > 0])) * (len(t) - firsts[-1])
    spread: NDArray[np.float64] = np.interp(np.arange(len(t)), np.append(firsts, len(t)), np.append(t[firsts], end))
    return spread


def _period(steps: NDArray[np.float64]) -> float:
    """Return the mean of the steps that are no gaps; their median is wrong for rounded times (0.003, 0.004, 0.003)."""
    return float(steps[steps <= GAP * np.median(steps)].mean())


def _without_clock_steps(
    t: NDArray[np.float64], period: float, source: TimeSource
) -> tuple[NDArray[np.float64], float, Text | None]:
    """Return times, period and what was done; raise ValueError for times without an even rate.

    A clock that moves on in coarse steps, or late, gives uneven times of even samples: no time is then further than a
    period from an even grid, however long the recording is.
    """
    steps = np.diff(t)
    periods = steps / period
    uneven = np.abs(periods - np.maximum(np.rint(periods), 1.0)) > UNEVEN
    gaps = periods > GAP
    if uneven.mean() <= FEW and gaps.mean() <= FEW:
        _refuse_another_rate(gaps, t, source)
        return t, period, None
    mean = float(t[-1] - t[0]) / len(steps)
    grid = t[0] + np.arange(len(t)) * mean
    late = t - grid
    if np.ptp(late) <= 2.0 * mean:
        grid += np.median(late)
        return grid, mean, Text("signals-steps-spread", column=source.column, rate=_rounded(1.0 / mean))
    if uneven.mean() <= FEW and gaps.mean() <= MOST_GAPS:
        _refuse_another_rate(gaps, t, source)
        return t, period, None
    low, high = np.quantile(steps, (0.05, 0.95))
    raise ValueError(source.file_text("signals-uneven", least=_rounded(low, 3), most=_rounded(high, 3)))


def _refuse_another_rate(gaps: NDArray[np.bool_], t: NDArray[np.float64], source: TimeSource) -> None:
    run = np.convolve(gaps, np.ones(RATE_CHANGE, np.int64), "valid") if len(gaps) >= RATE_CHANGE else np.zeros(1)
    if run.max() == RATE_CHANGE:
        row = int(run.argmax())
        raise ValueError(source.row_text("signals-rate-changes", row, time=_rounded(t[row])))


def _refuse_units(t: NDArray[np.float64], period: float, source: TimeSource) -> None:
    """Raise ValueError unless `t` can be in seconds; the sentence names the probable unit and the remedy."""
    slow, fast = (1 + ROUNDING) / SLOWEST, (1 - ROUNDING) / FASTEST
    step: dict[str, Value] = {"step": _rounded(period, 4)}
    if not fast <= period <= slow:
        if abs(period - 1.0) < ROUNDING and np.ptp(np.diff(t)) < ROUNDING:
            raise ValueError(source.file_text("signals-unit-counter", **step))
        like = [(unit, size) for unit, size in UNITS if fast <= period * size <= slow]
        if like:
            units = [Text("signals-unit", unit=unit, rate=_rounded(1.0 / (period * size), 4)) for unit, size in like]
            step |= {"unit": units[0], "factor": like[0][1]}
            if len(like) == 1:
                raise ValueError(source.file_text("signals-unit-other", **step))
            raise ValueError(
                source.file_text("signals-unit-one-of-two", **step, or_unit=units[1], or_factor=like[1][1])
            )
        if period > slow:
            raise ValueError(source.file_text("signals-unit-or-slow", **step, slowest=SLOWEST, fastest=FASTEST))
        raise ValueError(source.file_text("signals-unit-or-fast", **step, slowest=SLOWEST, fastest=FASTEST))


def _refuse_minutes(t: NDArray[np.float64], period: float, source: TimeSource) -> None:
    """Raise ValueError for a recording so fast and short that its times are probably minutes."""
    span, rate = float(t[-1] - t[0]), 1.0 / (period * 60.0)
    like_minutes = any(abs(rate / usual_rate - 1.0) < 2e-3 for usual_rate in USUAL_RATES)
    if 1.0 / period >= FAST * (1 - ROUNDING) and (span < SHORT or (span < BRIEF and like_minutes)):
        seconds: dict[str, Value] = {"span": _rounded(span, 3), "rate": _rounded(1.0 / period, 5), "brief": BRIEF}
        minutes = {"span_of_minutes": _rounded(span * 60.0, 4), "rate_of_minutes": _rounded(rate, 4)}
        step = _rounded(period, 4)
        raise ValueError(source.file_text("signals-unit-minutes", step=step, **seconds, **minutes))


def _gap_note(t: NDArray[np.float64], period: float, source: TimeSource) -> Text | None:
    """Return a sentence on the gaps, None when they are few and short; raise ValueError for a jump of hours."""
    steps = np.diff(t)
    gaps, row = int((steps > GAP * period).sum()), int(steps.argmax())
    longest = float(steps[row])
    if longest > LONGEST_HOLE:
        hours = Figure(longest / 3600.0, 1)
        raise ValueError(source.row_text("signals-time-jumps", row + 1, seconds=_rounded(longest), hours=hours))
    if longest <= NOTED_HOLE and gaps <= NOTED_GAPS * len(steps):
        return None
    return source.row_text("signals-gaps", row + 1, count=gaps, longest=_rounded(longest, 3))


def _rounded(number: float, digits: int = 6) -> float:
    """Return a number with at most so many digits that count."""
    return float(f"{number:.{digits}g}")
