"""Reads the trajectory of a bag of ROS 1, or of a .db3 file of ROS 2, with rosbags."""

from collections.abc import Iterator
from pathlib import Path
from typing import Final

from app.signals.foreign.poses import TopicMessage, trajectory_of
from app.signals.foreign.recording import ForeignRecording, library

DESCRIPTION: Final = "metadata.yaml"  # of a bag of ROS 2, in its folder
OF_PLACES: Final = ("Odometry", "Pose", "PoseStamped", "PoseWithCovarianceStamped", "PointStamped", "Pose2D")


def read(file: Path, _part: str | None = None) -> ForeignRecording:
    """Return t, x and y."""
    return trajectory_of(_messages(file))


def _messages(file: Path) -> Iterator[TopicMessage]:
    highlevel, typesys = library("rosbags.highlevel"), library("rosbags.typesys")
    place = file.parent if (file.parent / DESCRIPTION).is_file() and file.suffix != ".bag" else file
    types = typesys.get_typestore(typesys.Stores.ROS2_HUMBLE)  # for bags that do not describe their messages
    with highlevel.AnyReader([place], default_typestore=types) as reader:
        chosen = [each for each in reader.connections if each.msgtype.rpartition("/")[2] in OF_PLACES]
        for connection, recorded, content in reader.messages(connections=chosen) if chosen else ():
            yield TopicMessage(connection.topic, recorded, reader.deserialize(content, connection.msgtype))
