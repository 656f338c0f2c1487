"""The long-lived parts of the web process, each found by its class."""

from collections.abc import Awaitable, Callable
from dataclasses import fields
from typing import Any, TypeVar, cast, get_type_hints

from fastapi import FastAPI
from starlette.requests import HTTPConnection

Part = TypeVar("Part")


class Parts:
    """The parts of the web process, which live as long as it does, also while no page is open."""

    def __init__(self) -> None:
        self._by_class: dict[type, Any] = {}

    def add(self, kind: type[Part], part: Part) -> Part:
        """Add the only part of this class, and return it."""
        if kind in self._by_class:
            raise ValueError(f"there is a {kind.__name__} already")
        self._by_class[kind] = part
        return part

    def __getitem__(self, kind: type[Part]) -> Part:
        """Return the part of this class."""
        return cast(Part, self._by_class[kind])


def parts_of(app: FastAPI) -> Parts:
    """Return the parts of an application that has started."""
    parts: Parts = app.state.parts
    return parts


def part(kind: type[Part]) -> Callable[[HTTPConnection], Awaitable[Part]]:
    """Return the dependency that finds the part of this class.

    It is async, so that FastAPI starts no thread for it: Stop needs its parts at once.
    """

    async def find(connection: HTTPConnection) -> Part:
        return parts_of(connection.app)[kind]

    return find


def parts_for(kind: type[Part]) -> Callable[[HTTPConnection], Awaitable[Part]]:
    """Return the dependency that makes an object of this data class; each of its fields is a part of that class."""
    classes = {field.name: get_type_hints(kind)[field.name] for field in fields(cast(Any, kind))}

    async def make(connection: HTTPConnection) -> Part:
        parts = parts_of(connection.app)
        return kind(**{name: parts[kind_of_part] for name, kind_of_part in classes.items()})

    return make
