"""Indexes of keys to other tables, and of what is asked about trials: they are found without reading them all."""

from alembic import op

revision = "0019"
down_revision = "0018"
branch_labels = None
depends_on = None

KEYS = (
    ("auth_session", "person_id"),
    ("calibration_step", "run_id"),
    ("comment_reading", "person_id"),
    ("comment_reading", "revision_id"),
    ("drive", "session_id"),
    ("drive", "run_id"),
    ("drive", "chair_id"),
    ("drive", "parameters_id"),
    ("imported_session", "import_id"),
    ("incident_patient", "patient_id"),
    ("interface_test", "parameters_id"),
    ("interface_test", "run_id"),
    ("moment_comment", "person_id"),
    ("profile", "session_id"),
    ("share_link", "session_id"),
    ("trial", "session_id"),
    ("trial", "parameters_id"),
    ("trial", "run_id"),
)
OF_TRIALS = (["patient_id", "floorplan", "path", "status"], ["clinic_id", "end", "started"])


def upgrade() -> None:
    """Add them."""
    for table, column in KEYS:
        op.create_index(f"ix_{table}_{column}", table, [column], unique=False)
    for columns in OF_TRIALS:
        op.create_index(f"ix_trial_{'_'.join(columns)}", "trial", columns, unique=False)


def downgrade() -> None:
    """Drop them: an older program reads the whole table."""
    for columns in reversed(OF_TRIALS):
        op.drop_index(f"ix_trial_{'_'.join(columns)}", table_name="trial")
    for table, column in reversed(KEYS):
        op.drop_index(f"ix_{table}_{column}", table_name=table)
