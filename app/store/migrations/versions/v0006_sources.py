"""The source of each run and map: worn or simulated; and who opened a session.

What older databases know of it stands in their log: each choice of a shirt and of a body, with its time. Until the
first choice the program of that time had opened the simulated shirt with the simulated person by itself. A run whose
chair neither a trial nor a drive names has an unknown chair.
"""

from datetime import datetime
from typing import Any, NamedTuple

import sqlalchemy as sa
from alembic import op

revision = "0006"
down_revision = "0005"
branch_labels = None
depends_on = None

NOT_WORN = {"simulator", "replay"}  # the shirts of that time that nobody wears


class Choice(NamedTuple):
    """The shirt and the body that were in use from the moment `since` on."""

    since: datetime
    shirt: str
    body: str | None


RUN = sa.table("run", *map(sa.column, ("id", "shirt", "body", "chair", "simulated")), sa.column("started", sa.DateTime))
PROFILE = sa.table("profile", sa.column("id"), sa.column("simulated"), sa.column("created", sa.DateTime))
LOG = sa.table("log", sa.column("id"), sa.column("at", sa.DateTime), sa.column("what"), sa.column("details", sa.JSON))


def upgrade() -> None:
    """Add the columns, and fill them from the log and the tables."""
    op.add_column("run", sa.Column("shirt", sa.String(length=32), nullable=False, server_default="unknown"))
    op.add_column("run", sa.Column("body", sa.String(length=32), nullable=True))
    op.add_column("run", sa.Column("chair", sa.String(length=32), nullable=False, server_default="unknown"))
    op.add_column("run", sa.Column("simulated", sa.Boolean(), nullable=True))
    op.add_column("profile", sa.Column("simulated", sa.Boolean(), nullable=True))
    op.add_column("session", sa.Column("opened_by", sa.String(length=80), nullable=True))
    database = op.get_bind()
    choices = _choices(database)
    for row in database.execute(sa.select(RUN.c.id, RUN.c.started)).all():
        known = _at(choices, row.started)
        found = {"shirt": known.shirt, "body": known.body, "simulated": known.shirt in NOT_WORN}
        database.execute(sa.update(RUN).where(RUN.c.id == row.id).values(**found))
    for row in database.execute(sa.select(PROFILE.c.id, PROFILE.c.created)).all():
        simulated = _at(choices, row.created).shirt in NOT_WORN
        database.execute(sa.update(PROFILE).where(PROFILE.c.id == row.id).values(simulated=simulated))
    for table, chair in (("trial", "virtual"), ("drive", "udp")):
        named = sa.select(sa.table(table, sa.column("run_id")).c.run_id)
        database.execute(sa.update(RUN).where(RUN.c.id.in_(named)).values(chair=chair))


def downgrade() -> None:
    """Drop the columns."""
    op.drop_column("session", "opened_by")
    op.drop_column("profile", "simulated")
    for name in ("simulated", "chair", "body", "shirt"):
        op.drop_column("run", name)


def _choices(database: Any) -> list[Choice]:
    """Return which shirt and body were in use from when on, the oldest first."""
    choices = [Choice(datetime.min, "simulator", "person")]  # noqa: DTZ901  (SQLite's moments have no zone)
    wanted = sa.select(LOG).where(LOG.c.what.in_(("shirt chosen", "body chosen"))).order_by(LOG.c.id)
    for row in database.execute(wanted).all():
        kind, now = str(row.details.get("kind", "unknown")), choices[-1]
        if row.what == "body chosen":
            choices.append(Choice(row.at, now.shirt, kind))
        else:
            choices.append(Choice(row.at, kind, (now.body or "person") if kind == "simulator" else None))
    return choices


def _at(choices: list[Choice], moment: datetime) -> Choice:
    return [choice for choice in choices if choice.since <= moment][-1]
