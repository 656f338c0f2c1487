"""Whether a person has put away the sentences for a first time."""

import sqlalchemy as sa
from alembic import op

revision = "0009"
down_revision = "0008"
branch_labels = None
depends_on = None


def upgrade() -> None:
    """Nobody has seen the sentences before."""
    op.add_column("person", sa.Column("introduced", sa.Boolean(), nullable=False, server_default="0"))


def downgrade() -> None:
    """Drop it: an older program has no such sentences."""
    op.drop_column("person", "introduced")
