"""Reads the trajectory of an MCAP file with mcap: messages in JSON, and of ROS 2 with mcap-ros2-support."""

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any, Final

from app.signals.foreign.poses import TopicMessage, trajectory_of
from app.signals.foreign.recording import ForeignRecording, library

JSON: Final = "json"
ROS_2: Final = "cdr"


def read(file: Path, _part: str | None = None) -> ForeignRecording:
    """Return t, x and y."""
    return trajectory_of(_messages(file))


def _messages(file: Path) -> Iterator[TopicMessage]:
    make_reader = library("mcap.reader").make_reader
    decoders: Any = None
    with file.open("rb") as opened:
        for schema, channel, message in make_reader(opened).iter_messages():
            if channel.message_encoding == JSON:
                yield TopicMessage(channel.topic, message.log_time, json.loads(message.data))
            elif channel.message_encoding == ROS_2:
                decoders = decoders or library("mcap_ros2.decoder").DecoderFactory()
                decode = decoders.decoder_for(channel.message_encoding, schema)
                if decode is not None:
                    yield TopicMessage(channel.topic, message.log_time, decode(message.data))
