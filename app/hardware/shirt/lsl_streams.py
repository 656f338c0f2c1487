"""Chooses LSL streams by what people seek, and makes a layout of what the streams say of themselves. No network."""

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Final, Literal, NamedTuple

from app.channel_names import different_names, joint_in_name, plain_channel_name
from app.hardware.base import HardwareError
from app.layout import MAX_CHANNELS, MAX_JOINTS, Channel, Joint, ShirtLayout
from app.lsl_library import OWN_SOURCE, LslInfo, LslLibrary
from app.texts import Text
from app.visible_text import one_line

Criterion = Literal["source_id", "name", "type", "host"]
Sought = Mapping[Criterion, tuple[str, ...]]
"""What a stream must have, by its fact: one of these values. Of several values each names a stream, to be joined."""

CRITERIA: Final[tuple[Criterion, ...]] = ("source_id", "name", "type", "host")
MOST_NAMED: Final = 3  # streams in a sentence
LONGEST_FACT: Final = 40  # characters of a stream's name or another fact, in a sentence: room for a UUID
LONGEST_UNIT: Final = 16
WHOLE: Final = "body"  # the joint of all channels, where their names give more joints than a layout may have


class StreamFacts(NamedTuple):
    """What a stream says of itself without its description."""

    source_id: str
    name: str
    type: str
    host: str
    channels: int
    format: int  # the type of its values, one of the library's constants cf_...
    rate: float  # Hz, 0 for a stream without a rate
    uid: str  # of this start of the stream

    @property
    def text(self) -> Text:
        """The stream in words, for a sentence."""
        facts = (self.name, self.type, self.source_id, self.host)
        name, type_, source, host = (one_line(fact, LONGEST_FACT) for fact in facts)
        return Text(
            "shirtdev-lsl-stream", name=name, type=type_ or "none", source=source or "none", host=host or "none"
        )

    def is_restart_of(self, earlier: "StreamFacts") -> bool:
        """Return whether this is an earlier stream from the same machine, started again."""
        return self[:6] == earlier[:6] and self.uid != earlier.uid


class ChannelFacts(NamedTuple):
    """What the description of a stream says of a channel; empty: nothing."""

    label: str = ""
    unit: str = ""
    joint: str = ""


def streams_in(lsl: LslLibrary, infos: Iterable[LslInfo]) -> dict[StreamFacts, LslInfo]:
    """Return the streams of numbers that are not this program's own, by their facts."""
    described = ((_facts(lsl, info), info) for info in infos)
    return {facts: info for facts, info in described if facts is not None}


def sought_of(fields: Mapping[Criterion, str | None]) -> Sought:
    """Return what is sought, of fields in which commas separate several values; an empty field seeks nothing."""
    split = {name: [value.strip() for value in (text or "").split(",")] for name, text in fields.items()}
    return {name: tuple(dict.fromkeys(filter(None, values))) for name, values in split.items() if any(values)}


def chosen_streams(visible: Sequence[StreamFacts], sought: Sought) -> tuple[StreamFacts, ...]:
    """Return the only stream that fits what is sought, or one for each of several values, in their order.

    Raises
    ------
    HardwareError
        When none fits, or several do.
    """
    fitting = [facts for facts in visible if all(getattr(facts, name) in sought[name] for name in sought)]
    listed = max(sought, key=lambda name: len(sought[name]), default=None)
    if listed is None or len(sought[listed]) == 1:
        return (_the_only(fitting, visible, sought),)
    return tuple(
        _the_only([facts for facts in fitting if getattr(facts, listed) == value], visible, {listed: (value,)})
        for value in sought[listed]
    )


def channels_of(info: LslInfo) -> list[ChannelFacts]:
    """Return what the description of a stream says of each of its channels."""
    count, found = info.channel_count(), list[ChannelFacts]()
    try:
        channel = info.desc().child("channels").child("channel")
        while not channel.empty() and len(found) < count:
            found.append(ChannelFacts(*(channel.child_value(name) for name in ChannelFacts._fields)))
            channel = channel.next_sibling("channel")
    except UnicodeDecodeError:  # written on a machine with another code page
        found.clear()
    return found + [ChannelFacts()] * (count - len(found))


def layout_of(streams: Sequence[tuple[StreamFacts, Sequence[ChannelFacts]]]) -> ShirtLayout:
    """Return the layout of the channels of all streams, in their order.

    Channels are named by their labels, or else by their stream. A channel's joint is the one of the description, or
    else the channel's name without the number or axis at its end.

    Raises
    ------
    HardwareError
        When there are too many channels.
    """
    described = [(facts, channel) for facts, channels in streams for channel in channels]
    if len(described) > MAX_CHANNELS:
        raise HardwareError(Text("shirtdev-lsl-channels", channels=len(described), most=MAX_CHANNELS))
    of_streams = [plain_channel_name(facts.name) or "channel" for facts, _ in described]
    labels = [
        plain_channel_name(channel.label) or f"{stream}_{number}"
        for stream, (_, channel), number in zip(of_streams, described, _numbers(streams), strict=True)
    ]
    named = [
        plain_channel_name(channel.joint) or joint_in_name(label)
        for label, (_, channel) in zip(labels, described, strict=True)
    ]
    choices = (named, of_streams, [WHOLE] * len(described))
    joints = next(joints for joints in choices if len(set(joints)) <= MAX_JOINTS)
    channels = tuple(
        Channel(name=name, joint=joint, unit=_unit(channel.unit))
        for name, joint, (_, channel) in zip(different_names(labels), joints, described, strict=True)
    )
    title = one_line(", ".join(facts.name for facts, _ in streams), 80) or "LSL"
    return ShirtLayout(
        name=title,
        channels=channels,
        joints=tuple(Joint(name=joint, label=joint.replace("_", " ").capitalize()) for joint in dict.fromkeys(joints)),
    )


def _facts(lsl: LslLibrary, info: LslInfo) -> StreamFacts | None:
    """Return the facts of a stream, None when it cannot be a shirt."""
    try:
        texts = info.source_id(), info.name(), info.type(), info.hostname()
    except UnicodeDecodeError:  # of a machine with another code page: people could not name it either
        return None
    if info.channel_format() == lsl.cf_string or texts[0].startswith(OWN_SOURCE):
        return None
    rate = info.nominal_srate()
    rate = rate if 0.0 < rate < math.inf else 0.0
    return StreamFacts(*texts, info.channel_count(), info.channel_format(), rate, info.uid())


def _the_only(fitting: Sequence[StreamFacts], visible: Sequence[StreamFacts], sought: Sought) -> StreamFacts:
    if len(fitting) == 1:
        return fitting[0]
    listed = [facts.text for facts in (fitting or visible)[:MOST_NAMED]]
    values = [one_line(value, LONGEST_FACT) for values in sought.values() for value in values][:MOST_NAMED]
    if fitting:
        raise HardwareError(Text("shirtdev-lsl-several", count=len(fitting), streams=listed))
    if not visible:
        raise HardwareError(Text("shirtdev-lsl-nothing"))
    raise HardwareError(Text("shirtdev-lsl-none", sought=values, streams=listed))


def _numbers(streams: Sequence[tuple[StreamFacts, Sequence[ChannelFacts]]]) -> Iterator[int]:
    """Yield the number of each channel in its stream, from 1."""
    for _, channels in streams:
        yield from range(1, len(channels) + 1)


def _unit(text: str) -> str | None:
    unit = one_line(text, LONGEST_UNIT)
    return unit if unit and unit == text.strip() and unit.lower() != "none" else None
