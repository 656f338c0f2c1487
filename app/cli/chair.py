"""`bodydrive chair`: pair with a real chair, measure it, rehearse without it, and run the receiver on the chair."""

import json
import platform
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from app import __version__
from app.cli.common_options import State, settings_of
from app.cli.errors import InputError
from app.cli.help_text import help_text
from app.cli.output import check_new_folder, write_output
from app.cli.qr import terminal_code
from app.clock import MonotonicClock, utc_now
from app.file_modes import keep_new_files_private
from app.hardware.chair import receive as receiver
from app.ports import RECEIVER_PORT
from app.refusals import Refusal
from app.settings import Settings
from app.texts import Text, text_of

if TYPE_CHECKING:
    from app.hardware.chair.key import Key
    from app.hardware.chair.rehearsal import StepResult
    from app.hardware.configs import RealChairConfig

chair_app = typer.Typer(no_args_is_help=True, pretty_exceptions_enable=False)

MOST_LETTERS = 80  # of a name in a record
Limit = Annotated[float | None, typer.Option(help=help_text("cli-help-chair-pair-limit"))]


@chair_app.command(
    "receive",
    help=help_text("cli-help-chair-receive"),
    add_help_option=False,  # the receiver has its own --help
    context_settings={"allow_extra_args": True, "ignore_unknown_options": True},
)
def receive(context: typer.Context) -> None:
    """Run on the chair: check commands, watch the time, ramp, and drive an output."""
    raise typer.Exit(receiver.main(context.args, "bodydrive chair receive"))


@chair_app.command(
    "measure",
    help=help_text("cli-help-chair-measure"),
    add_help_option=False,  # the program has its own --help
    context_settings={"allow_extra_args": True, "ignore_unknown_options": True},
)
def measure(context: typer.Context) -> None:
    """Run on the chair: measure by guided drives which speed a deflection of the joystick gives."""
    from app.hardware.chair import chair_measure  # of a Unix terminal only

    raise typer.Exit(chair_measure.main(context.args, "bodydrive chair measure"))


@chair_app.command("rehearse", help=help_text("cli-help-chair-rehearse", "cli-help-chair-rehearse-record"))
def rehearse(
    *,
    key_file: Annotated[Path, typer.Option(help=help_text("cli-help-chair-rehearse-key-file"))],
    out: Annotated[Path, typer.Option(help=help_text("cli-help-chair-rehearse-out"))],
    who: Annotated[str, typer.Option(help=help_text("cli-help-chair-rehearse-who"))] = "",
    output: Annotated[str, typer.Option(help=help_text("cli-help-chair-rehearse-output"))] = "sim",
    verify: Annotated[bool, typer.Option("--verify", help=help_text("cli-help-chair-rehearse-verify"))] = False,
) -> None:
    """Arm, drive, stop and disturb a receiver whose chair is emulated; write a signed record, or check one."""
    from app.hardware.chair.key import KeyRefused, read_key
    from app.hardware.chair.link_texts import refusal_text
    from app.hardware.chair.rehearsal import STEPS, record_of
    from app.speed_limits import FIRST_CHAIR_SPEEDS

    try:
        key = read_key(key_file)
    except KeyRefused as error:
        raise InputError(refusal_text(error)) from error
    if verify:
        _verify_record(out, key)
        return
    if output not in STEPS:
        raise InputError(Text("cli-rehearsal-no-output", output=output, outputs=", ".join(STEPS)))
    if not who.strip() or len(who) > MOST_LETTERS or not who.isprintable():
        raise InputError(Text("cli-rehearsal-no-who", most=MOST_LETTERS))
    if out.suffix != ".json":
        raise InputError(Text("cli-rehearsal-no-json", file=str(out)))
    check_new_folder(out.parent)
    results = _rehearsed(key_file, output)
    date = utc_now().isoformat(timespec="seconds")
    about = {"version": __version__, "python": platform.python_version(), "output": output, "who": who, "date": date}
    record = record_of(results, key, **about, speeds=FIRST_CHAIR_SPEEDS.model_dump())
    page = [
        f"# {Text('cli-rehearsal-title')}",
        str(Text("cli-rehearsal-about", who=who, date=date, version=__version__, output=output, key=str(key.id))),
        "\n".join(f"{number}. {_sentence(result)}" for number, result in enumerate(results, 1)),
        str(Text("cli-rehearsal-no-chair")),
        str(Text("cli-rehearsal-signed", file=out.name, digest=str(record["sha256"]), tag=str(record["hmac"]))),
    ]
    write_output(out, f"{json.dumps(record, indent=1)}\n".encode())
    write_output(out.with_suffix(".md"), ("\n\n".join(page) + "\n").encode())
    kept = sum(result.is_kept for result in results)
    typer.echo(Text("cli-rehearsal-end", kept=kept, steps=len(results), file=str(out)))
    raise typer.Exit(0 if kept == len(results) else 1)


