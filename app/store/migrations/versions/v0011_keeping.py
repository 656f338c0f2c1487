"""How long records are kept: settings, erased patients, patients' uploads, incidents, backups; the reason to delete."""

import sqlalchemy as sa
from alembic import op

revision = "0011"
down_revision = "0010"
branch_labels = None
depends_on = None


def upgrade() -> None:
    """Make the tables; nothing is known of what was before."""
    op.add_column("patient", sa.Column("deletion_reason", sa.String(400), nullable=True))
    op.create_table(
        "record_keeping",
        sa.Column("clinic_id", sa.Integer(), nullable=False),
        sa.Column("years", sa.Integer(), nullable=True),
        sa.Column("folder", sa.String(), nullable=True),
        sa.Column("hour", sa.Integer(), nullable=False, server_default="2"),
        sa.Column("with_keys", sa.Boolean(), nullable=False, server_default="0"),
        sa.ForeignKeyConstraint(["clinic_id"], ["clinic.id"], name="fk_record_keeping_clinic_id"),
        sa.PrimaryKeyConstraint("clinic_id", name="pk_record_keeping"),
    )
    op.create_table(
        "erased_patient",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("created", sa.DateTime(timezone=True), nullable=False),
        sa.Column("erased", sa.DateTime(timezone=True), nullable=False),
        sa.Column("files", sa.JSON(), nullable=False),
        sa.PrimaryKeyConstraint("id", name="pk_erased_patient"),
    )
    op.create_table(
        "last_id",
        sa.Column("name", sa.String(64), nullable=False),
        sa.Column("id", sa.Integer(), nullable=False),
        sa.PrimaryKeyConstraint("name", name="pk_last_id"),
    )
    op.create_table(
        "patient_file",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("patient_id", sa.Integer(), nullable=False),
        sa.Column("name", sa.String(80), nullable=False),
        sa.Column("current", sa.Boolean(), nullable=False),
        sa.ForeignKeyConstraint(["patient_id"], ["patient.id"], name="fk_patient_file_patient_id"),
        sa.PrimaryKeyConstraint("id", name="pk_patient_file"),
    )
    op.create_index("ix_patient_file_patient_id", "patient_file", ["patient_id"])
    op.create_table(
        "incident",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("clinic_id", sa.Integer(), nullable=False),
        sa.Column("made", sa.DateTime(timezone=True), nullable=False),
        sa.Column("since", sa.DateTime(timezone=True), nullable=False),
        sa.Column("hash", sa.String(64), nullable=False),
        sa.Column("lifted", sa.DateTime(timezone=True), nullable=True),
        sa.Column("reason", sa.String(400), nullable=True),
        sa.ForeignKeyConstraint(["clinic_id"], ["clinic.id"], name="fk_incident_clinic_id"),
        sa.PrimaryKeyConstraint("id", name="pk_incident"),
    )
    op.create_table(
        "incident_patient",
        sa.Column("incident_id", sa.Integer(), nullable=False),
        sa.Column("patient_id", sa.Integer(), nullable=False),
        sa.ForeignKeyConstraint(["incident_id"], ["incident.id"], name="fk_incident_patient_incident_id"),
        sa.ForeignKeyConstraint(["patient_id"], ["patient.id"], name="fk_incident_patient_patient_id"),
        sa.PrimaryKeyConstraint("incident_id", "patient_id", name="pk_incident_patient"),
    )
    op.create_table(
        "made_backup",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("place", sa.String(), nullable=False),
        sa.Column("name", sa.String(80), nullable=False),
        sa.Column("in_folder", sa.Boolean(), nullable=False),
        sa.Column("good", sa.Boolean(), nullable=False),
        sa.Column("words", sa.String(400), nullable=False),
        sa.Column("files", sa.Integer(), nullable=False),
        sa.Column("bytes", sa.Integer(), nullable=False),
        sa.Column("encrypted", sa.Boolean(), nullable=False),
        sa.Column("with_keys", sa.Boolean(), nullable=False),
        sa.PrimaryKeyConstraint("id", name="pk_made_backup"),
    )
    op.create_index("ix_made_backup_at", "made_backup", ["at"])


def downgrade() -> None:
    """Drop them: an older program deletes nobody for good."""
    for name in (
        *("made_backup", "incident_patient", "incident", "patient_file", "last_id", "erased_patient"),
        "record_keeping",
    ):
        op.drop_table(name)
    op.drop_column("patient", "deletion_reason")
