"""The record of a session: goal, version of the software, notes, scales, sign-offs; and the consents of patients."""

import sqlalchemy as sa
from alembic import op

revision = "0010"
down_revision = "0009"
branch_labels = None
depends_on = None

# Who was recorded in a shirt before consents were kept here keeps the consent to recording, since that first day and
# with no person's name; the pages ask to confirm it (docs/decisions/0024). The other consents begin as not given.
CARRY_OVER = """
    INSERT INTO patient_consent (patient_id, consent, given, person, written, withdrawn, withdrawn_by)
    SELECT session.patient_id, 'recording', date(MIN(run.started)), NULL,
           strftime('%Y-%m-%d %H:%M:%S.000000', 'now'), NULL, NULL
    FROM run JOIN session ON session.id = run.session_id
    WHERE run.simulated IS NOT 1
    GROUP BY session.patient_id
"""


def _moment(name: str, *, nullable: bool = False) -> sa.Column[object]:
    return sa.Column(name, sa.DateTime(timezone=True), nullable=nullable)


def _table(name: str, parent: str, *columns: sa.Column[object]) -> None:
    """Create a table whose rows belong to a row of `parent`."""
    key = "note_id" if parent == "session_note" else f"{parent}_id"
    op.create_table(
        name,
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column(key, sa.Integer(), nullable=False),
        *columns,
        sa.ForeignKeyConstraint([key], [f"{parent}.id"], name=f"fk_{name}_{key}"),
        sa.PrimaryKeyConstraint("id", name=f"pk_{name}"),
    )
    op.create_index(f"ix_{name}_{key}", name, [key])


def _one_in_force(table: str, columns: list[str], condition: str) -> None:
    op.create_index(f"uq_{table}_in_force", table, columns, unique=True, sqlite_where=sa.text(condition))


def upgrade() -> None:
    """Add the tables and the columns of the session."""
    op.add_column("session", sa.Column("goal", sa.String(length=1000), nullable=False, server_default=""))
    op.add_column("session", sa.Column("version", sa.String(length=40), nullable=False, server_default=""))
    _table("session_note", "session")
    _table(
        "note_revision",
        "session_note",
        sa.Column("text", sa.String(length=8000), nullable=False),
        sa.Column("person", sa.String(length=80), nullable=False),
        _moment("written"),
    )
    _table(
        "outcome_scale",
        "session",
        sa.Column("name", sa.String(length=80), nullable=False),
        sa.Column("total", sa.Float(), nullable=False),
        sa.Column("day", sa.Date(), nullable=False),
    )
    _table(
        "session_sign_off",
        "session",
        sa.Column("person", sa.String(length=80), nullable=False),
        _moment("at"),
        _moment("unlocked", nullable=True),
        sa.Column("unlocked_by", sa.String(length=80), nullable=True),
        sa.Column("reason", sa.String(length=200), nullable=True),
    )
    _one_in_force("session_sign_off", ["session_id"], "unlocked IS NULL")
    _table(
        "patient_consent",
        "patient",
        sa.Column("consent", sa.String(length=16), nullable=False),
        sa.Column("given", sa.Date(), nullable=False),
        sa.Column("person", sa.String(length=80), nullable=True),
        _moment("written"),
        _moment("withdrawn", nullable=True),
        sa.Column("withdrawn_by", sa.String(length=80), nullable=True),
    )
    _one_in_force("patient_consent", ["patient_id", "consent"], "withdrawn IS NULL")
    op.execute(CARRY_OVER)


def downgrade() -> None:
    """Drop them: an older program knows neither records nor consents."""
    for table in ("patient_consent", "session_sign_off", "outcome_scale", "note_revision", "session_note"):
        op.drop_table(table)
    for column in ("version", "goal"):
        op.drop_column("session", column)
