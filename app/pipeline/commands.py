"""The commands of the web process: each is executed, or refused in one sentence (docs/protocols.md, section 1)."""

import math
from collections.abc import Callable
from typing import Any, NamedTuple, TypeAlias

from pydantic import ValidationError

from app.calibration.own_movement import own_movement_refusal
from app.clock import Clock
from app.faults import EXPLANATIONS, Fault, State
from app.hardware.base import HardwareError, NetworkShirt
from app.hardware.registry import parse_body, parse_chair, parse_head, parse_shirt
from app.json_values import JsonDocument
from app.pipeline import command_fields
from app.pipeline.loop import ControlLoop
from app.pipeline.opening import DeviceChange, Openings, defect
from app.pipeline.person_brakes import missing_brake
from app.pipeline.runs import Runs
from app.pipeline.setup import CommandRefused
from app.process.command_channel import CommandServer, Message
from app.quantities import Document
from app.realtime import collect_garbage
from app.sentences import one_sentence
from app.texts import Text, text_of
from app.world.floorplan import LINES_ARE_FREE

Answer: TypeAlias = JsonDocument

NOT_MEANWHILE = frozenset({"shirt", "sender", "body", "head", "chair", "parameters", "world", "run", "arm", "clear"})
"""Commands refused while a device is being opened: they would change, arm or record an incomplete setup."""

STOPPED_BY = {"tablet": Fault.STOP_TABLET, "key": Fault.STOP_KEY, "picture": Fault.PICTURE_LOST}
SCREEN_FAULTS = {"in view": Fault.NONE, "hidden": Fault.SCREEN_HIDDEN, "slow": Fault.SCREEN_SLOW}


class Command(NamedTuple):
    """The fields of a command and its function; an answer of None means that the answer comes later."""

    fields: type[Document]
    do: Callable[[Any, int], Answer | None]


