"""Comments whose author is a person of another clinic: they came with an archive."""

import sqlalchemy as sa
from alembic import op

revision = "0018"
down_revision = "0017"
branch_labels = None
depends_on = None

TABLES = ("moment_comment", "comment_revision", "comment_reading")  # each after those that it refers to
FOR_NOW = "before_{}"


def upgrade() -> None:
    """Let a comment have the name of an author elsewhere in place of a person of this clinic."""
    _put_aside()
    _make_tables(author=True)
    op.execute(
        "INSERT INTO moment_comment (id, clinic_id, trial_id, person_id, t, withdrawn) "
        "SELECT id, clinic_id, trial_id, person_id, t, withdrawn FROM before_moment_comment"
    )
    _bring_back("")


def downgrade() -> None:
    """Drop the comments of people elsewhere: an older program shows none without a person of this clinic."""
    _put_aside()
    _make_tables(author=False)
    op.execute(
        "INSERT INTO moment_comment SELECT id, clinic_id, trial_id, person_id, t, withdrawn "
        "FROM before_moment_comment WHERE person_id IS NOT NULL"
    )
    _bring_back(" WHERE comment_id IN (SELECT id FROM moment_comment)")


def _put_aside() -> None:
    """Copy the rows, and drop the tables: SQLite cannot change a column, nor drop a table that others refer to."""
    for name in TABLES:
        op.execute(f"CREATE TABLE {FOR_NOW.format(name)} AS SELECT * FROM {name}")  # noqa: S608
    for name in reversed(TABLES):
        op.drop_table(name)


def _bring_back(which: str) -> None:
    for name in TABLES[1:]:
        op.execute(f"INSERT INTO {name} SELECT * FROM {FOR_NOW.format(name)}{which}")  # noqa: S608  (no foreign text)
    for name in TABLES:
        op.drop_table(FOR_NOW.format(name))


def _make_tables(*, author: bool) -> None:
    op.create_table(
        "moment_comment",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("clinic_id", sa.Integer(), nullable=False),
        sa.Column("trial_id", sa.Integer(), nullable=False),
        sa.Column("person_id", sa.Integer(), nullable=author),
        *([sa.Column("author", sa.String(80), nullable=True)] if author else []),
        sa.Column("t", sa.Float(), nullable=False),
        sa.Column("withdrawn", sa.DateTime(timezone=True), nullable=True),
        sa.ForeignKeyConstraint(["clinic_id"], ["clinic.id"], name="fk_moment_comment_clinic_id"),
        sa.ForeignKeyConstraint(["trial_id"], ["trial.id"], name="fk_moment_comment_trial_id"),
        sa.ForeignKeyConstraint(["person_id"], ["person.id"], name="fk_moment_comment_person_id"),
        sa.PrimaryKeyConstraint("id", name="pk_moment_comment"),
    )
    op.create_index("ix_moment_comment_trial_id", "moment_comment", ["trial_id"])
    op.create_table(
        "comment_revision",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("comment_id", sa.Integer(), nullable=False),
        sa.Column("text", sa.String(2000), nullable=False),
        sa.Column("written", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["comment_id"], ["moment_comment.id"], name="fk_comment_revision_comment_id"),
        sa.PrimaryKeyConstraint("id", name="pk_comment_revision"),
    )
    op.create_index("ix_comment_revision_comment_id", "comment_revision", ["comment_id"])
    op.create_table(
        "comment_reading",
        sa.Column("comment_id", sa.Integer(), nullable=False),
        sa.Column("person_id", sa.Integer(), nullable=False),
        sa.Column("revision_id", sa.Integer(), nullable=False),
        sa.ForeignKeyConstraint(["comment_id"], ["moment_comment.id"], name="fk_comment_reading_comment_id"),
        sa.ForeignKeyConstraint(["person_id"], ["person.id"], name="fk_comment_reading_person_id"),
        sa.ForeignKeyConstraint(["revision_id"], ["comment_revision.id"], name="fk_comment_reading_revision_id"),
        sa.PrimaryKeyConstraint("comment_id", "person_id", name="pk_comment_reading"),
    )
