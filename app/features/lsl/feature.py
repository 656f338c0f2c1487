"""Ticks, gestures and markers over the Lab Streaming Layer: what the feature gives to the rest of the program.

It sends when the program was started with `--lsl` (`Settings.lsl`).
"""

from typing import TYPE_CHECKING, Final

from app.features.registration import Feature

if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from app.api.parts import Parts
    from app.cues import Cue
    from app.features.registration import Background
    from app.news import Notify
    from app.session.run_flow import RunFlow


class SessionNames:
    """What the parts of the web process know of runs and gestures."""

    def __init__(self, parts: "Parts") -> None:
        self._parts = parts

    def name_of(self, run: int) -> str | None:
        """Return the name of a run: trial or drive with its id, else the kind of the recording; None: not known yet."""
        from app.session.real_drive import RealDriveFlow
        from app.session.runs import SessionRuns
        from app.session.trial import TrialFlow

        recorded = self._parts[SessionRuns].open
        if recorded is None or recorded.number != run:
            return None
        flows: dict[str, RunFlow[Any]] = {"trial": self._parts[TrialFlow], "drive": self._parts[RealDriveFlow]}
        for word, flow in flows.items():
            current = flow.current
            if current is not None and current.run.number == run:
                return f"{word} {current.id}"
        return None if recorded.kind == "drive" else f"recording {recorded.kind}"

    def cue_of(self, run: int, index: int) -> "Cue | None":
        """Return the cue of a run that is being recorded; None: not known yet."""
        from app.session.runs import SessionRuns

        recorded = self._parts[SessionRuns].open
        if recorded is None or recorded.number != run or not index < len(recorded.cues):
            return None
        return recorded.cues[index]

    def gestures(self) -> "Sequence[str]":
        """Return the names of the gestures that the control process decodes."""
        from app.session.open_session import SessionFlow

        loaded = self._parts[SessionFlow].loaded
        return [] if loaded is None else [gesture.name for gesture in loaded.gestures]


def outlets(parts: "Parts", _notify: "Notify") -> "Background":
    """Return what sends the streams."""
    from app.features.lsl.service import LslOutlets
    from app.session.control_link import ControlLink
    from app.settings import Settings

    return LslOutlets(parts[ControlLink], SessionNames(parts), is_chosen=parts[Settings].lsl)


FEATURE: Final = Feature(background=outlets)
