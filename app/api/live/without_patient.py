"""The live picture for those who may not see the patient: on a locked page, or a reviewer of other patients."""

from typing import Any

KEPT = ("tick", "t", "state", "fault", "control", "stops", "practice")  # of the chair and the program; Stop needs them


def without_patient(picture: dict[str, Any]) -> dict[str, Any]:
    """Return a live picture without anything of the patient; `hidden` says that something is left out."""
    return {
        **{name: picture[name] for name in KEPT},
        "hidden": True,
        "session": None,
        **dict.fromkeys(("u1", "u2", "v", "omega", "scene_t"), 0.0),
        "pose": [0.0, 0.0, 0.0],
        "contacts": 0,
        "in_contact": False,
        "dial": 1.0,
        "shirt": {"chosen": False, "alive": False, "sample_rate": 0.0, "lost": 0, "age": None},
        **{name: [] for name in ("gestures", "score", "rate", "activation")},
        **dict.fromkeys(("head", "values", "chair", "run", "trial", "drive", "test")),
    }
