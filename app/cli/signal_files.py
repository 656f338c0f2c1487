"""`bodydrive signals`: what a file of signals holds and how it is read; written anew, it is corrected."""

import io
import json
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from app.cli.common_options import AsJson
from app.cli.errors import InputError
from app.cli.help_text import help_text
from app.cli.output import warn, write_output
from app.cli.signal_options import (
    ChannelNames,
    PartName,
    SampleRate,
    TimeName,
    TimeUnit,
    reading_options,
    signals_refused,
)
from app.number_format import percent
from app.plain_table import table_lines
from app.texts import Figure, Text, value_text

if TYPE_CHECKING:
    from app.layout import ShirtLayout
    from app.signals.overview import FileOverview
    from app.signals.signals import Signals

TITLES = ("column", "unit", "role", "joint", "least", "most", "missing")
PARQUET = ".parquet"

signals_app = typer.Typer(no_args_is_help=True, pretty_exceptions_enable=False)


@signals_app.callback()
def _signals() -> None:
    """Make typer keep the sub-command `show`, although it is the only one."""


@signals_app.command("show", help=help_text("cli-help-signals-show"))
def show(
    file: Annotated[Path, typer.Argument(metavar="FILE", help=help_text("cli-help-signals"))],
    *,
    layout: Annotated[Path | None, typer.Option(help=help_text("cli-help-signals-layout"))] = None,
    time: TimeName = None,
    unit: TimeUnit = None,
    rate: SampleRate = None,
    channels: ChannelNames = None,
    part: PartName = None,
    out: Annotated[Path | None, typer.Option(help=help_text("cli-help-signals-out"))] = None,
    as_json: AsJson = False,
) -> None:
    """Show what a file of signals holds: its columns, its time with its unit, its sample rate, its channels and joints.

    What a person must correct first is shown, too, and refused only where the signals are to be written.
    """
    from app.hardware.shirt.playback import layout_beside
    from app.signals.overview import overview
    from app.signals.signals import read_layout

    if out is not None and out.suffix != PARQUET:
        raise InputError(Text("cli-signals-suffix", file=str(out)))
    options = reading_options(time, unit, rate, channels, part)
    try:
        shirt = read_layout(layout) if layout is not None else layout_beside(file)
        found = overview(file, shirt, options)
    except ValueError as error:
        raise signals_refused(error) from error
    if out is not None:
        if found.signals is None:
            raise signals_refused(ValueError(found.problem))
        write_output(out, _content_of(found.signals), file)
    joints = {} if found.signals is None else _joints(shirt, found.signals)
    if as_json:
        typer.echo(json.dumps(_document(file, found, joints), allow_nan=False))
        return
    typer.echo("\n".join(_lines(found, joints)))
    warn(None if found.problem is None else str(signals_refused(ValueError(found.problem))))
    if out is not None:
        typer.echo(Text("cli-file-written", file=str(out)))


def _joints(layout: "ShirtLayout | None", signals: "Signals") -> Mapping[str, str]:
    """Return the joint of each channel, as a layout or the names say it."""
    from app.signals.joint_names import proposed_joints

    if layout is None:
        return proposed_joints(signals.channel_names)
    return {name: channel.joint for name, channel in zip(signals.channel_names, layout.channels, strict=True)}


def _lines(found: "FileOverview", joints: Mapping[str, str]) -> list[str]:
    """Return the table of columns, then how the file is read."""
    from app.signals.file_table import listed

    rows = [
        (
            column.name,
            column.unit or "-",
            Text("cli-signals-role", role=column.role),
            joints.get(column.name, "-"),
            "-" if column.least is None else value_text(column.least),
            "-" if column.most is None else value_text(column.most),
            "-" if column.missing is None else percent(column.missing, 1),
        )
        for column in found.columns
    ]
    titles = [Text(f"cli-signals-title-{title}") for title in TITLES]
    lines = [*table_lines([titles, *rows], left=(0, 1, 2, 3)), ""]
    if found.dialect is not None and found.dialect.sentence:
        lines.append(str(found.dialect.sentence))
    if found.parts:
        lines.append(str(Text("cli-signals-parts", names=listed([part.name for part in found.parts]))))
    signals = found.signals
    if signals is None:
        return lines
    if found.time is not None:
        lines.append(str(Text("signals-time-read", column=found.time, unit=found.unit or "s")))
    summary = Text(
        "cli-signals-summary",
        rows=len(signals.t),
        seconds=Figure(float(signals.t[-1] - signals.t[0]), 2),
        rate=signals.sample_rate,
        channels=len(signals.channel_names),
    )
    lines.append(str(summary))
    if signals.damage is not None and signals.damage.id != "signals-time-read":
        lines.append(str(signals.damage))
    return lines


def _document(file: Path, found: "FileOverview", joints: Mapping[str, str]) -> dict[str, object]:
    """Return the object of `--json`."""
    signals, dialect = found.signals, found.dialect
    time = None if found.time is None else {"column": found.time, "unit": found.unit, "stated": found.is_stated}
    return {
        "file": str(file),
        "kind": found.kind,
        "parts": [part.name for part in found.parts],
        "rows": found.rows,
        "dialect": None if dialect is None else dialect._asdict(),
        "columns": [
            {
                "name": column.name,
                "unit": column.unit,
                "role": column.role,
                "joint": joints.get(column.name),
                "least": column.least,
                "most": column.most,
                "missing": column.missing,
            }
            for column in found.columns
        ],
        "time": time,
        "sample_rate": None if signals is None else signals.sample_rate,
        "seconds": None if signals is None else float(signals.t[-1] - signals.t[0]),
        "channels": None if signals is None else signals.channel_names,
        "joints": dict(joints),
        "message": None if signals is None or signals.damage is None else str(signals.damage),
        "problem": None if found.problem is None else str(found.problem),
    }


def _content_of(signals: "Signals") -> bytes:
    """Return the signals as a Parquet file: t in seconds, and the channels."""
    import pyarrow as pa
    import pyarrow.parquet

    columns = {name: signals.values[:, index] for index, name in enumerate(signals.channel_names)}
    content = io.BytesIO()
    pyarrow.parquet.write_table(pa.table({"t": signals.t, **columns}), content, compression="zstd")
    return content.getvalue()
