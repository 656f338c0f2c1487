"""The tasks along a path: follow it, follow a leader, turn on the spot, drive backwards, or a course of stages."""

from typing import Annotated, Final, Literal

from pydantic import Field

from app.quantities import Document, Length, Line, Metres, Name, Radians, Seconds, Title

GOAL_RADIUS: Final = 0.5  # m around the end of a path or a stage that does not say how near is near enough

Points = Annotated[tuple[tuple[Metres, Metres], ...], Field(min_length=2, max_length=5000)]


class FollowPath(Document):
    """Drive along the path to its end."""

    kind: Literal["path"] = "path"


class FollowLeader(Document):
    """Stay behind a leader who moves along the path, until both have reached its end."""

    kind: Literal["follow"]
    leader: Name  # of one of the plan's movers
    distance: Annotated[Length, Field(le=10)] = 1.5  # m, between the middles of leader and chair


class Turn(Document):
    """Turn on the spot: stand on the path's first point and face its last point for `hold` seconds."""

    kind: Literal["turn"]
    direction: Literal["left", "right"]
    tolerance: Annotated[Radians, Field(gt=0, le=0.8)] = 0.1745  # rad
    hold: Annotated[Seconds, Field(le=10)] = 1.0  # s


class Back(Document):
    """Drive backwards along the path."""

    kind: Literal["back"]


SimpleTask = Annotated[FollowPath | Turn | Back, Field(discriminator="kind")]


class Stage(Document):
    """One part of a course."""

    title: Title
    instruction: Annotated[Line, Field(min_length=1, max_length=200)]
    points: Points
    goal_radius: Length = GOAL_RADIUS
    task: SimpleTask = FollowPath()


class Course(Document):
    """Several stages in sequence; the path's own points are only drawn."""

    kind: Literal["course"]
    stages: Annotated[tuple[Stage, ...], Field(min_length=2, max_length=20)]


Task = Annotated[FollowPath | FollowLeader | Turn | Back | Course, Field(discriminator="kind")]
