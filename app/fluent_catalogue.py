"""The catalogue of sentences: web_static/words/LANGUAGE/, read by fluent.runtime; numbers, dates and lists by Babel.

Only `app/texts.py` imports it, when the first sentence is made: the control process makes none.
"""

import re
from collections.abc import Mapping, Sequence
from datetime import date, datetime, time
from decimal import localcontext
from functools import cache
from math import isfinite
from typing import Any, Final

from babel import Locale
from babel.dates import format_date, format_time
from babel.lists import format_list
from babel.numbers import get_decimal_symbol
from fluent.runtime import FluentBundle, FluentResource, resolver
from fluent.runtime.types import FluentType, fluent_number

from app.number_format import with_minus
from app.settings import static_folder

DIGITS: Final = 350  # of the largest number with its decimals: Babel refuses to round a longer one
LOCALES: Final = {"en": "en_GB"}  # for dates and lists, where it is not the language: "a, b and c"
DAYS: Final = {"en": "yyyy-MM-dd"}  # how a day is written, where it is not the usual way of the language
HELP: Final = "command_help.ftl"  # read without Fluent (app/cli/help_text.py)
ENTRIES: Final = re.compile(r"^(?=[-A-Za-z#])", re.MULTILINE)  # where a message, a term or a comment begins
REFERENCE: Final = re.compile(r"\{\s*(-?[a-z][\w-]*)")  # to a message or a term
resolver.MAX_PART_LENGTH = 1_000_000  # characters of a value; with more, the whole message would be "{???}"


def load(language: str) -> None:
    """Read the messages of a language, except the help of the command line."""
    _bundle(language)
    _sources(language)


def sentence(language: str, message: str, values: dict[str, Any]) -> str:
    """Return a message with its values in a language; its id where the catalogue has no such message."""
    bundle = _bundle(language)
    if not bundle.has_message(message):
        _parse(bundle, _sources(language), message)
    pattern = bundle.get_message(message).value if bundle.has_message(message) else None
    with localcontext(prec=DIGITS):
        return message if pattern is None else str(bundle.format_pattern(pattern, values)[0])


def number(value: float) -> Any:
    """Return a number as it is, by which a message may choose a plural, or which it groups by thousands."""
    if not isfinite(value):
        return str(value)
    return fluent_number(value, useGrouping=False, maximumFractionDigits=15)


def figure(language: str, value: float, digits: int) -> str:
    """Return a number with a fixed count of decimals, and the sign for minus."""
    written = f"{round(value, digits) + 0.0:.{digits}f}"  # + 0.0: never -0
    return with_minus(written).replace(".", get_decimal_symbol(_locale(language)))


def written(language: str, value: Any) -> str:
    """Return a value of a message as the message writes it."""
    with localcontext(prec=DIGITS):
        return value.format(Locale.parse(_locale(language))) if isinstance(value, FluentType) else str(value)


def moment(language: str, value: date | time) -> str:
    """Return a day, a time of day, or both of a `datetime`: in this computer's time zone if it has one."""
    if isinstance(value, datetime):
        local = value.astimezone() if value.tzinfo else value
        return f"{moment(language, local.date())} {moment(language, local.time())}"
    if isinstance(value, time):
        return format_time(value, "short", locale=_locale(language))
    return format_date(value, DAYS.get(language, "medium"), locale=_locale(language))


def joined(language: str, items: Sequence[str]) -> str:
    """Return "a, b and c"."""
    return format_list(items, locale=_locale(language))


def _locale(language: str) -> str:
    return LOCALES.get(language, language)


@cache
def _bundle(language: str) -> FluentBundle:
    """Return the messages that were asked for; to parse all takes some tenths of a second."""
    return FluentBundle([_locale(language)], use_isolating=False)


@cache
def _sources(language: str) -> Mapping[str, str]:
    """Return the source of each message by its id; of two with the same id, the first."""
    sources: dict[str, str] = {}
    files = (static_folder() / "words" / language).rglob("*.ftl")
    for file in sorted(file for file in files if file.name != HELP):
        for entry in ENTRIES.split(file.read_text(encoding="utf-8")):
            sources.setdefault(entry.partition("=")[0].strip(), f"{entry}\n")
    return sources


def _parse(bundle: FluentBundle, sources: Mapping[str, str], message: str) -> None:
    """Add a message to a bundle, after all that it refers to: another thread that finds it there finds them, too."""
    added = [message]
    for each in added:
        added.extend(other for other in REFERENCE.findall(sources.get(each, "")) if other not in added)
    bundle.add_resource(FluentResource("".join(sources.get(each, "") for each in reversed(added))))
