"""The last look at the machine's clocks: a clock that was set forward must not erase what waits for days."""

import sqlalchemy as sa
from alembic import op

revision = "0020"
down_revision = "0019"
branch_labels = None
depends_on = None


def upgrade() -> None:
    """Add the table; without a row the newest row of the log says when the program ran."""
    op.create_table(
        "passed_time",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("wall", sa.DateTime(timezone=True), nullable=False),
        sa.Column("count", sa.Float(), nullable=False),
        sa.Column("boot", sa.String(80), nullable=False),
        sa.Column("jumps", sa.JSON(), nullable=False),
        sa.PrimaryKeyConstraint("id", name="pk_passed_time"),
    )


def downgrade() -> None:
    """Drop it: an older program goes by the wall clock alone."""
    op.drop_table("passed_time")
