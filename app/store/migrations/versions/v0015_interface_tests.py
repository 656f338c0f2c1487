"""Interface tests: targets reached with a cursor before driving, and how demanding that felt."""

import sqlalchemy as sa
from alembic import op

revision = "0015"
down_revision = "0014"
branch_labels = None
depends_on = None


def upgrade() -> None:
    """Add the table."""
    op.create_table(
        "interface_test",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("clinic_id", sa.Integer(), nullable=False),
        sa.Column("patient_id", sa.Integer(), nullable=False),
        sa.Column("session_id", sa.Integer(), nullable=False),
        sa.Column("parameters_id", sa.Integer(), nullable=False),
        sa.Column("run_id", sa.String(36), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("started", sa.DateTime(timezone=True), nullable=False),
        sa.Column("status", sa.String(16), nullable=False),
        sa.Column("end", sa.String(16), nullable=True),
        sa.Column("plan", sa.JSON(), nullable=False),
        sa.Column("measures", sa.JSON(), nullable=True),
        sa.Column("workload", sa.JSON(), nullable=True),
        *(
            sa.ForeignKeyConstraint([f"{name}_id"], [f"{name}.id"], name=f"fk_interface_test_{name}_id")
            for name in ("clinic", "patient", "session", "parameters", "run")
        ),
        sa.PrimaryKeyConstraint("id", name="pk_interface_test"),
        sa.UniqueConstraint("patient_id", "number", name="uq_interface_test_patient_id_number"),
    )
    op.create_index("ix_interface_test_session_id", "interface_test", ["session_id"], unique=False)


def downgrade() -> None:
    """Drop it: an older program has no interface tests; their recordings stay."""
    op.drop_index("ix_interface_test_session_id", table_name="interface_test")
    op.drop_table("interface_test")
