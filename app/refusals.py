"""Refusals of a request: exceptions whose message is one sentence for the person, with what to do."""

from app.texts import Text

NO_ROOM = Text("refused-no-room")


class Refusal(Exception):  # noqa: N818
    """A request that cannot be carried out, with the text that says why and what to do."""


class NotFound(Refusal):
    """The requested thing does not exist, or belongs to another clinic."""


class OtherClinicRow(NotFound):
    """The requested row belongs to another clinic: answered like `NotFound`, and noted in the log."""

    def __init__(self, sentence: Text | str, kind: str, row_id: int) -> None:
        super().__init__(sentence)
        self.kind = kind  # name of the table
        self.row_id = row_id


class Conflict(Refusal):
    """The request contradicts the present state."""


class PatientHere(Conflict):
    """The patient of an archive is in the clinic already: a person chooses whether it is replaced."""


class Unavailable(Refusal):
    """A part of the program that the request needs is not available at the moment: try again."""


class DiskFull(Refusal):
    """There is no room on the disk."""
