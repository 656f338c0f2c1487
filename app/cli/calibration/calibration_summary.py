"""What `bodydrive calibrate` prints of a calibration, for people and as JSON."""

from collections.abc import Mapping
from pathlib import Path

from app.calibration.fit.profile_fit import joints_without_map
from app.calibration.profile import CalibrationProfile
from app.cli.calibration.map_choice import checks, comparison

KINDS = {"pca": "standard", "guided": "cues", "prior": "people"}
HANDLES = ("dead_zone", "full")
PRINTED = ("evr", "span", "has_to_be_repeated", "reason", *HANDLES)


def _rate(share: float) -> str:
    """Return a threshold as a share of the full movement per second."""
    return f"{100 * share:.0f} % / s"


def summary(profile: CalibrationProfile, reasons: dict[str, str], out: Path) -> dict[str, object]:
    """Return the object of `--json`; a joint without a map has a reason, but no numbers."""
    without = {
        name: {**dict.fromkeys(PRINTED), "has_to_be_repeated": True, "reason": reason}
        for name, reason in joints_without_map(profile).items()
    }
    mapped = {
        joint.name: {word: getattr(joint, word) for word in PRINTED[: -len(HANDLES)]}
        | dict(zip(HANDLES, joint.thresholds, strict=True))
        for joint in profile.joints
    }
    maps = {joint.name: checks(joint, reasons) for joint in profile.joints}
    return {"joints": mapped | without, "maps": maps, "profile": str(out)}


def report(
    profile: CalibrationProfile, reasons: dict[str, str], out: Path, expected: Mapping[str, tuple[str, str]]
) -> str:
    """Return a table for people: one line per joint, then the reasons, then the file of the profile.

    `expected` are the figures per joint, as of `expected_figures`.
    """
    without = joints_without_map(profile)
    width = max(len(name) for name in ("joint", *profile.layout.joint_names))
    titles = ("hits of 100", "at rest a minute")
    head = [f"{'clear':>6}  {'span':>10}", *(f"{title:>18}" for title in titles)]
    lines = ["  ".join([f"{'joint':{width}}", *head, f"{'counts from':>11}  {'full at':>9}  calibration"])]
    for joint in profile.joints:
        cells = [
            f"{joint.name:{width}}",
            f"{joint.evr:6.1%}  {joint.span:10.4g}",
            *(f"{figure:>18}" for figure in expected[joint.name]),
            f"{_rate(joint.thresholds[0]):>11}  {_rate(joint.thresholds[1]):>9}  {KINDS[joint.map]}",
        ]
        lines.append("  ".join(cells))
    nothing = "  ".join(f"{'-':>{size}}" for size in (6, 10, 18, 18, 11, 9))
    lines += [f"{name:{width}}  {nothing}  -" for name in without]
    lines += [
        "",
        "Clear: share of the main movement. Span: of the full movement, in the signals' own unit.",
        "Expected: how many of 100 movements reach half of full, and how often it acts at rest, a minute.",
        "",
    ]
    lines += [f"{joint.name}: {joint.reason}" for joint in profile.joints]
    lines += [f"{name}: {reason}" for name, reason in without.items()]
    lines += [f"Channel {name} is left out: {why}." for name, why in profile.left_out.items()]
    lines += ["", *comparison(profile, reasons, width), "", f"The profile is in {out}"]
    return "\n".join(lines)
