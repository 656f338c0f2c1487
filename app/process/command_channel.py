"""Commands to the control process and their answers: one JSON object a line, over a stream socket pair."""

import asyncio
import json
import socket
from contextlib import suppress
from typing import TypeAlias

from app.json_values import JsonDocument
from app.texts import Text, from_document, to_document

CHUNK = 65_536  # bytes read from the socket at once
LONGEST_LINE = 16_000_000  # bytes; a floor plan's document has at most 8 MB
ANSWER_LIMIT = 10.0  # s; opening a device may take several
NO_ANSWER = 0  # the id of a command that gets no answer
PROCESS_ENDED = Text("drives-process-ended")

Message: TypeAlias = JsonDocument


class LinkRefused(Exception):  # noqa: N818
    """The control process refused a command; the message is its sentence."""


class LinkLost(Exception):  # noqa: N818
    """The control process did not answer, or has ended."""


class CommandServer:
    """The control process's end of the channel. It never waits: a client that does not read its answers is cut off."""

    def __init__(self, end: socket.socket) -> None:
        end.setblocking(False)
        self._socket = end
        self._rest = b""
        self.closed = False

    def poll(self) -> list[Message]:
        """Return the commands that have arrived; set `closed` when the other end is closed.

        Lines that are no command are answered with a refusal and left out.
        """
        chunks = []
        while not self.closed:
            try:
                chunk = self._socket.recv(CHUNK)
            except BlockingIOError:
                break
            except OSError:
                chunk = b""
            if not chunk:
                self.closed = True
                break
            chunks.append(chunk)
            if len(chunk) < CHUNK:
                break  # any more bytes are read at the next poll
        if not chunks:
            return []
        *lines, self._rest = b"".join([self._rest, *chunks]).split(b"\n")
        if len(self._rest) > LONGEST_LINE:
            self.close()
        return [command for line in lines if (command := self._parse(line)) is not None]

    def answer(self, command_id: int, **fields: object) -> None:
        """Answer a command with its results."""
        self._send({"id": command_id, "ok": True, **fields}, command_id)

    def refuse(self, command_id: int, sentence: Text | str) -> None:
        """Answer a command with one sentence on why it was not carried out."""
        self._send({"id": command_id, "ok": False, "error": sentence}, command_id)

    def close(self) -> None:
        """Close the socket."""
        self.closed = True
        self._socket.close()

    def _parse(self, line: bytes) -> Message | None:
        try:
            command = json.loads(line)
        except (ValueError, RecursionError):
            command = None
        if isinstance(command, dict) and isinstance(command.get("id"), int) and isinstance(command.get("do"), str):
            return command
        command_id = command.get("id") if isinstance(command, dict) else None
        self.refuse(command_id if isinstance(command_id, int) else -1, Text("drives-not-a-command"))
        return None

    def _send(self, message: Message, command_id: int) -> None:
        if command_id == NO_ANSWER or self.closed:
            return
        line = json.dumps(message, separators=(",", ":"), default=to_document).encode() + b"\n"
        try:
            sent = self._socket.send(line)
        except OSError:
            sent = 0
        if sent < len(line):
            self.close()


class ControlClient:
    """The web process's end of the channel, for asyncio."""

    def __init__(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        self._reader = reader
        self._writer = writer
        self._last_id = NO_ANSWER
        self._waiting: dict[int, asyncio.Future[Message]] = {}
        self._closed = asyncio.Event()
        self._task = asyncio.create_task(self._read())

    @classmethod
    async def open(cls, end: socket.socket) -> "ControlClient":
        """Take over one end of the socket pair."""
        reader, writer = await asyncio.open_connection(sock=end, limit=LONGEST_LINE)
        return cls(reader, writer)

    @property
    def closed(self) -> bool:
        """Whether the control process has closed the channel."""
        return self._closed.is_set()

    async def wait_closed(self) -> None:
        """Return when the control process has closed the channel."""
        await self._closed.wait()

    async def call(self, do: str, *, limit: float = ANSWER_LIMIT, **fields: object) -> Message:
        """Send a command and return its answer, waiting at most `limit` (s).

        Raises
        ------
        LinkRefused
            With the control process's sentence.
        LinkLost
            When the control process has ended or does not answer.
        """
        self._last_id += 1
        command_id = self._last_id
        answer: asyncio.Future[Message] = asyncio.get_running_loop().create_future()
        self._waiting[command_id] = answer
        try:
            self._write({"id": command_id, "do": do, **fields})
            message = await asyncio.wait_for(answer, limit)
        except TimeoutError as late:
            raise LinkLost(Text("drives-process-silent", command=do, seconds=limit)) from late
        finally:
            self._waiting.pop(command_id, None)
        if not message.get("ok"):
            raise LinkRefused(from_document(message["error"]) if "error" in message else Text("drives-no-reason"))
        return message

    def send(self, do: str, **fields: object) -> None:
        """Send a command without waiting for an answer; raise LinkLost when the control process has ended."""
        self._write({"id": NO_ANSWER, "do": do, **fields})

    async def close(self) -> None:
        """Close this end; the control process then ends."""
        self._task.cancel()
        await asyncio.gather(self._task, return_exceptions=True)
        self._writer.close()
        with suppress(OSError):
            await self._writer.wait_closed()

    def _write(self, message: Message) -> None:
        if self.closed:
            raise LinkLost(PROCESS_ENDED)
        self._writer.write(json.dumps(message, separators=(",", ":"), allow_nan=False).encode() + b"\n")

    async def _read(self) -> None:
        try:
            while line := await self._reader.readline():
                message = json.loads(line)
                answer = self._waiting.get(message["id"])
                if answer is not None and not answer.done():
                    answer.set_result(message)
        except (OSError, ValueError, KeyError, TypeError):
            pass  # an invalid answer is treated as a closed channel
        finally:
            self._closed.set()
            for answer in self._waiting.values():
                if not answer.done():
                    answer.set_exception(LinkLost(PROCESS_ENDED))
