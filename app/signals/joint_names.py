"""The joint of a channel by its name: that of JOINT_NUMBER, or the part of the body that other programs name."""

import re
import unicodedata
from collections import Counter
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Final

from app.layout import MAX_JOINTS, Channel, Joint, ShirtLayout
from app.signals.column_names import bare_name
from app.texts import Text

CHANNEL_OF_JOINT: Final = re.compile(r"(?P<joint>[A-Za-z0-9].*)_\d+")
WHOLE_BODY: Final = "body"  # the joint of channels whose names say nothing
SHORTEST: Final = 3  # letters of a word that names a joint
LONGEST: Final = 60  # letters of a joint: the name of a channel is longer by its number
WORD: Final = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+")  # LeftForeArm, EMG
SIDES: Final = {
    **dict.fromkeys(("left", "l", "lt", "izquierda", "izquierdo", "izq"), "left"),
    **dict.fromkeys(("links", "linke", "linken", "linker", "linkes"), "left"),
    **dict.fromkeys(("right", "r", "rt", "derecha", "derecho", "der"), "right"),
    **dict.fromkeys(("rechts", "rechte", "rechten", "rechter", "rechtes"), "right"),
}
ARTICLE: Final = "der"  # in German; in Spanish the right side, with at most an axis behind it
PARTS: Final = {
    "shoulder": (
        *("shoulder", "sho", "upa", "upperarm", "humerus", "deltoid", "arm"),
        *("schulter", "oberarm", "hombro", "brazo"),
    ),
    "elbow": (
        *("elbow", "elb", "frm", "forearm", "lowerarm", "ulna", "radius", "biceps", "triceps"),
        *("ellbogen", "ellenbogen", "unterarm", "codo", "antebrazo"),
    ),
    "wrist": ("wrist", "wri", "wra", "wrb", "hand", "handgelenk", "muneca", "mano"),
    "fingers": ("finger", "fingers", "fin", "thumb", "daumen", "dedo", "dedos", "pulgar"),
    "trunk": ("trunk", "torso", "chest", "sternum", "spine", "thorax", "pelvis", "rumpf", "brust", "tronco", "pecho"),
    "head": ("head", "neck", "kopf", "nacken", "cabeza", "cuello"),
    "hip": ("hip", "thigh", "femur", "huefte", "hufte", "oberschenkel", "cadera", "muslo"),
    "knee": ("knee", "shank", "tibia", "knie", "unterschenkel", "rodilla", "leg"),
    "ankle": ("ankle", "foot", "toe", "fuss", "knochel", "knoechel", "tobillo"),
}
PART_OF: Final = {word: part for part, words in PARTS.items() for word in words}
IN_THE_MIDDLE: Final = frozenset(("trunk", "head"))
BELOW: Final = {("fore", "arm"): "elbow", ("lower", "arm"): "elbow", ("up", "leg"): "hip", ("upper", "leg"): "hip"}
OF_NO_PART: Final = frozenset(  # words for what is measured, and along which axis
    (
        *("x", "y", "z", "w", "roll", "pitch", "yaw", "euler", "quat", "quaternion", "rotation", "position", "angle"),
        *("xrotation", "yrotation", "zrotation", "xposition", "yposition", "zposition", "channel", "ch", "column"),
        *("acc", "accel", "acceleration", "accelerometer", "gyr", "gyro", "gyroscope", "mag", "magn", "magnetometer"),
        *("emg", "ecg", "eda", "raw", "cal", "ln", "wr", "free", "mean", "marker", "error", "axis", "sensor", "imu"),
    )
)


def layout_from_names(path: Path, names: Sequence[str]) -> ShirtLayout:
    """Return a layout for channels that are named after their joints, apart from a unit: right_elbow_1 [mV] ...

    Raises
    ------
    ValueError
        When a name does not say its joint.
    """
    channels = []
    for name in names:
        bare, _ = bare_name(name)
        match = CHANNEL_OF_JOINT.fullmatch(bare)
        if match is None:
            layout = f"{path.stem}.layout.json"
            raise ValueError(Text("shirtdev-file-no-joint", file=str(path), column=name, layout=layout))
        channels.append(Channel(name=bare, joint=match["joint"]))
    joints = tuple(dict.fromkeys(channel.joint for channel in channels))
    return ShirtLayout(
        name=path.stem[:80],
        channels=tuple(channels),
        joints=tuple(Joint(name=joint, label=joint_label(joint)) for joint in joints),
    )


def joint_label(joint: str) -> str:
    """Return the label of a joint that has none of its own."""
    return joint.replace("_", " ").capitalize()


def proposed_joints(names: Sequence[str]) -> Mapping[str, str]:
    """Return the joint of each channel by its name, at most MAX_JOINTS: left_elbow for `LeftForeArm Xrotation`.

    A name without a part of the body is taken without its axis and its kind of sensor. Where no two channels have such
    a name in common, all are of one joint.
    """
    known = {name: _joint_of(name) for name in names}
    others = {name: _name_of(name) for name in names if known[name] is None}
    count = Counter(others.values())
    if max(count.values(), default=0) < 2 or len({*count, *filter(None, known.values())}) > MAX_JOINTS:
        others = dict.fromkeys(others, WHOLE_BODY)
    joints = {name: others[name] if joint is None else joint for name, joint in known.items()}
    return joints if len({*joints.values()}) <= MAX_JOINTS else dict.fromkeys(names, WHOLE_BODY)


def channel_names(joints: Sequence[str]) -> list[str]:
    """Return the names JOINT_NUMBER of channels, of which each has a joint."""
    count: Counter[str] = Counter()
    names = []
    for joint in joints:
        count[joint] += 1
        names.append(f"{joint}_{count[joint]}")
    return names


def _joint_of(name: str) -> str | None:
    """Return the joint that a name says; None where it names no part of the body."""
    bare, _ = bare_name(name)
    match = CHANNEL_OF_JOINT.fullmatch(bare)
    words = _words_of(bare)
    below = next((part for pair, part in BELOW.items() if {*pair} <= {*words}), None)
    part = below or next((PART_OF[word] for word in words if word in PART_OF), None)
    if part is None:
        return None
    if match is not None and re.fullmatch(r"[a-z_]+", match["joint"]) and len(match["joint"]) <= LONGEST:
        return match["joint"]  # as this program names channels
    side = _side_of(words)
    return part if part in IN_THE_MIDDLE or side is None else f"{side}_{part}"


def _side_of(words: Sequence[str]) -> str | None:
    """Return the side that the words of a name say, None where they say none."""
    for word, behind in zip(words, [*words[1:], ""], strict=True):
        if word in SIDES and (word != ARTICLE or not behind or behind in OF_NO_PART):
            return SIDES[word]
    return None


def _name_of(name: str) -> str:
    """Return the words of a name that say neither an axis nor a kind of sensor, as the name of a joint."""
    words = [word for word in _words_of(bare_name(name)[0]) if len(word) >= SHORTEST and word not in OF_NO_PART]
    return "_".join(words)[:LONGEST] or WHOLE_BODY


def _words_of(name: str) -> list[str]:
    """Return the words of a name in lower case and in ASCII; the side is one of its own, also in LSHO of a marker."""
    plain = unicodedata.normalize("NFKD", name.replace("ß", "ss")).encode("ascii", "ignore").decode()
    words = [word.lower() for word in WORD.findall(plain)]
    return [part for word in words for part in ((word[0], word[1:]) if _has_side(word) else (word,))]


def _has_side(word: str) -> bool:
    return word not in PART_OF and word[0] in {"l", "r"} and word[1:] in PART_OF
