"""Maps that follow from other maps, whether they may, and how well each trial was controlled."""

import sqlalchemy as sa
from alembic import op

revision = "0005"
down_revision = "0004"
branch_labels = None
depends_on = None


def upgrade() -> None:
    """Add them; every map so far is a calibration, and none adapts by itself."""
    op.add_column("profile", sa.Column("origin", sa.String(length=16), nullable=False, server_default="calibration"))
    op.add_column("profile", sa.Column("parent", sa.Integer(), nullable=True))
    op.add_column("profile", sa.Column("difference", sa.JSON(), nullable=True))
    op.add_column("patient", sa.Column("adaptation", sa.String(length=8), nullable=False, server_default="off"))
    op.add_column("trial", sa.Column("quality", sa.JSON(), nullable=True))


def downgrade() -> None:
    """Forget them: an adapted map stays, as one among the calibrations."""
    op.drop_column("trial", "quality")
    op.drop_column("patient", "adaptation")
    op.drop_column("profile", "difference")
    op.drop_column("profile", "parent")
    op.drop_column("profile", "origin")
