"""Options of the commands that read signals: how a person corrects what a file says of its time and its channels."""

from typing import TYPE_CHECKING, Annotated

import typer

from app.cli.errors import InputError
from app.cli.help_text import help_text
from app.texts import Text, text_of

if TYPE_CHECKING:
    from app.signals.signals import ReadingOptions

TimeName = Annotated[str | None, typer.Option("--time", metavar="COLUMN", help=help_text("cli-help-signals-time"))]
TimeUnit = Annotated[str | None, typer.Option("--unit", help=help_text("cli-help-signals-unit"))]
SampleRate = Annotated[float | None, typer.Option("--rate", help=help_text("cli-help-signals-rate"))]
ChannelNames = Annotated[
    str | None, typer.Option("--channels", metavar="A,B,...", help=help_text("cli-help-signals-channels"))
]
PartName = Annotated[str | None, typer.Option("--part", metavar="NAME", help=help_text("cli-help-signals-part"))]
# Refusals that a person can answer with these options.
TO_CORRECT = ("signals-time-", "signals-unit-", "signals-uneven", "signals-shared-uneven", "signals-bursts-uneven")


def reading_options(
    time: str | None, unit: str | None, rate: float | None, channels: str | None, part: str | None = None
) -> "ReadingOptions":
    """Return what the options say, or raise InputError with the option that is wrong."""
    from app.signals.sampling_times import FASTEST, SLOWEST
    from app.signals.signals import ReadingOptions

    if rate is not None and not SLOWEST <= rate <= FASTEST:
        raise InputError(Text("cli-signals-rate", rate=f"{rate:g}", least=f"{SLOWEST:g}", most=f"{FASTEST:g}"))
    names = None if channels is None else tuple(name.strip() for name in channels.split(","))
    if names is not None and (not all(names) or len(set(names)) < len(names)):
        raise InputError(Text("cli-signals-channels", channels=channels or ""))
    return ReadingOptions(time=time, unit=time_unit(unit), rate=rate, channels=names, part=part)


def time_unit(unit: str | None) -> str | None:
    """Return the unit that `--unit` means, or raise InputError."""
    from app.signals.time_names import SECONDS, unit_of_word

    if unit is None:
        return None
    known = unit_of_word(unit)
    if known is None:
        raise InputError(Text("cli-signals-unit", unit=unit, known=", ".join(SECONDS)))
    return known


def signals_refused(error: Exception) -> InputError:
    """Return the error of a command for signals that cannot be read, with the options that help."""
    text = text_of(error)
    if isinstance(text, Text) and text.id.startswith(TO_CORRECT):
        return InputError(Text("cli-signals-correct", problem=text))
    return InputError(text)
