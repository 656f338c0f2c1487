"""Screens that a patient looks at, paired for one visit, and what they show."""

import sqlalchemy as sa
from alembic import op

revision = "0003"
down_revision = "0002"
branch_labels = None
depends_on = None


def upgrade() -> None:
    """Add the patient's screens; the visits that were show what a new one does."""
    op.add_column("session", sa.Column("screen", sa.JSON(), nullable=True))
    op.create_table(
        "patient_screen",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("clinic_id", sa.Integer(), nullable=False),
        sa.Column("session_id", sa.Integer(), nullable=False),
        sa.Column("token_hash", sa.String(length=64), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("paired", sa.DateTime(timezone=True), nullable=False),
        sa.Column("expires", sa.DateTime(timezone=True), nullable=False),
        sa.Column("unpaired", sa.DateTime(timezone=True), nullable=True),
        sa.ForeignKeyConstraint(["clinic_id"], ["clinic.id"], name="fk_patient_screen_clinic_id"),
        sa.ForeignKeyConstraint(["session_id"], ["session.id"], name="fk_patient_screen_session_id"),
        sa.PrimaryKeyConstraint("id", name="pk_patient_screen"),
        sa.UniqueConstraint("token_hash", name="uq_patient_screen_token_hash"),
    )
    op.create_index("ix_patient_screen_session_id", "patient_screen", ["session_id"], unique=False)


def downgrade() -> None:
    """Forget the screens: they are paired anew."""
    op.drop_index("ix_patient_screen_session_id", table_name="patient_screen")
    op.drop_table("patient_screen")
    op.drop_column("session", "screen")
