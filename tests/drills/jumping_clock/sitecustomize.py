"""A wall clock that jumps by a day, there and back, at every look at it."""

import itertools
import time

_true = time.time
_days = itertools.cycle((0.0, 86_400.0, -86_400.0, 3_600.0))
time.time = lambda: _true() + next(_days)
time.time_ns = lambda: int(time.time() * 1e9)
