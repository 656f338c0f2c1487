"""Where an imported session, with all that belongs to it, came from."""

from app.api.answers import Answer, MomentText


class OriginView(Answer):
    """The clinic that a session was held in, and who imported it when."""

    clinic: str
    person: str
    at: MomentText
