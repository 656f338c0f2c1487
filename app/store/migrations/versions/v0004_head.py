"""The head tracker in use."""

import sqlalchemy as sa
from alembic import op

revision = "0004"
down_revision = "0003"
branch_labels = None
depends_on = None


def upgrade() -> None:
    """Add where its configuration is kept; none is in use yet."""
    op.add_column("clinic", sa.Column("head", sa.JSON(), nullable=True))


def downgrade() -> None:
    """Forget it."""
    op.drop_column("clinic", "head")
