"""The features: what a clinic adds round calibrating and driving. Each is a folder here, and one line of this list.

A feature whose line and folder are gone leaves a program that runs (`tests/features/test_removed_features.py`).
"""

from collections.abc import Mapping
from typing import Final

NEEDS: Final[Mapping[str, tuple[str, ...]]] = {
    "records": (),
    "consents": (),
    "comments": (),
    "sharing": ("records",),
    "reports": ("records",),
    "exports": (),
    "interface_tests": (),
    "archive": (),
    "backup": (),
    "log": (),
    "prior": (),
    "lsl": (),
    "layouts": (),
}
"""Each feature with those whose service it imports: without them it is left out, too."""


def names() -> tuple[str, ...]:
    """Return the features that the program has."""
    needs_of = dict(NEEDS)
    while missing := [name for name, needs in needs_of.items() if not set(needs) <= needs_of.keys()]:
        for name in missing:
            del needs_of[name]
    return tuple(needs_of)
