"""Indexes of keys to other tables, and of a patient's trials in a task: they are found without reading everybody's."""

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
TASK = "ix_trial_patient_id_floorplan_path_status"


def upgrade() -> None:
    """Add them."""
    for table, column in KEYS:
        op.create_index(f"ix_{table}_{column}", table, [column], unique=False)
    op.create_index(TASK, "trial", ["patient_id", "floorplan", "path", "status"], unique=False)


def downgrade() -> None:
    """Drop them: an older program reads the whole table."""
    op.drop_index(TASK, table_name="trial")
    for table, column in reversed(KEYS):
        op.drop_index(f"ix_{table}_{column}", table_name=table)
