"""The stored choice of the head tracker."""

import asyncio
from typing import Any

import pytest

from app.refusals import Conflict
from app.session.equipment.head import HeadChoice
from app.store.database import Database
from app.store.people import add_clinic

SIMULATED = {"kind": "simulator", "seed": 1}


class FakeControl:
    """A control process that opens head trackers, or refuses them with `reason`."""

    def __init__(self, reason: str = "") -> None:
        self.opened: list[Any] = []
        self.reason = reason

    async def load(self, _do: str, config: Any) -> None:
        if self.reason:
            raise Conflict(self.reason)
        self.opened.append(config)

    def forget(self, _do: str) -> None:
        self.opened.clear()


def choice(database: Database, control: FakeControl) -> HeadChoice:
    return HeadChoice(database, control, lambda config: config, lambda _news: None)  # type: ignore[arg-type]


@pytest.fixture
def stored(database: Database) -> Database:
    with database.transaction() as db:
        add_clinic(db, "Clinic")
    asyncio.run(choice(database, FakeControl()).use(SIMULATED))
    return database


def test_what_was_chosen_is_opened_on_the_next_day(stored: Database) -> None:
    control = FakeControl()
    asyncio.run(choice(stored, control).open())
    assert control.opened == [SIMULATED]


def test_one_that_is_not_there_in_the_morning_stays_chosen_and_says_why(stored: Database) -> None:
    control = FakeControl("Check its cable.")
    chosen = choice(stored, control)
    asyncio.run(chosen.open())
    assert (chosen.config, chosen.failure) == (SIMULATED, "Check its cable.")
    control.reason = ""
    asyncio.run(chosen.use(SIMULATED))
    assert chosen.failure is None


def test_one_that_is_refused_leaves_none(stored: Database) -> None:
    control = FakeControl("Check its cable.")
    chosen = choice(stored, control)
    with pytest.raises(Conflict, match="cable"):
        asyncio.run(chosen.use({"kind": "tablet"}))
    assert chosen.config is None
    control.reason = ""
    asyncio.run(choice(stored, control).open())
    assert control.opened == []
