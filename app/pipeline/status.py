"""The status report of the control process (docs/protocols.md, section 1, `status`)."""

from typing import Any

from app.hardware.base import NetworkShirt
from app.pipeline.loop import ControlLoop


def status(loop: ControlLoop) -> dict[str, Any]:
    """Return the state of shirt, chair and head tracker, in words and numbers."""
    setup = loop.setup
    return {
        "shirt": {
            "kind": setup.shirt_kind,
            "words": setup.shirt_words,
            "alive": loop.shirt_alive,
            "silent": loop.shirt_silent,
            "sample_rate": setup.sample_rate if setup.shirt else 0.0,
            "lost": setup.shirt.lost if setup.shirt else 0,
            "senders": _senders(setup.network_shirt),
        },
        "chair": {
            "kind": setup.chair.kind,
            "words": setup.chair.words(),
            "switch_seen": setup.chair.switch_reported,
        },
        "head": {"kind": setup.head.kind, "words": setup.head.words},
        "dial": setup.chain.dial,
        "late": loop.late,
        "hash": setup.hash,
    }


def _senders(shirt: NetworkShirt | None) -> dict[str, Any] | None:
    if shirt is None:
        return None
    choice = shirt.sender_choice
    return {"shirt": choice.name, "other": choice.other, "others": choice.other_frames}
