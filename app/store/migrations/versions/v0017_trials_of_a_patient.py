"""Indexes of the trials by their patient: lists count them, and find those that are compared, without reading them."""

import sqlalchemy as sa
from alembic import op

revision = "0017"
down_revision = "0016"
branch_labels = None
depends_on = None


def upgrade() -> None:
    """Add them."""
    op.create_index("ix_trial_patient_id_status_kept", "trial", ["patient_id", "status", "kept"], unique=False)
    op.create_index(
        "ix_trial_counted",
        "trial",
        ["clinic_id", "patient_id", "floorplan", "path", "run_id"],
        unique=False,
        sqlite_where=sa.text("kept = 1 AND status = 'done' AND measures != 'null'"),
    )


def downgrade() -> None:
    """Drop them: an older program reads every trial of a patient."""
    op.drop_index("ix_trial_counted", table_name="trial")
    op.drop_index("ix_trial_patient_id_status_kept", table_name="trial")
