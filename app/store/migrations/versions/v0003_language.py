"""A person has a language."""

import sqlalchemy as sa
from alembic import op

revision = "0003"
down_revision = "0002"


def upgrade() -> None:
    """Add it, with none chosen."""
    op.add_column("person", sa.Column("language", sa.String(8)))


def downgrade() -> None:
    """Remove it."""
    op.drop_column("person", "language")
