"""Comments on moments of trials with their revisions and readings; share links and their visits."""

import sqlalchemy as sa
from alembic import op

revision = "0012"
down_revision = "0011"
branch_labels = None
depends_on = None


def _moment(name: str, *, nullable: bool = False) -> sa.Column[object]:
    return sa.Column(name, sa.DateTime(timezone=True), nullable=nullable)


def _number(name: str, *, nullable: bool = False) -> sa.Column[object]:
    return sa.Column(name, sa.Integer(), nullable=nullable)


def _table(name: str, parents: dict[str, str], *columns: sa.schema.SchemaItem, key: tuple[str, ...] = ("id",)) -> None:
    """Create a table; `parents` are its columns that refer to the id of a table, by name."""
    op.create_table(
        name,
        *columns,
        *(
            sa.ForeignKeyConstraint([column], [f"{parent}.id"], name=f"fk_{name}_{column}")
            for column, parent in parents.items()
        ),
        sa.PrimaryKeyConstraint(*key, name=f"pk_{name}"),
    )


def upgrade() -> None:
    """Add the tables."""
    _table(
        "moment_comment",
        {"clinic_id": "clinic", "trial_id": "trial", "person_id": "person"},
        *(_number(name) for name in ("id", "clinic_id", "trial_id", "person_id")),
        sa.Column("t", sa.Float(), nullable=False),
        _moment("withdrawn", nullable=True),
    )
    op.create_index("ix_moment_comment_trial_id", "moment_comment", ["trial_id"])
    _table(
        "comment_revision",
        {"comment_id": "moment_comment"},
        *(_number(name) for name in ("id", "comment_id")),
        sa.Column("text", sa.String(length=2000), nullable=False),
        _moment("written"),
    )
    op.create_index("ix_comment_revision_comment_id", "comment_revision", ["comment_id"])
    _table(
        "comment_reading",
        {"comment_id": "moment_comment", "person_id": "person", "revision_id": "comment_revision"},
        *(_number(name) for name in ("comment_id", "person_id", "revision_id")),
        key=("comment_id", "person_id"),
    )
    _table(
        "share_link",
        {"clinic_id": "clinic", "patient_id": "patient", "session_id": "session"},
        *(_number(name) for name in ("id", "clinic_id", "patient_id")),
        _number("session_id", nullable=True),
        sa.Column("token_hash", sa.String(length=64), nullable=False),
        sa.Column("pin_hash", sa.String(), nullable=False),
        sa.Column("person", sa.String(length=80), nullable=False),
        *(_moment(name) for name in ("created", "expires")),
        _moment("revoked", nullable=True),
        *(_number(name) for name in ("wrong_pins", "openings")),
        sa.UniqueConstraint("token_hash", name="uq_share_link_token_hash"),
    )
    op.create_index("ix_share_link_patient_id", "share_link", ["patient_id"])
    _table(
        "share_visit",
        {"share_id": "share_link"},
        *(_number(name) for name in ("id", "share_id")),
        sa.Column("token_hash", sa.String(length=64), nullable=False),
        _moment("expires"),
        sa.UniqueConstraint("token_hash", name="uq_share_visit_token_hash"),
    )
    op.create_index("ix_share_visit_share_id", "share_visit", ["share_id"])


def downgrade() -> None:
    """Drop them: an older program knows neither comments nor share links."""
    for table in ("share_visit", "share_link", "comment_reading", "comment_revision", "moment_comment"):
        op.drop_table(table)