class Commands:
    """Executes commands between two ticks of the loop."""

    def __init__(self, loop: ControlLoop, server: CommandServer, real_time: list[Text], clock: Clock) -> None:
        self.quit = False
        self._loop = loop
        self._setup = loop.setup
        self._server = server
        self._real_time = real_time
        self._clock = clock
        self._runs = Runs(loop, server, clock)
        self._openings = Openings(clock)
        self._armed_hash = ""  # of the newest arming
        self._commands = {
            "heartbeat": Command(command_fields.Heartbeat, self._heartbeat),
            "shirt": Command(command_fields.Device, self._shirt),
            "sender": Command(command_fields.Sender, self._sender),
            "sample": Command(command_fields.Sample, self._sample),
            "body": Command(command_fields.Device, self._body),
            "move": Command(command_fields.Move, self._move),
            "head": Command(command_fields.HeadDevice, self._head),
            "look": Command(command_fields.Look, self._look),
            "head_ahead": Command(command_fields.Nothing, self._head_ahead),
            "parameters": Command(command_fields.Parameters, self._parameters),
            "world": Command(command_fields.World, self._world),
            "chair": Command(command_fields.Device, self._chair),
            "limits": Command(command_fields.Limits, self._limits),
            "dial": Command(command_fields.Dial, self._dial),
            "run": Command(command_fields.RunFields, self._run),
            "end_run": Command(command_fields.Nothing, self._end_run),
            "arm": Command(command_fields.Arm, self._arm),
            "disarm": Command(command_fields.Nothing, self._disarm),
            "stop": Command(command_fields.Stop, self._stop),
            "clear": Command(command_fields.Clear, self._clear),
            "status": Command(command_fields.Nothing, self._status),
            "quit": Command(command_fields.Nothing, self._quit),
        }

    def poll(self) -> None:
        """Execute the commands that have come, and answer earlier commands that are finished."""
        for message in self._server.poll():
            self._do(message)
        self._openings.poll()
        self._runs.poll()

    def close(self) -> None:
        """End an open run, wait until its recording is on the disk, and close the control link."""
        self._runs.close()
        self._server.close()

    def _do(self, message: Message) -> None:
        command_id, name = message.pop("id"), message.pop("do")
        command = self._commands.get(name)
        if command is None:
            self._server.refuse(command_id, Text("drives-no-command", name=name, commands=", ".join(self._commands)))
            return
        try:
            if name in NOT_MEANWHILE and self._openings.busy:
                raise CommandRefused(Text("drives-opening"))
            answer = command.do(command.fields.model_validate(message, context=LINES_ARE_FREE), command_id)
        except ValidationError as error:
            self._server.refuse(command_id, Text("drives-problem", problem=one_sentence(error, name)))
        except (CommandRefused, HardwareError) as refusal:
            self._server.refuse(command_id, text_of(refusal))
        except Exception as error:  # a defect of a command must not end the process that controls the chair
            self._server.refuse(command_id, defect(name, error))
        else:
            if answer is not None:
                self._server.answer(command_id, **answer)

    def _heartbeat(self, fields: command_fields.Heartbeat, _id: int) -> Answer:
        self._loop.last_heartbeat = self._clock.now()
        age = math.inf if fields.screen_age is None else fields.screen_age
        self._loop.last_screen_report = self._clock.now() - age
        self._loop.screen = SCREEN_FAULTS[fields.screen]
        return {}

    def _shirt(self, fields: command_fields.Device, command_id: int) -> None:
        self._require_no_run()
        change = self._setup.change_shirt(parse_shirt(fields.config))
        self._loop.new_shirt()

        def answer() -> Answer:
            self._loop.new_shirt()
            return {
                "layout": self._setup.layout_document,
                "sample_rate": self._setup.sample_rate,
                "hash": self._setup.hash,
                "mistrust": self._setup.mistrust,
            }

        self._open(change, command_id, answer)

    def _sender(self, fields: command_fields.Sender, _id: int) -> Answer:
        self._require_no_drive()
        shirt = self._setup.network_shirt
        if shirt is None or not shirt.use_sender(fields.sender):
            raise CommandRefused(Text("drives-wrong-sender"))
        return {}

    def _sample(self, fields: command_fields.Sample, _id: int) -> Answer:
        shirt = self._setup.page_shirt
        if shirt is None:
            raise CommandRefused(Text("drives-no-camera"))
        shirt.add_sample(fields.page, bytes.fromhex(fields.message), fields.received)
        return {}

    def _body(self, fields: command_fields.Device, command_id: int) -> None:
        self._require_no_drive()
        self._open(self._setup.change_body(parse_body(fields.config)), command_id, dict)

    def _move(self, fields: command_fields.Move, _id: int) -> Answer:
        body = self._setup.simulated_shirt.body if self._setup.simulated_shirt else None
        move = getattr(body, "move", None)
        if move is None:
            raise CommandRefused(Text("drives-keys-move-nobody"))
        try:
            move(fields.joints)
        except ValueError as error:
            raise CommandRefused(Text("drives-problem", problem=text_of(error))) from error
        return {}

    def _head(self, fields: command_fields.HeadDevice, command_id: int) -> None:
        self._require_no_drive()
        head = self._setup.head
        change = head.change(None if fields.config is None else parse_head(fields.config))
        self._open(change, command_id, lambda: {"words": head.description})

    def _look(self, fields: command_fields.Look, _id: int) -> Answer:
        if not self._setup.head.look(fields.yaw, fields.pitch, fields.roll):
            raise CommandRefused(Text("drives-no-tablet"))
        return {}

    def _head_ahead(self, _fields: command_fields.Nothing, _id: int) -> Answer:
        if not self._setup.head.set_ahead():
            raise CommandRefused(Text("drives-no-pose"))
        return {}

    def _parameters(self, fields: command_fields.Parameters, _id: int) -> Answer:
        self._require_no_drive()
        self._setup.use_parameters(fields.parameters)
        self._settle()
        return {"hash": self._setup.hash}

    def _world(self, fields: command_fields.World, _id: int) -> Answer:
        self._require_no_drive()
        self._setup.use_world(fields.floorplan, fields.path)
        self._settle()
        return {}

    def _chair(self, fields: command_fields.Device, command_id: int) -> None:
        self._require_no_drive()
        change = self._setup.change_chair(parse_chair(fields.config))
        self._open(change, command_id, lambda: {"kind": self._setup.chair_kind})

    def _limits(self, fields: command_fields.Limits, _id: int) -> Answer:
        self._setup.use_clinic(fields.clinic)
        return {}

    def _dial(self, fields: command_fields.Dial, _id: int) -> Answer:
        self._setup.use_dial(fields.share)
        return {"share": self._setup.chain.dial}

    def _run(self, fields: command_fields.RunFields, _id: int) -> Answer:
        self._require_no_run()
        return {"run": self._runs.begin(fields), "source": self._setup.source.model_dump(mode="json")}

    def _end_run(self, _fields: command_fields.Nothing, command_id: int) -> None:
        self._runs.end(command_id)

    def _arm(self, fields: command_fields.Arm, _id: int) -> Answer:
        if self._runs.ending:
            raise CommandRefused(Text("drives-run-ending"))
        _refuse(arming_refusal(self._loop, fields.hash))
        self._armed_hash = fields.hash
        self._begin_neutral_check()
        return {}

    def _begin_neutral_check(self) -> None:
        # The screen counts as in view until the next heartbeat says otherwise: the last one was sent before arming.
        self._loop.last_screen_report, self._loop.screen = self._clock.now(), Fault.NONE
        self._loop.send_to_chair()  # the state before the arming, so that the chair sees a new arming after it
        self._setup.chain.arm()
        if self._loop.run is not None:
            self._loop.run.was_armed = True

    def _disarm(self, _fields: command_fields.Nothing, _id: int) -> Answer:
        self._setup.chain.gate.disarm()
        if self._loop.run is not None:
            self._loop.run.was_armed = False
        return {}

    def _stop(self, fields: command_fields.Stop, _id: int) -> Answer:
        self._setup.chain.gate.stop(STOPPED_BY[fields.by])
        return {}

    def _clear(self, fields: command_fields.Clear, _id: int) -> Answer:
        gate, run = self._setup.chain.gate, self._loop.run
        if gate.state is not State.FAULT:
            return {}
        goes_on = run is not None and run.kind == "drive" and run.was_armed
        if goes_on:
            if self._setup.arming_hash != self._armed_hash:
                raise CommandRefused(Text("drives-controls-changed"))
            _refuse(device_refusal(self._loop))
        if not gate.clear(fields.stops):
            raise CommandRefused(Text("drives-another-stop"))
        if goes_on:
            self._begin_neutral_check()
        return {}

    def _status(self, _fields: command_fields.Nothing, _id: int) -> Answer:
        return {**status(self._loop), "realtime": self._real_time, "recording": self._runs.status()}

    def _quit(self, _fields: command_fields.Nothing, _id: int) -> Answer:
        self.quit = True
        return {}

    def _require_no_run(self) -> None:
        if self._loop.run is not None:
            raise CommandRefused(Text("drives-recording"))

    def _require_no_drive(self) -> None:
        """Refuse while armed or recording: clearing a stop must resume only the setup that was armed."""
        self._setup.require_still()
        self._require_no_run()

    def _open(self, change: DeviceChange, command_id: int, answer: Callable[[], Answer]) -> None:
        """Open a device in a thread; the command is answered when the device is open, or refused with the reason."""

        def finish(failure: Text | str | None) -> None:
            if failure is not None:
                self._server.refuse(command_id, failure)
                return
            try:
                self._settle()
                fields = answer()
            except Exception as error:  # a sentence, as for a defect of any other command
                self._server.refuse(command_id, defect(change.what, error))
            else:
                self._server.answer(command_id, **fields)

        self._openings.begin(change, finish)

    def _settle(self) -> None:
        """Move new objects to the long-lived memory of the garbage collector; begin a new deadline of the loop."""
        collect_garbage()
        self._loop.begin_anew()


