"""Real chairs and their drives, the chair in use, and the clinic's own limits."""

import sqlalchemy as sa
from alembic import op

revision = "0002"
down_revision = "0001"
branch_labels = None
depends_on = None


def upgrade() -> None:
    """Add what the real chair needs; who is there goes on with the virtual one, without limits of their own."""
    op.add_column("clinic", sa.Column("chair", sa.JSON(), nullable=True))
    op.add_column("clinic", sa.Column("limits", sa.JSON(), nullable=True))
    op.create_table(
        "chair",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("clinic_id", sa.Integer(), nullable=False),
        sa.Column("name", sa.String(length=80), nullable=False),
        sa.Column("host", sa.String(length=253), nullable=False),
        sa.Column("port", sa.Integer(), nullable=False),
        sa.Column("key_id", sa.Integer(), nullable=False),
        sa.Column("speeds", sa.JSON(), nullable=False),
        sa.Column("paired", sa.DateTime(timezone=True), nullable=False),
        sa.Column("removed", sa.DateTime(timezone=True), nullable=True),
        sa.ForeignKeyConstraint(["clinic_id"], ["clinic.id"], name="fk_chair_clinic_id"),
        sa.PrimaryKeyConstraint("id", name="pk_chair"),
        sa.UniqueConstraint("clinic_id", "key_id", name="uq_chair_clinic_id_key_id"),
    )
    op.create_table(
        "drive",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("clinic_id", sa.Integer(), nullable=False),
        sa.Column("patient_id", sa.Integer(), nullable=False),
        sa.Column("session_id", sa.Integer(), nullable=False),
        sa.Column("run_id", sa.String(length=36), nullable=False),
        sa.Column("chair_id", sa.Integer(), nullable=False),
        sa.Column("parameters_id", sa.Integer(), nullable=False),
        sa.Column("hash", sa.String(length=64), nullable=False),
        sa.Column("started", sa.DateTime(timezone=True), nullable=False),
        sa.Column("ended", sa.DateTime(timezone=True), nullable=True),
        sa.Column("end", sa.String(length=16), nullable=True),
        sa.Column("distance", sa.Float(), nullable=True),
        sa.ForeignKeyConstraint(["chair_id"], ["chair.id"], name="fk_drive_chair_id"),
        sa.ForeignKeyConstraint(["clinic_id"], ["clinic.id"], name="fk_drive_clinic_id"),
        sa.ForeignKeyConstraint(["parameters_id"], ["parameters.id"], name="fk_drive_parameters_id"),
        sa.ForeignKeyConstraint(["patient_id"], ["patient.id"], name="fk_drive_patient_id"),
        sa.ForeignKeyConstraint(["run_id"], ["run.id"], name="fk_drive_run_id"),
        sa.ForeignKeyConstraint(["session_id"], ["session.id"], name="fk_drive_session_id"),
        sa.PrimaryKeyConstraint("id", name="pk_drive"),
    )
    op.create_index("ix_drive_patient_id", "drive", ["patient_id"], unique=False)


def downgrade() -> None:
    """Forget the real chairs and their drives; their recordings and runs stay."""
    op.drop_index("ix_drive_patient_id", table_name="drive")
    op.drop_table("drive")
    op.drop_table("chair")
    op.drop_column("clinic", "limits")
    op.drop_column("clinic", "chair")
