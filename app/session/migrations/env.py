"""What Alembic runs for each migration; the connection comes from app/session/database.py."""

from alembic import context

from app.session.tables import Table

context.configure(
    connection=context.config.attributes["connection"],
    target_metadata=Table.metadata,
    render_as_batch=True,  # SQLite alters a table by making it anew
)
with context.begin_transaction():
    context.run_migrations()
