"""Finds all gestures of a body: every joint in both directions, ranked by measures from the recordings."""

from collections.abc import Mapping, Sequence
from typing import Literal

from app.calibration.cued_runs import CuedRun
from app.calibration.fit.joint_evidence import repeatability, signal_to_noise
from app.calibration.fit.profile_fit import joints_without_map
from app.calibration.gestures.ability import abilities
from app.calibration.gestures.cross_check import predict
from app.calibration.gestures.evidence import gather_evidence
from app.calibration.gestures.numbers import Companion, FoundGesture, ratios, score_of, weakest_of
from app.calibration.gestures.suggestion import Shares, SuggestedVocabulary, suggest_vocabulary
from app.calibration.profile import CalibrationProfile
from app.quantities import Document
from app.texts import Text


class Discovery(Document):
    """All gestures, the best first, and the vocabulary suggested from them."""

    source: Literal["recordings", "profile"]
    message: Text | None  # one sentence on missing data; None when nothing is missing
    gestures: tuple[FoundGesture, ...]
    not_found: dict[str, Text]  # joints without a map, with the reason and what to do
    suggestion: SuggestedVocabulary


def discover(profile: CalibrationProfile, runs: Sequence[CuedRun]) -> Discovery:
    """Rank the gestures of every joint that has a map, by the recordings of a calibration.

    The direction -1 is the way back used as a gesture; it is measured on the ways back from the prompts and on the free
    movement. Each gesture has four numbers and a score made of them (`app.calibration.gestures.numbers`):

    - signal to noise: the measured full over the noise of the rate at rest, as in the profile;
    - repeatability: spread of the repetitions' peak rates over their mean;
    - cross-talk: activation time during whole repetitions (there and back) of another joint, as a share of that during
      its own; the larger of this gesture's answer to another joint's prompts, and another's answer to its prompts;
    - effort: distance (FS) to move for a full activation, in the person's usual duration of the movement, which hardly
      depends on its size (Viviani and Terzuolo, in: Tutorials in Motor Behavior, 1980).
    """
    evidence = gather_evidence(profile, runs)
    able = abilities(profile, evidence)
    shares = {ability.name: ability.shares for ability in able}
    gestures = []
    for ability in able:
        appears, brings = _companions(ability.name, ability.joint.name, shares)
        gestures.append(
            _with_score(
                FoundGesture(
                    name=ability.name,
                    joint=ability.joint.name,
                    direction=ability.direction,
                    dead_zone=ability.dead_zone,
                    full=ability.full,
                    signal_to_noise=signal_to_noise(ability.reached, evidence.noise_of(ability.joint, ability.column)),
                    repeatability=repeatability(ability.rates, evidence.sample_rate),
                    cross_talk=_larger(appears, brings),
                    effort=ability.effort,
                    appears_with=appears,
                    brings=brings,
                    prediction=predict(ability, able, evidence),
                )
            )
        )
    return _discovery(profile, gestures, shares, "recordings", None)


def discovery_from_profile(profile: CalibrationProfile, sentence: Text) -> Discovery:
    """Rank the gestures by the numbers in the profile where there are no recordings; `sentence` say why there are none.

    The profile knows the prompted direction only: its cross-talk is that of the prompted movements without the ways
    back, effort and prediction are unknown.
    """
    shares: dict[str, dict[str, float]] = {joint.name: {} for joint in profile.joints}
    if profile.cross_talk is not None:
        prompted = [(index, joint.name) for index, joint in enumerate(profile.joints) if joint.prompted]
        for row, cued in prompted:
            for column, answering in prompted:
                if row != column:
                    shares[answering][cued] = profile.cross_talk[row][column]
    gestures = []
    for joint in profile.joints:
        appears, brings = _companions(joint.name, joint.name, shares)
        gestures.append(
            _with_score(
                FoundGesture(
                    name=joint.name,
                    joint=joint.name,
                    direction=1,
                    dead_zone=joint.thresholds[0],
                    full=joint.thresholds[1],
                    signal_to_noise=joint.signal_to_noise or 0.0,
                    repeatability=joint.repeatability,
                    cross_talk=_larger(appears, brings),
                    appears_with=appears,
                    brings=brings,
                )
            )
        )
    return _discovery(profile, gestures, shares, "profile", sentence)


def _with_score(gesture: FoundGesture) -> FoundGesture:
    of_limits = ratios(gesture)
    return gesture.model_copy(update={"score": score_of(of_limits), "weakest": weakest_of(of_limits)})


def _discovery(
    profile: CalibrationProfile,
    gestures: Sequence[FoundGesture],
    shares: Mapping[str, Shares],
    source: Literal["recordings", "profile"],
    sentence: Text | None,
) -> Discovery:
    return Discovery(
        source=source,
        message=sentence,
        gestures=tuple(sorted(gestures, key=lambda gesture: -gesture.score)),
        not_found=joints_without_map(profile),
        suggestion=suggest_vocabulary(profile, gestures, shares),
    )


def _companions(name: str, joint: str, shares: Mapping[str, Shares]) -> tuple[Companion | None, Companion | None]:
    """Return the joint whose prompts activate a gesture most, and the joint that its own prompts activate most."""
    brought = {other: share[joint] for other, share in shares.items() if joint in share and other in shares[name]}
    return _largest(shares[name]), _largest(brought)


def _largest(shares: Shares) -> Companion | None:
    if not shares:
        return None
    joint = max(shares, key=lambda name: shares[name])
    return Companion(joint=joint, share=shares[joint])


def _larger(first: Companion | None, second: Companion | None) -> float | None:
    shares = [companion.share for companion in (first, second) if companion is not None]
    return max(shares) if shares else None
