"""The rule for an upload whose name is taken: no file is replaced unless a person chooses that."""

from collections.abc import Collection
from itertools import count
from pathlib import PurePath
from typing import Literal

from app.refusals import Conflict
from app.similar_names import require_distinct
from app.texts import Text

LONGEST_NAME = 64

SameName = Literal["ask", "keep-both", "replace"]


class NameTaken(Conflict):
    """The name is taken: a person chooses between the proposed free name and replacing the file."""

    def __init__(self, sentence: Text, proposed: str, *, may_replace: bool) -> None:
        super().__init__(sentence)
        self.proposed = proposed
        self.may_replace = may_replace


def log_details(same_name: SameName) -> dict[str, str]:
    """Return the details for the log: the choice of a person, or nothing when there was none."""
    return {} if same_name == "ask" else {"same_name": same_name}


def name_for(name: str, taken: Collection[str], same_name: SameName, *, may_replace: bool = True) -> str:
    """Return the name under which an upload is stored; names that differ only in case count as equal.

    Raises
    ------
    Conflict
        When the name looks like another one, and nobody said that both are to be kept.
    NameTaken
        When the name is taken and nobody chose, or when the file of this name cannot be replaced.
    """
    standing = next((other for other in sorted(taken) if other.lower() == name.lower()), None)
    if standing is None:
        if same_name == "ask":
            require_distinct(name, taken, "names-file-taken")
        return name
    proposed = free_name(name, taken)
    if same_name == "keep-both":
        return proposed
    if same_name == "replace" and may_replace:
        return standing
    replaceable, fixed = Text("store-name-taken-replace", name=standing), Text("store-name-taken", name=standing)
    raise NameTaken(replaceable if may_replace else fixed, proposed, may_replace=may_replace)


def free_name(name: str, taken: Collection[str]) -> str:
    """Return the name with the first number from 2 on that makes it free: walk.csv, walk-2.csv."""
    lower = {other.lower() for other in taken}
    suffix = PurePath(name).suffix if "." in name else ""
    stem = name.removesuffix(suffix)
    for number in count(2):
        ending = f"-{number}{suffix}"
        proposed = stem[: LONGEST_NAME - len(ending)] + ending
        if proposed.lower() not in lower:
            return proposed
    raise AssertionError