def _refuse(sentence: Text | None) -> None:
    """Raise CommandRefused with a sentence, if there is one."""
    if sentence is not None:
        raise CommandRefused(sentence)


def arming_refusal(loop: ControlLoop, digest: str) -> Text | None:
    """Return in a sentence why the chair cannot be armed with what this hash names; None when it can."""
    setup, gate = loop.setup, loop.setup.chain.gate
    if loop.run is not None and loop.run.task is not None:
        return Text("drives-during-test")
    if setup.chain.parameters is None:
        return Text("drives-not-calibrated")
    if digest != setup.arming_hash:
        return Text("drives-controls-changed")
    missing = missing_brake(setup.chain.parameters)
    if missing is not None:
        return missing
    if gate.state is State.FAULT:
        what = EXPLANATIONS[gate.fault]
        return Text("drives-latched", happened=what.happened, remedy=what.remedy)
    return device_refusal(loop)


def device_refusal(loop: ControlLoop) -> Text | None:
    """Return in a sentence which device is no longer paired, or what a real chair still needs before it is armed."""
    setup = loop.setup
    chair, parameters = setup.link, setup.parameters
    lost = setup.network_shirt.lost_key() if setup.network_shirt else None
    if lost:
        return Text("drives-shirt-unpaired", problem=lost)
    lost = chair.lost_key() if chair else None
    if lost:
        return Text("drives-chair-unpaired", problem=lost)
    if chair is None or parameters is None:
        return None
    mistrust = setup.mistrust  # asked once: each time it asks the kernel, whose answer may change
    if mistrust is not None:
        return mistrust
    unconfirmed = own_movement_refusal(parameters)
    if unconfirmed is not None:
        return unconfirmed
    if loop.run is None:
        return Text("drives-only-recorded")
    if chair.silent:
        return chair.description()
    if chair.inhibited:
        return Text("drives-switch-pressed", state=chair.description())
    if parameters.keeps_speed and not chair.switch_reported:
        return Text("drives-switch-unproved")
    return None


def status(loop: ControlLoop) -> JsonDocument:
    """Return the state of shirt, chair and head tracker, in words and numbers."""
    setup = loop.setup
    arrivals = setup.arrivals
    return {
        "shirt": {
            "kind": setup.shirt_kind,
            "words": setup.shirt_description,
            "alive": loop.shirt_alive,
            "silent": loop.shirt_silent,
            "sample_rate": setup.sample_rate if setup.shirt else 0.0,
            "lost": setup.shirt.lost if setup.shirt else 0,
            "senders": _senders(setup.network_shirt),
            "found": setup.found_sensors,
            "arrivals": None if arrivals is None else arrivals._asdict(),
        },
        "chair": {
            "kind": setup.chair_kind,
            "words": setup.chair_description,
            "switch_seen": setup.link is not None and setup.link.switch_reported,
            "document": "" if setup.link is None else setup.link.document,
            "crawls": setup.link is not None and setup.link.crawls,
        },
        "head": {"kind": setup.head.kind, "words": setup.head.description},
        "dial": setup.chain.dial,
        "late": loop.late,
        "hash": setup.hash,
    }


def _senders(shirt: NetworkShirt | None) -> JsonDocument | None:
    if shirt is None:
        return None
    choice = shirt.sender_choice
    return {"shirt": choice.name, "other": choice.other, "others": choice.other_frames}
