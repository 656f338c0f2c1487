"""The network cable of each browser: connections pass through it until it is pulled out."""

import asyncio
import threading
from contextlib import suppress


class Cables:
    """Passes TCP connections on to a port of this machine, each browser by a port of its own."""

    def __init__(self, port: int) -> None:
        self._port = port
        self._loop = asyncio.new_event_loop()
        self._thread = threading.Thread(target=self._loop.run_forever)
        self._thread.start()

    def lay(self) -> "Cable":
        """Return a new cable."""
        cable = Cable(self._port, self._loop)
        asyncio.run_coroutine_threadsafe(cable.open(), self._loop).result()
        return cable

    def close(self) -> None:
        """End it; the cables are closed before."""
        self._loop.call_soon_threadsafe(self._loop.stop)
        self._thread.join()
        self._loop.close()


class Cable:
    """One of them; its methods are called from another thread than that of its connections."""

    def __init__(self, port: int, loop: asyncio.AbstractEventLoop) -> None:
        self._port, self._loop = port, loop
        self._is_whole = True
        self._ends: set[asyncio.StreamWriter] = set()
        self.base = ""

    async def open(self) -> None:
        """Listen on a free port."""
        self._server = await asyncio.start_server(self._connected, "127.0.0.1", 0)
        self.base = f"http://127.0.0.1:{self._server.sockets[0].getsockname()[1]}"

    def pull(self) -> None:
        """End every connection, and let none begin."""
        self._in_loop(self._pull)

    def plug_in(self) -> None:
        """Pass on connections again."""
        self._is_whole = True

    def close(self) -> None:
        """Pull it out for good."""
        self.pull()
        self._in_loop(self._server.close)

    def _in_loop(self, do: object) -> None:
        async def done() -> None:
            do()  # type: ignore[operator]

        asyncio.run_coroutine_threadsafe(done(), self._loop).result()

    def _pull(self) -> None:
        self._is_whole = False
        for end in self._ends:
            end.transport.abort()

    async def _connected(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        if not self._is_whole:
            writer.transport.abort()
            return
        try:
            far_reader, far_writer = await asyncio.open_connection("127.0.0.1", self._port)
        except OSError:
            writer.transport.abort()
            return
        ends = {writer, far_writer}
        self._ends |= ends
        await asyncio.gather(_pass_on(reader, far_writer), _pass_on(far_reader, writer))
        self._ends -= ends


async def _pass_on(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
    with suppress(OSError):
        while content := await reader.read(65_536):
            writer.write(content)
            await writer.drain()
    with suppress(OSError, RuntimeError):
        writer.close()
