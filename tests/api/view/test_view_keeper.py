"""The 3D view of the open session: what its end frees."""

import asyncio
import gc

import pytest
from viser.infra._async_message_buffer import AsyncMessageBuffer

from app.api.view.view_keeper import ServedScene, ViewKeeper
from app.world.floorplan import bundled_floorplans, load_floorplan


@pytest.fixture
def without_collections():
    """Let Python collect no garbage by itself: it could do so at any moment, and hide what would stay."""
    gc.collect()
    gc.disable()
    yield
    gc.enable()


def buffers() -> int:
    """Return the number of viser's buffers, which keep every message of their server for later viewers."""
    return sum(isinstance(one, AsyncMessageBuffer) for one in gc.get_objects())


def test_a_session_that_ends_or_is_followed_by_another_leaves_nothing_of_its_scene(without_collections):
    plan = load_floorplan(bundled_floorplans()["apartment"])
    before = buffers()

    async def sessions() -> list[int]:
        keeper = ViewKeeper(ServedScene, lambda: None)
        await keeper.open(plan, "main")
        one = buffers()
        await keeper.open(plan, "main")
        other = buffers()
        await keeper.close()
        return [one - before, other - before, buffers() - before]

    assert asyncio.run(sessions()) == [2, 2, 0]
