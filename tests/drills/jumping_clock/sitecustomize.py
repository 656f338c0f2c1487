"""A wall clock that jumps by a day, there and back, at every look at it: of bodydrive (UTC) and of all libraries."""

import itertools
import time
from contextlib import suppress
from datetime import timedelta

_days = itertools.cycle((0.0, 86_400.0, -86_400.0, 3_600.0))
_true = time.time
time.time = lambda: _true() + next(_days)
time.time_ns = lambda: int(time.time() * 1e9)

with suppress(ImportError):  # a program in another environment
    from app import clock

    _true_utc = clock.utc_now
    clock.utc_now = lambda: _true_utc() + timedelta(seconds=next(_days))
