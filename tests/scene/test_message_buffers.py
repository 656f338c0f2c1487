"""The message buffers of 3D servers: who waits is woken by the server's own event loop alone."""

import asyncio
import threading

from viser import _messages as wire
from viser.infra._async_message_buffer import AsyncMessageBuffer

from app.scene.message_buffers import LoopBuffer
from app.scene.role_servers import quiet_server


def push_from_another_thread(buffer: AsyncMessageBuffer) -> None:
    message = wire.SetPositionMessage("/chair", (1.0, 2.0, 3.0))
    pushing = threading.Thread(target=buffer.push, args=(message,))
    pushing.start()
    pushing.join()


def test_another_thread_wakes_nobody_itself_and_the_loop_wakes_everybody():
    """Waking would go through the list of those who wait, which the loop may change at the same time."""

    async def wake() -> None:
        buffer = LoopBuffer(asyncio.get_running_loop(), persistent_messages=True)
        waiting = [asyncio.create_task(buffer.message_event.wait()) for _ in range(3)]
        await asyncio.sleep(0)
        push_from_another_thread(buffer)  # the loop does nothing meanwhile
        assert not buffer.message_event.is_set()
        await asyncio.gather(*waiting)

    asyncio.run(wake())


def test_a_block_of_changes_wakes_at_its_end():
    async def wake() -> None:
        buffer = LoopBuffer(asyncio.get_running_loop(), persistent_messages=False)
        waiting = asyncio.create_task(buffer.message_event.wait())
        buffer.atomic_start()
        push_from_another_thread(buffer)
        await asyncio.sleep(0)
        assert not waiting.done()
        buffer.atomic_end()
        await waiting

    asyncio.run(wake())


def test_every_server_has_such_buffers_for_all_pages():
    server = quiet_server()
    try:
        assert isinstance(server.scene._websock_interface.get_message_buffer(), LoopBuffer)
    finally:
        server.stop()
