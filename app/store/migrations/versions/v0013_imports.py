"""Imports: the archive that a patient came from, and the sessions that came with it."""

import sqlalchemy as sa
from alembic import op

revision = "0013"
down_revision = "0012"
branch_labels = None
depends_on = None


def upgrade() -> None:
    """Add the tables."""
    op.create_table(
        "patient_import",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("patient_id", sa.Integer(), nullable=False),
        sa.Column("archive", sa.String(64), nullable=False),
        sa.Column("clinic", sa.String(80), nullable=False),
        sa.Column("person", sa.String(80), nullable=False),
        sa.Column("at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["patient_id"], ["patient.id"], name="fk_patient_import_patient_id"),
        sa.PrimaryKeyConstraint("id", name="pk_patient_import"),
        sa.UniqueConstraint("archive", name="uq_patient_import_archive"),
    )
    op.create_index("ix_patient_import_patient_id", "patient_import", ["patient_id"], unique=False)
    op.create_table(
        "imported_session",
        sa.Column("session_id", sa.Integer(), nullable=False),
        sa.Column("import_id", sa.Integer(), nullable=False),
        sa.ForeignKeyConstraint(["session_id"], ["session.id"], name="fk_imported_session_session_id"),
        sa.ForeignKeyConstraint(["import_id"], ["patient_import.id"], name="fk_imported_session_import_id"),
        sa.PrimaryKeyConstraint("session_id", name="pk_imported_session"),
    )


def downgrade() -> None:
    """Drop them: an older program does not know where patients came from."""
    op.drop_table("imported_session")
    op.drop_index("ix_patient_import_patient_id", table_name="patient_import")
    op.drop_table("patient_import")
