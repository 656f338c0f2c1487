"""How the session refuses: one sentence that says what, where and what to do."""

NO_ROOM = "The disk is full, and nothing was kept of this: make room, then try again."


class Refusal(Exception):  # noqa: N818
    """What was asked cannot be done; the sentence says why and what to do."""


class NotFound(Refusal):
    """What was asked for does not exist, or not for this clinic."""


class OtherClinicRow(NotFound):
    """What was asked for belongs to another clinic: answered as what does not exist, and noted in the log."""

    def __init__(self, sentence: str, kind: str, row_id: int) -> None:
        super().__init__(sentence)
        self.kind = kind  # which table
        self.row_id = row_id


class Conflict(Refusal):
    """It exists, but cannot be done now."""


class Unavailable(Refusal):
    """A part that is needed is not there at the moment: try again."""


class DiskFull(Refusal):
    """There is no room on the disk."""
