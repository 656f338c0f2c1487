"""The group of a run's source, in queries."""

from typing import Final

from sqlalchemy import ColumnElement, case

from app.source import OWN_GROUPS, SourceGroup
from app.store.tables import Run

RUN_GROUP: Final[ColumnElement[SourceGroup]] = case(
    (Run.simulated.is_(None), "unknown"),
    (Run.simulated.is_(True), "simulated"),
    *((Run.shirt == shirt, group) for shirt, group in OWN_GROUPS.items()),
    else_="worn",
)
"""What `Source.group` returns of a run's source."""


def is_of_group(group: SourceGroup) -> ColumnElement[bool]:
    """Return the condition that a run's source is of this group."""
    return RUN_GROUP == group  # noqa: SIM300  (a column, no constant)
