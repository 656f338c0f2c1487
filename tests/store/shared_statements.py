"""Each statement is compiled once for all databases of a process of the tests.

SQLAlchemy keeps the SQL of a statement with the engine that first executed it. The program has one engine; here most
tests have one of their own, and spent more time on the SQL of the same statements than on anything else.
"""

from typing import Any

from sqlalchemy.dialects.sqlite.pysqlite import SQLiteDialect_pysqlite
from sqlalchemy.engine import Engine
from sqlalchemy.util import LRUCache

MOST_STATEMENTS = 3000


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
