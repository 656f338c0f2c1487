"""Runs: begun when the disk has room, ended when the chair stands, answered when the recording is on the disk."""

import shutil
from pathlib import Path

from app import __version__
from app.clock import Clock, utc_now
from app.disk_room import ROOM_TO_RECORD
from app.json_values import JsonDocument
from app.pipeline import command_fields
from app.pipeline.compiled import IS_COMPILED
from app.pipeline.loop import ControlLoop
from app.pipeline.open_run import OpenRun
from app.pipeline.setup import CommandRefused
from app.process.command_channel import NO_ANSWER, CommandServer
from app.realtime import collect_garbage
from app.recording.writer import RunWriter
from app.texts import Figure, Text


class Runs:
    """Begins and ends the recordings of a loop, one at a time."""

    def __init__(self, loop: ControlLoop, server: CommandServer, clock: Clock) -> None:
        self._loop = loop
        self._server = server
        self._clock = clock
        self._count = 0
        self._ending: tuple[OpenRun, int] | None = None  # the run, and the command to answer when it has ended
        self._closing: list[tuple[OpenRun, int]] = []  # runs going to the disk, and the commands to answer

    @property
    def ending(self) -> bool:
        """Whether a run waits for the chair to stand before it ends."""
        return self._ending is not None

    def begin(self, fields: command_fields.RunFields) -> int:
        """Disarm and begin a run; return its number in ticks, or raise CommandRefused."""
        loop, setup = self._loop, self._loop.setup
        if setup.shirt is None:
            raise CommandRefused(setup.shirt_description)
        setup.chain.gate.disarm()
        loop.send_to_chair()
        if not setup.stands:
            raise CommandRefused(Text("drives-still-stopping"))
        writer = self._new_writer(fields)
        setup.chain.reset()
        if fields.kind == "drive":
            setup.to_start()
        self._count += 1
        writer.start(loop.ring, loop.ring.number, self._count, real_time=True)
        collect_garbage()
        loop.run = OpenRun(fields.run_id, self._count, fields.kind, fields.cues, self._clock.now(), writer, fields.test)
        return self._count

    def end(self, command_id: int) -> None:
        """Disarm; `poll` ends the run when the chair stands, and answers the command."""
        run = self._loop.run
        if run is None or self._ending is not None:
            raise CommandRefused(Text("drives-not-recording"))
        self._loop.setup.chain.gate.disarm()
        run.was_armed = False
        self._ending = run, command_id

    def poll(self) -> None:
        """End a run when the chair stands, and answer the commands of runs that are on the disk."""
        if self._ending is not None and self._loop.setup.stands:
            self._finish()
        if self._closing:
            self._answer_closed()

    def close(self) -> None:
        """End an open run, wait until its recording is on the disk, and answer its command."""
        self._finish()
        for run, _ in self._closing:
            run.writer.wait()
        self._answer_closed()

    def status(self) -> JsonDocument | None:
        """Return the state of the run in progress, None outside a run."""
        run = self._loop.run
        if run is None:
            return None
        writer = run.writer
        return {"run_id": run.run_id, "rows": writer.rows, "dropped": writer.dropped, "words": writer.damage or ""}

    def _finish(self) -> None:
        run, self._loop.run = self._loop.run, None
        if run is not None:
            run.writer.finish(self._loop.ring.number)
            self._closing.append(self._ending or (run, NO_ANSWER))
        self._ending = None

    def _answer_closed(self) -> None:
        for run, command_id in [closing for closing in self._closing if closing[0].writer.done]:
            self._closing.remove((run, command_id))
            writer = run.writer
            self._server.answer(command_id, rows=writer.rows, dropped=writer.dropped, words=writer.damage or "")

    def _new_writer(self, fields: command_fields.RunFields) -> RunWriter:
        setup = self._loop.setup
        shirt, parameters, floorplan = setup.shirt, setup.parameters, setup.floorplan
        if shirt is None:
            raise CommandRefused(setup.shirt_description)
        gestures = [gesture.name for gesture in parameters.gestures] if parameters else []
        meta = {
            "run_id": fields.run_id,
            "kind": fields.kind,
            "created": utc_now().isoformat(),
            "software": __version__,
            "compiled": IS_COMPILED,
            "layout": shirt.layout.model_dump(mode="json"),
            "sample_rate": shirt.sample_rate,
            "gestures": gestures,
            "cues": [cue.model_dump(mode="json") for cue in fields.cues],
            "parameters": parameters.model_dump(mode="json") if parameters else None,
            "floorplan": floorplan.model_dump(mode="json") if floorplan else None,
            "path": setup.path.name if setup.path else None,
            "dynamics": setup.dynamics,
            "clinic": setup.chain.clinic.model_dump(mode="json"),
            "source": setup.source.model_dump(mode="json"),
            "meta": fields.meta,
            "interface_test": fields.test.model_dump(mode="json") if fields.test else None,
        }
        folder = Path(fields.folder)
        try:
            require_room(folder)
            return RunWriter(folder, meta, len(shirt.layout.channels), len(gestures))
        except OSError as error:
            raise CommandRefused(Text("drives-cannot-record", problem=error.strerror or str(error))) from error


def require_room(folder: Path) -> None:
    """Raise CommandRefused when a recording in `folder`, which need not exist yet, could fill its disk."""
    place = next(place for place in (folder, *folder.parents) if place.exists())
    free = shutil.disk_usage(place).free
    if free < ROOM_TO_RECORD:
        raise CommandRefused(Text("drives-disk-full", free=Figure(free / 1e6), needed=Figure(ROOM_TO_RECORD / 1e6)))
