"""What the web process asks for, done or refused in one sentence (docs/protocols.md, section 1)."""

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

from pydantic import ValidationError

from app import __version__
from app.clock import Clock, utc_now
from app.faults import EXPLANATIONS, Fault, State
from app.hardware.base import HardwareError
from app.hardware.registry import parse_body, parse_shirt
from app.link import NO_ANSWER, CommandServer
from app.pipeline import documents
from app.pipeline.loop import ControlLoop
from app.pipeline.open_run import OpenRun
from app.pipeline.setup import Refused
from app.quantities import Document
from app.realtime import tidy
from app.recording import RunWriter
from app.sentences import one_sentence

Answer = dict[str, Any]

STOPPED_BY = {"tablet": Fault.STOP_TABLET, "key": Fault.STOP_KEY}


class Command(NamedTuple):
    """A command's fields, and what does it; an answer of None comes later."""

    fields: type[Document]
    do: Callable[[Any, int], Answer | None]


class Commands:
    """Does the commands that have come since it was last polled, between two ticks of the loop."""

    def __init__(self, loop: ControlLoop, server: CommandServer, real_time: list[str], clock: Clock) -> None:
        self.quit = False
        self._loop = loop
        self._setup = loop.setup
        self._server = server
        self._real_time = real_time
        self._clock = clock
        self._runs = 0
        self._ending: tuple[OpenRun, int] | None = None  # a run, and who wants to know when it has ended
        self._closing: list[tuple[OpenRun, int]] = []  # runs that are being brought to the disk
        self._commands = {
            "heartbeat": Command(documents.Heartbeat, self._heartbeat),
            "shirt": Command(documents.Device, self._shirt),
            "body": Command(documents.Device, self._body),
            "move": Command(documents.Move, self._move),
            "parameters": Command(documents.Parameters, self._parameters),
            "world": Command(documents.World, self._world),
            "run": Command(documents.Run, self._run),
            "end_run": Command(documents.Nothing, self._end_run),
            "arm": Command(documents.Arm, self._arm),
            "disarm": Command(documents.Nothing, self._disarm),
            "stop": Command(documents.Stop, self._stop),
            "clear": Command(documents.Nothing, self._clear),
            "status": Command(documents.Nothing, self._status),
            "quit": Command(documents.Nothing, self._quit),
        }

    def poll(self) -> None:
        """Do what has been asked for, and answer what has been finished."""
        for message in self._server.poll():
            self._do(message)
        if self._ending is not None and self._setup.stands:
            self._finish_run()
        if self._closing:
            self._answer_closed()

    def close(self) -> None:
        """Close an open recording, wait until it is on disk, and say so."""
        self._finish_run()
        for run, _ in self._closing:
            run.writer.wait()
        self._answer_closed()
        self._server.close()

    def _finish_run(self) -> None:
        run, self._loop.run = self._loop.run, None
        if run is not None:
            run.writer.finish(self._loop.ring.number)
            self._closing.append(self._ending or (run, NO_ANSWER))
        self._ending = None

    def _answer_closed(self) -> None:
        for run, command_id in [closing for closing in self._closing if closing[0].writer.done]:
            self._closing.remove((run, command_id))
            writer = run.writer
            self._server.answer(command_id, rows=writer.rows, dropped=writer.dropped, words=writer.words)

    def _do(self, message: dict[str, Any]) -> None:
        command_id, word = message.pop("id"), message.pop("do")
        command = self._commands.get(word)
        if command is None:
            self._server.refuse(command_id, f"There is no command '{word}': use one of {', '.join(self._commands)}.")
            return
        try:
            answer = command.do(command.fields.model_validate(message), command_id)
        except ValidationError as error:
            self._server.refuse(command_id, f"{one_sentence(error, word)}.")
        except (Refused, HardwareError) as refusal:
            self._server.refuse(command_id, str(refusal))
        else:
            if answer is not None:
                self._server.answer(command_id, **answer)

    def _heartbeat(self, fields: documents.Heartbeat, _id: int) -> Answer:
        self._loop.heard = self._clock.now()
        self._loop.screen_seen = -math.inf if fields.screen_age is None else self._clock.now() - fields.screen_age
        return {}

    def _shirt(self, fields: documents.Device, _id: int) -> Answer:
        self._require_no_run()
        try:
            self._setup.use_shirt(parse_shirt(fields.config))
        finally:
            tidy()
            self._loop.new_shirt()
        shirt = self._setup.shirt
        if shirt is None:
            raise Refused("The shirt was not opened: choose another one.")
        return {
            "layout": shirt.layout.model_dump(mode="json"),
            "sample_rate": shirt.sample_rate,
            "hash": self._setup.hash,
        }

    def _body(self, fields: documents.Device, _id: int) -> Answer:
        self._setup.require_still()
        self._setup.use_body(parse_body(fields.config))
        self._settle()
        return {}

    def _move(self, fields: documents.Move, _id: int) -> Answer:
        body = self._setup.dressed.body if self._setup.dressed else None
        move = getattr(body, "move", None)
        if move is None:
            raise Refused("Nobody is in the shirt whom keys could move: choose yourself as the body first.")
        try:
            move(fields.joints)
        except ValueError as error:
            raise Refused(f"{error}.") from error
        return {}

    def _parameters(self, fields: documents.Parameters, _id: int) -> Answer:
        self._require_no_drive()
        self._setup.use_parameters(fields.parameters)
        self._settle()
        return {"hash": self._setup.hash}

    def _world(self, fields: documents.World, _id: int) -> Answer:
        self._require_no_drive()
        self._setup.use_world(fields.floorplan, fields.path)
        self._settle()
        return {}

    def _run(self, fields: documents.Run, _id: int) -> Answer:
        self._require_no_run()
        setup, loop = self._setup, self._loop
        if setup.shirt is None:
            raise Refused(setup.shirt_words)
        setup.chain.gate.disarm()
        if not setup.stands:
            raise Refused("The chair still comes to its stop: try again in a moment.")
        writer = self._new_writer(fields)
        setup.chain.reset()
        if fields.kind == "drive":
            setup.to_start()
        self._runs += 1
        writer.start(loop.ring, loop.ring.number, self._runs, real_time=True)
        tidy()
        loop.run = OpenRun(fields.run_id, self._runs, fields.kind, fields.cues, self._clock.now(), writer)
        return {"run": self._runs}

    def _new_writer(self, fields: documents.Run) -> RunWriter:
        setup = self._setup
        shirt, parameters, floorplan = setup.shirt, setup.parameters, setup.floorplan
        if shirt is None:
            raise Refused(setup.shirt_words)
        gestures = [gesture.name for gesture in parameters.gestures] if parameters else []
        meta = {
            "run_id": fields.run_id,
            "kind": fields.kind,
            "created": utc_now().isoformat(),
            "software": __version__,
            "layout": shirt.layout.model_dump(mode="json"),
            "sample_rate": shirt.sample_rate,
            "gestures": gestures,
            "cues": [cue.model_dump(mode="json") for cue in fields.cues],
            "parameters": parameters.model_dump(mode="json") if parameters else None,
            "floorplan": floorplan.model_dump(mode="json") if floorplan else None,
            "path": setup.path.name if setup.path else None,
            "meta": fields.meta,
        }
        try:
            return RunWriter(Path(fields.folder), meta, len(shirt.layout.channels), len(gestures))
        except OSError as error:
            raise Refused(
                f"The recording cannot be begun ({error.strerror or error}): free some disk space."
            ) from error

    def _end_run(self, _fields: documents.Nothing, command_id: int) -> None:
        run = self._loop.run
        if run is None or self._ending is not None:
            raise Refused("Nothing is being recorded: begin a run first.")
        self._setup.chain.gate.disarm()
        run.was_armed = False
        self._ending = run, command_id

    def _arm(self, fields: documents.Arm, _id: int) -> Answer:
        setup, gate = self._setup, self._setup.chain.gate
        if setup.chain.parameters is None:
            raise Refused("There is nothing to drive with: calibrate first.")
        if fields.hash != setup.hash:
            raise Refused("The controls were changed meanwhile: load them again, then arm.")
        if self._ending is not None:
            raise Refused("The run is being ended: begin a new one first.")
        if gate.state is State.FAULT:
            what = EXPLANATIONS[gate.fault]
            raise Refused(f"{what.happened} {what.next_step}")
        self._begin_neutral_check()
        return {}

    def _begin_neutral_check(self) -> None:
        # The screen counts as in view until the next heartbeat says otherwise: the last one was sent before arming.
        self._loop.screen_seen = self._clock.now()
        self._setup.chain.arm()
        if self._loop.run is not None:
            self._loop.run.was_armed = True

    def _disarm(self, _fields: documents.Nothing, _id: int) -> Answer:
        self._setup.chain.gate.disarm()
        if self._loop.run is not None:
            self._loop.run.was_armed = False
        return {}

    def _stop(self, fields: documents.Stop, _id: int) -> Answer:
        self._setup.chain.gate.stop(STOPPED_BY[fields.by])
        return {}

    def _clear(self, _fields: documents.Nothing, _id: int) -> Answer:
        gate, run = self._setup.chain.gate, self._loop.run
        latched = gate.state is State.FAULT
        gate.clear()
        if latched and run is not None and run.kind == "drive" and run.was_armed:
            self._begin_neutral_check()
        return {}

    def _status(self, _fields: documents.Nothing, _id: int) -> Answer:
        setup, loop = self._setup, self._loop
        return {
            "shirt": {
                "kind": setup.shirt_kind,
                "words": setup.shirt_words,
                "alive": loop.shirt_alive,
                "sample_rate": setup.sample_rate if setup.shirt else 0.0,
                "lost": setup.shirt.lost if setup.shirt else 0,
            },
            "realtime": self._real_time,
            "late": loop.late,
            "recording": self._recording(),
            "hash": setup.hash,
        }

    def _recording(self) -> Answer | None:
        run = self._loop.run
        if run is None:
            return None
        writer = run.writer
        return {"run_id": run.run_id, "rows": writer.rows, "dropped": writer.dropped, "words": writer.words}

    def _quit(self, _fields: documents.Nothing, _id: int) -> Answer:
        self.quit = True
        return {}

    def _require_no_run(self) -> None:
        if self._loop.run is not None:
            raise Refused("Something is being recorded already: end it first.")

    def _require_no_drive(self) -> None:
        """Refuse while armed or recording: a stop in a trial is cleared into what was armed, and into nothing else."""
        self._setup.require_still()
        self._require_no_run()

    def _settle(self) -> None:
        """Take what was just loaded into the long-lived memory; the loop begins a new deadline."""
        tidy()
        self._loop.begin_anew()
