"""An index of the trials by their task, which verdicts of a large clinic count and read."""

from alembic import op

revision = "0014"
down_revision = "0013"
branch_labels = None
depends_on = None


def upgrade() -> None:
    """Add it."""
    op.create_index("ix_trial_floorplan_path_status", "trial", ["floorplan", "path", "status"], unique=False)


def downgrade() -> None:
    """Drop it: an older program searches all trials."""
    op.drop_index("ix_trial_floorplan_path_status", table_name="trial")
