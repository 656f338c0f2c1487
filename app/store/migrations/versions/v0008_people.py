"""Invitations, the patients that are shown to a reviewer, and the last action of each sign-in."""

import sqlalchemy as sa
from alembic import op

revision = "0008"
down_revision = "0007"
branch_labels = None
depends_on = None

LONG_AGO = "2000-01-01 00:00:00.000000"  # sign-ins of an older program are locked: their people give the password


def upgrade() -> None:
    """Add what invitations, reviewers of chosen patients and the idle lock need."""
    op.add_column("person", sa.Column("patients", sa.JSON(), nullable=True))
    op.add_column(
        "auth_session", sa.Column("active", sa.DateTime(timezone=True), nullable=False, server_default=LONG_AGO)
    )
    op.create_table(
        "invitation",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("person_id", sa.Integer(), nullable=False),
        sa.Column("code_hash", sa.String(length=64), nullable=False),
        sa.Column("created", sa.DateTime(timezone=True), nullable=False),
        sa.Column("expires", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["person_id"], ["person.id"], name="fk_invitation_person_id"),
        sa.PrimaryKeyConstraint("id", name="pk_invitation"),
        sa.UniqueConstraint("person_id", name="uq_invitation_person_id"),
        sa.UniqueConstraint("code_hash", name="uq_invitation_code_hash"),
    )


def downgrade() -> None:
    """Drop them, and disable reviewers of chosen patients: an older program would show them every patient."""
    op.execute(
        "UPDATE person SET disabled = CURRENT_TIMESTAMP || '.000000' "
        "WHERE disabled IS NULL AND patients IS NOT NULL AND patients != 'null'"
    )
    op.drop_table("invitation")
    op.drop_column("auth_session", "active")
    op.drop_column("person", "patients")
