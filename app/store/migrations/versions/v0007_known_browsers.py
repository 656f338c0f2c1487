"""Browsers in which a person has signed in before."""

import sqlalchemy as sa
from alembic import op

revision = "0007"
down_revision = "0006"
branch_labels = None
depends_on = None


def upgrade() -> None:
    """Add the known browsers; until somebody signs in there are none."""
    op.create_table(
        "known_browser",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("person_id", sa.Integer(), nullable=False),
        sa.Column("token_hash", sa.String(length=64), nullable=False),
        sa.Column("created", sa.DateTime(timezone=True), nullable=False),
        sa.Column("expires", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["person_id"], ["person.id"], name="fk_known_browser_person_id"),
        sa.PrimaryKeyConstraint("id", name="pk_known_browser"),
        sa.UniqueConstraint("token_hash", name="uq_known_browser_token_hash"),
    )
    op.create_index("ix_known_browser_person_id", "known_browser", ["person_id"], unique=False)


def downgrade() -> None:
    """Forget the known browsers: the next sign-in makes them known again."""
    op.drop_index("ix_known_browser_person_id", table_name="known_browser")
    op.drop_table("known_browser")
