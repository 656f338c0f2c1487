"""The help of the commands, from web_static/words/LANGUAGE/server/command_help.ftl, in the language of the terminal.

Typer takes a help when the module of its command is imported. Each message is one line without values, so that no
command loads Fluent for a help that it does not print.
"""

import re
from functools import cache
from typing import Final

from app.settings import static_folder
from app.texts import current_language

MESSAGE: Final = re.compile(r"^([a-z][\w-]*) = (.+)$", re.MULTILINE)


def help_text(*paragraphs: str) -> str:
    """Return a help; each paragraph is the id of a message."""
    messages = help_messages(current_language())
    return "\n\n".join(messages[paragraph] for paragraph in paragraphs)


@cache
def help_messages(language: str) -> dict[str, str]:
    """Return all messages of the help in a language, by their ids."""
    file = static_folder() / "words" / language / "server" / "command_help.ftl"
    return dict(MESSAGE.findall(file.read_text(encoding="utf-8")))
