"""What Alembic runs for each migration; the connection comes from app/store/database.py."""

from alembic import context

from app.store.access import person_tables  # noqa: F401  (its tables belong to the metadata)
from app.store.keeping import keeping_tables  # noqa: F401
from app.store.prior import prior_tables  # noqa: F401
from app.store.records import import_tables, record_tables  # noqa: F401  (so do these)
from app.store.sharing import sharing_tables  # noqa: F401
from app.store.tables import Table

context.configure(
    connection=context.config.attributes["connection"],
    target_metadata=Table.metadata,
    render_as_batch=True,  # SQLite alters a table by making it anew
)
with context.begin_transaction():
    context.run_migrations()
