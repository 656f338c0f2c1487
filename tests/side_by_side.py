"""`python tests/side_by_side.py 4`: prints how many tests of whole programs run side by side, at most 4.

Whole programs work by the clock: on a slow processor, too many of them leave each other no time, and a page whose
picture comes late stops its chair again and again. Half as many are quicker there, and none of them is late.
"""

import sys
import time

ADDITIONS = 1_000_000  # the yardstick of a processor
QUICK = 0.08  # s; with 0.14 s, two browser tests side by side took longer than one after the other, and failed
ATTEMPTS = 5  # the quickest counts: other work slows down some of them


def pace() -> float:
    """Return the time (s) that this machine needs for `ADDITIONS`."""
    times = []
    for _ in range(ATTEMPTS):
        begin, total = time.perf_counter(), 0
        for number in range(ADDITIONS):
            total += number
        times.append(time.perf_counter() - begin)
    return min(times)


def side_by_side(most: int, needed: float) -> int:
    """Return how many tests run side by side on a machine that needs so long (s) for `ADDITIONS`."""
    return most if needed <= QUICK else max(1, most // 2)


if __name__ == "__main__":
    sys.stdout.write(f"{side_by_side(int(sys.argv[1]), pace())}\n")