def _rehearsed(key_file: Path, output: str) -> "list[StepResult]":
    """Go through all steps, and say each as it ends."""
    from app.hardware.base import HardwareError
    from app.hardware.chair.rehearsal import STEPS
    from app.hardware.chair.rehearsal_run import Rehearsal

    try:
        rehearsal = Rehearsal(key_file, output, MonotonicClock())
    except HardwareError as error:
        raise InputError(text_of(error)) from error
    results = []
    try:
        for step in STEPS[output]:
            results.append(rehearsal.run(step))
            typer.echo(_sentence(results[-1]))
    finally:
        rehearsal.close()
    return results


def _sentence(result: "StepResult") -> str:
    """Return what was done in a step, what had to happen, and what happened."""
    how = "never" if result.took_ms is None else "kept" if result.is_kept else "late"
    what, must = Text("cli-rehearsal-step", step=result.step), Text("cli-rehearsal-must", step=result.step)
    return f"{what} {must} {Text('cli-rehearsal-result', how=how, took=result.took_ms or 0, limit=result.limit_ms)}"


def _verify_record(file: Path, key: "Key") -> None:
    """Say that a record is as it was signed, or refuse it."""
    from app.hardware.chair.rehearsal import is_genuine

    try:
        record = json.loads(file.read_text(encoding="utf-8"))
    except (ValueError, RecursionError):
        record = None
    if not is_genuine(record, key):
        raise InputError(Text("cli-rehearsal-false", file=str(file)))
    typer.echo(Text("cli-rehearsal-genuine", file=str(file)))


@chair_app.command("pair", help=help_text("cli-help-chair-pair", "cli-help-chair-pair-units"))
def pair(
    *,
    name: Annotated[str, typer.Option(help=help_text("cli-help-chair-pair-name"))],
    host: Annotated[str, typer.Option(help=help_text("cli-help-chair-pair-host"))],
    port: Annotated[int, typer.Option(min=1, max=65_535, help=help_text("cli-help-chair-pair-port"))] = RECEIVER_PORT,
    state: State = None,
    forward: Limit = None,
    reverse: Limit = None,
    turn: Limit = None,
    acceleration: Limit = None,
    deceleration: Limit = None,
    turn_acceleration: Limit = None,
    jerk: Limit = None,
    turn_jerk: Limit = None,
) -> None:
    """Make a key for a chair, keep it with the clinic, and show it once as a QR code.

    Speeds are in m/s and rad/s, accelerations in m/s2 and rad/s2, jerks in m/s3 and rad/s3.
    """
    settings = settings_of(state)
    limits = {
        "forward": forward,
        "reverse": reverse,
        "turn": turn,
        "acceleration": acceleration,
        "deceleration": deceleration,
        "turn_acceleration": turn_acceleration,
        "jerk": jerk,
        "turn_jerk": turn_jerk,
    }
    speeds = {word: number for word, number in limits.items() if number is not None}
    chair = _chair_config({"name": name, "host": host, "port": port, "speeds": speeds}, settings.keys)
    try:
        key = _store_pairing(chair, settings)
    except Refusal as refusal:
        raise InputError(text_of(refusal)) from refusal
    typer.echo(terminal_code(key.line))
    _print_instructions(chair, key, settings.keys)


def _chair_config(fields: dict[str, object], keys: Path) -> "RealChairConfig":
    """Return the configuration with which the control process will open the chair."""
    from pydantic import ValidationError

    from app.hardware.configs import RealChairConfig
    from app.sentences import one_sentence

    try:
        return RealChairConfig.model_validate({"kind": "udp", "key_file": str(keys / "0.key"), **fields})
    except ValidationError as error:
        raise InputError(one_sentence(error, Text("cli-the-chair"))) from error


def _store_pairing(chair: "RealChairConfig", settings: Settings) -> "Key":
    """Store the chair and write its key, both or none; the clinic may be served meanwhile."""
    from app.session.equipment.pairing import key_file, pair_chair
    from app.store.database import Database
    from app.store.log import write_log
    from app.store.people import add_clinic, the_clinic

    keep_new_files_private()
    database, key = Database(settings.database), None
    try:
        with database.transaction() as db:
            clinic = the_clinic(db) or add_clinic(db, str(Text("cli-clinic-name")))
            row, key = pair_chair(db, clinic, settings.keys, chair.name, chair.host, chair.port, chair.speeds)
            write_log(db, None, "chair paired", chair=row.id, key_id=key.id, host=chair.host, port=chair.port)
    except BaseException:
        if key is not None:
            key_file(settings.keys, key.id).unlink(missing_ok=True)
        raise
    finally:
        database.close()
    return key


def _print_instructions(chair: "RealChairConfig", key: "Key", keys: Path) -> None:
    file = f"{key.id}.key"
    anywhere = "::" if ":" in chair.host else "0.0.0.0"  # noqa: S104  (the chair's board, not this machine)
    fastest = max(chair.speeds.forward, chair.speeds.reverse)
    typer.echo(Text("cli-chair-paired", name=chair.name, host=chair.host, port=chair.port, file=str(keys / file)))
    typer.echo(Text("cli-chair-next", file=file))
    typer.echo(
        f"bodydrive chair receive --key-file {file} --output ros2 --bind {anywhere} --port {chair.port} "
        f"--v-max {fastest:g} --omega-max {chair.speeds.turn:g}"
    )
