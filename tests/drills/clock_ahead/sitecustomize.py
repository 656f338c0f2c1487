"""A wall clock that is ahead by CLOCK_AHEAD seconds: of bodydrive (UTC) and of all libraries."""

import os
import time
from contextlib import suppress
from datetime import timedelta

AHEAD = float(os.environ["CLOCK_AHEAD"])
_true = time.time
time.time = lambda: _true() + AHEAD
time.time_ns = lambda: int(time.time() * 1e9)

with suppress(ImportError):  # a program in another environment
    from app import clock

    _true_utc = clock.utc_now
    clock.utc_now = lambda: _true_utc() + timedelta(seconds=AHEAD)
