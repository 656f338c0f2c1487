"""Why the parameters of the open session's patient cannot drive, in answers."""

from typing import Literal

from app.quantities import Document
from app.session.open_session import DriveObstacle
from app.texts import Text


class ObstacleView(Document):
    """Why a parameter set cannot drive, and the page on which that is mended."""

    message: Text | str
    page: Literal["shirt", "calibrate", "controls"]

    @classmethod
    def of(cls, obstacle: DriveObstacle | None) -> "ObstacleView | None":
        """Return the answer for an obstacle, None for none."""
        return None if obstacle is None else cls(message=obstacle.sentence, page=obstacle.page)
