"""The settings of backups get a table of their own, of the feature `backup`; `made_backup.words` becomes `message`."""

import sqlalchemy as sa
from alembic import op

revision = "0002"
down_revision = "0001"

SETTINGS = "folder, hour, with_keys"


def _rename(before: str, now: str) -> None:
    """Rename a column of `made_backup`, which a program without the feature `backup` has not made."""
    if sa.inspect(op.get_bind()).has_table("made_backup"):
        with op.batch_alter_table("made_backup") as table:
            table.alter_column(before, new_column_name=now)


def upgrade() -> None:
    """Move folder, hour and keys out of `record_keeping`."""
    op.create_table(
        "backup_settings",
        sa.Column("clinic_id", sa.Integer(), sa.ForeignKey("clinic.id"), primary_key=True),
        sa.Column("folder", sa.String()),
        sa.Column("hour", sa.Integer(), nullable=False),
        sa.Column("with_keys", sa.Boolean(), nullable=False),
    )
    op.execute(f"INSERT INTO backup_settings SELECT clinic_id, {SETTINGS} FROM record_keeping")  # noqa: S608
    with op.batch_alter_table("record_keeping") as table:
        for name in ("folder", "hour", "with_keys"):
            table.drop_column(name)
    _rename("words", "message")


def downgrade() -> None:
    """Move them back."""
    _rename("message", "words")
    with op.batch_alter_table("record_keeping") as table:
        table.add_column(sa.Column("folder", sa.String()))
        table.add_column(sa.Column("hour", sa.Integer(), nullable=False, server_default="2"))
        table.add_column(sa.Column("with_keys", sa.Boolean(), nullable=False, server_default="0"))
    op.execute(
        "INSERT INTO record_keeping (clinic_id) SELECT clinic_id FROM backup_settings "
        "WHERE clinic_id NOT IN (SELECT clinic_id FROM record_keeping)"
    )
    op.execute(
        f"UPDATE record_keeping SET ({SETTINGS}) = (SELECT {SETTINGS} FROM backup_settings AS own "  # noqa: S608
        "WHERE own.clinic_id = record_keeping.clinic_id) WHERE clinic_id IN (SELECT clinic_id FROM backup_settings)"
    )
    op.drop_table("backup_settings")
