"""What changed on the server: the live socket sends it to the pages, which ask again only for what it concerns."""

from collections.abc import Callable
from typing import Literal, Self

from pydantic import BaseModel, ConfigDict, Field, model_validator

What = Literal[
    "adaptation",
    "backups",
    "calibration",
    "comment",
    "consent",
    "controls",
    "deletion",
    "disk",
    "drive",
    "equipment",
    "graphics",
    "layouts",
    "phones",
    "record",
    "restoration",
    "screens",
    "session",
    "shares",
    "test",
    "trial",
]


class News(BaseModel):
    """What changed, and the ids of the patient, session and trial that it concerns.

    An id that is None was not known without a further query: the news may concern every patient, session or trial.
    Equal items that wait for a page are sent once.
    """

    model_config = ConfigDict(frozen=True, extra="forbid")

    what: What
    patient: int | None = Field(None, description="A page that may not see this patient does not get the news.")
    session: int | None = None
    trial: int | None = None

    @model_validator(mode="after")
    def _names_the_patient(self) -> Self:
        if self.patient is None and (self.session is not None or self.trial is not None):
            raise ValueError("news of a session or a trial names its patient: the patient decides which pages get it")
        return self


Notify = Callable[[News], None]
"""Sends news to the open pages."""
