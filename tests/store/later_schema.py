"""A migration after the newest one, for tests of upgrades: it adds a column to the patients."""

import shutil
from pathlib import Path

import pytest

from app.store import schema
from app.store.schema import MIGRATIONS, NEWEST

LATER = "9999"
COLUMN = "colour"
MIGRATION = f'''"""A later schema."""

import sqlalchemy as sa
from alembic import op

revision = "{LATER}"
down_revision = "{NEWEST}"


def upgrade() -> None:
    """Add a column."""
    op.add_column("patient", sa.Column("{COLUMN}", sa.String(8)))


def downgrade() -> None:
    """Drop it."""
    op.drop_column("patient", "{COLUMN}")
'''


def add_later_migration(migrations: Path) -> None:
    """Write the migration into a copy of the folder of migrations."""
    (migrations / "versions" / f"v{LATER}_later.py").write_text(MIGRATION, encoding="utf-8")


def use_later_schema(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Let this program know the later migration, from a copy of its migrations in `folder`."""
    migrations = Path(shutil.copytree(MIGRATIONS, folder / "migrations"))
    add_later_migration(migrations)
    monkeypatch.setattr(schema, "MIGRATIONS", migrations)
    monkeypatch.setattr(schema, "NEWEST", LATER)
