"""The steps of the calibration, with their order, instructions and durations."""

from dataclasses import dataclass
from typing import Literal

from app.calibration.vocabulary import UPRIGHT_VOCABULARY
from app.cues import Cue
from app.layout import Joint, ShirtLayout, joint_title
from app.texts import Text

READY = 2.0  # s of countdown before each step
REST = 3.0  # s
FREE = 10.0  # s, as in the paper
REPETITIONS = 3  # of each prompted movement
SHORT_REPETITIONS = 2  # of each in the short calibration: too few for a guided map
MOVE = 1.0  # s
RETURN = 1.5  # s: slower than the movement, so that the fit can tell the two apart
WAY_BACK = RETURN / MOVE  # duration of the way back over that of the movement, also assumed where no cue gives it
PAUSE = 1.0  # s at rest between repetitions

MOVED_PARTS = {"elbow", "shoulder", "wrist"}  # of the body, left or right, that have an instruction of their own
MIDDLE_PARTS = {"head": Text("calibration-move-head"), "trunk": Text("calibration-move-trunk")}  # without a side


@dataclass(frozen=True, slots=True)
class Step:
    """One step of the calibration: one recording, whose cues are in seconds since its start."""

    id: str
    kind: Literal["rest", "free", "prompt"]
    joint: str | None
    title: Text
    instruction: Text
    duration: float  # s
    cues: tuple[Cue, ...]


def calibration_script(layout: ShirtLayout) -> tuple[Step, ...]:
    """Return the steps for a shirt: rest, free movement, then the prompts of each joint."""
    free = _free(Text("calibration-free-instruction"))
    return (_rest(), free, *(_prompt(joint, REPETITIONS) for joint in layout.joints))


def short_script(layout: ShirtLayout) -> tuple[Step, ...]:
    """Return the steps of the short calibration, which prompts only the joints of the four controls.

    Each is the step of `calibration_script` with the same id, without its last repetitions. The free movement is one of
    the prompted joints: the main directions of their maps come from it.
    """
    free = _free(Text("calibration-free-short-instruction"))
    prompted = (joint for joint in layout.joints if joint.name in UPRIGHT_VOCABULARY)
    return (_rest(), free, *(_prompt(joint, SHORT_REPETITIONS) for joint in prompted))


def has_short_script(layout: ShirtLayout) -> bool:
    """Return whether a layout has all joints of the short calibration."""
    return UPRIGHT_VOCABULARY.keys() <= set(layout.joint_names)


def movement_instruction(joint: Joint) -> Text:
    """Return the instruction to the patient to move this joint."""
    side, _, part = joint.name.partition("_")
    if side in {"left", "right"} and part in MOVED_PARTS:
        return Text(f"calibration-move-{part}", side=side)
    if joint.name in MIDDLE_PARTS:
        return MIDDLE_PARTS[joint.name]
    return Text("calibration-move", joint=joint_title(joint))


def _rest() -> Step:
    cues = (
        Cue(start=0.0, end=READY, kind="ready"),
        Cue(start=READY, end=READY + REST, kind="rest"),
    )
    return Step(
        id="rest",
        kind="rest",
        joint=None,
        title=Text("calibration-rest"),
        instruction=Text("calibration-rest-instruction"),
        duration=READY + REST,
        cues=cues,
    )


def _free(instruction: Text) -> Step:
    cues = (
        Cue(start=0.0, end=READY, kind="ready"),
        Cue(start=READY, end=READY + FREE, kind="free"),
    )
    return Step(
        id="free",
        kind="free",
        joint=None,
        title=Text("calibration-free"),
        instruction=instruction,
        duration=READY + FREE,
        cues=cues,
    )


def _prompt(joint: Joint, repetitions: int) -> Step:
    cues = [Cue(start=0.0, end=READY, kind="ready", joint=joint.name)]
    for repetition in range(1, repetitions + 1):
        start = cues[-1].end
        cues += [
            Cue(start=start, end=start + MOVE, kind="move", joint=joint.name, repetition=repetition),
            Cue(
                start=start + MOVE,
                end=start + MOVE + RETURN,
                kind="return",
                joint=joint.name,
                repetition=repetition,
            ),
            Cue(
                start=start + MOVE + RETURN,
                end=start + MOVE + RETURN + PAUSE,
                kind="rest",
                joint=joint.name,
                repetition=repetition,
            ),
        ]
    return Step(
        id=f"prompt-{joint.name}",
        kind="prompt",
        joint=joint.name,
        title=movement_instruction(joint),
        instruction=Text("calibration-prompt-instruction", count=repetitions),
        duration=cues[-1].end,
        cues=tuple(cues),
    )
