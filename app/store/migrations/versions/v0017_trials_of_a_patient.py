"""An index of the trials by their patient, by which the list of patients counts them without reading their measures."""

from alembic import op

revision = "0017"
down_revision = "0016"
branch_labels = None
depends_on = None


def upgrade() -> None:
    """Add it."""
    op.create_index("ix_trial_patient_id_status_kept", "trial", ["patient_id", "status", "kept"], unique=False)


def downgrade() -> None:
    """Drop it: an older program reads every trial of a patient."""
    op.drop_index("ix_trial_patient_id_status_kept", table_name="trial")
