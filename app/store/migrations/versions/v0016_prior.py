"""The clinic's own prior: an entry per patient and shirt, and the owner's switch."""

import sqlalchemy as sa
from alembic import op

revision = "0016"
down_revision = "0015"
branch_labels = None
depends_on = None


def upgrade() -> None:
    """Add both tables; earlier calibrations add nothing."""
    op.create_table(
        "prior_entry",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("patient_id", sa.Integer(), nullable=False),
        sa.Column("shirt", sa.String(64), nullable=False),
        sa.Column("simulated", sa.Boolean(), nullable=False),
        sa.Column("document", sa.JSON(), nullable=False),
        sa.Column("made", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["patient_id"], ["patient.id"], name="fk_prior_entry_patient_id"),
        sa.PrimaryKeyConstraint("id", name="pk_prior_entry"),
        sa.UniqueConstraint("patient_id", "shirt", "simulated", name="uq_prior_entry_patient_id_shirt_simulated"),
    )
    op.create_table(
        "prior_switch",
        sa.Column("clinic_id", sa.Integer(), nullable=False),
        sa.Column("on", sa.Boolean(), nullable=False),
        sa.ForeignKeyConstraint(["clinic_id"], ["clinic.id"], name="fk_prior_switch_clinic_id"),
        sa.PrimaryKeyConstraint("clinic_id", name="pk_prior_switch"),
    )


def downgrade() -> None:
    """Drop them: an older program knows no prior."""
    op.drop_table("prior_switch")
    op.drop_table("prior_entry")
