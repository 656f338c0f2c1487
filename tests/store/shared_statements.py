"""Each statement is compiled once for all databases of a process of the tests, those that make the tables, too.

SQLAlchemy keeps the SQL of a statement with the engine that first executed it. The program has one engine; here most
tests have one of their own, and spent more time on the SQL of the same statements than on anything else.
"""

from typing import Any

from sqlalchemy.dialects.sqlite.pysqlite import SQLiteDialect_pysqlite
from sqlalchemy.engine import Engine
from sqlalchemy.util import LRUCache

from app.store import schema

MOST_STATEMENTS = 3000
OF_TABLES = "SELECT sql FROM sqlite_master WHERE sql IS NOT NULL AND name NOT LIKE 'sqlite_%' ORDER BY rowid"


def share_statements() -> None:
    """Let all engines use one store of compiled statements; it takes their dialects, which are alike, for equal."""
    compiled: LRUCache[Any, Any] = LRUCache(MOST_STATEMENTS)
    make = Engine.__init__

    def make_sharing(engine: Engine, *given: Any, **named: Any) -> None:
        make(engine, *given, **named)
        engine._compiled_cache = compiled

    Engine.__init__ = make_sharing  # type: ignore[assignment,method-assign]
    SQLiteDialect_pysqlite.__eq__ = lambda one, other: type(one) is type(other)  # type: ignore[method-assign]
    SQLiteDialect_pysqlite.__hash__ = lambda one: hash(type(one))  # type: ignore[assignment,method-assign]
    _share_tables()


def _share_tables() -> None:
    """Let a new database repeat the statements that made the tables of the first one."""
    make = schema._make_tables
    statements: list[str] = []

    def make_sharing(engine: Engine) -> None:
        if not statements:
            make(engine)
            with engine.connect() as connection:
                statements.extend(sql for (sql,) in connection.exec_driver_sql(OF_TABLES))
            return
        with engine.begin() as connection:
            for statement in statements:
                connection.exec_driver_sql(statement)
            connection.exec_driver_sql("INSERT INTO alembic_version (version_num) VALUES (?)", (schema.NEWEST,))

    schema._make_tables = make_sharing
