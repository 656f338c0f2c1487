"""`bodydrive calibrate`: the calibration on a file."""

import json
import math
from pathlib import Path
from typing import Annotated

import typer

from app.calibration.cued_runs import run_of_prompts
from app.calibration.fit.profile_fit import fit_profile, joints_without_map
from app.calibration.fit.repetitions import repetitions_of_prompts, stretches_of_prompts
from app.calibration.gestures.discovery import discover
from app.calibration.guided.guided_map import with_guided_maps
from app.calibration.prior.map_prior import MapPrior, PriorError
from app.calibration.prior.prior_file import read_prior
from app.calibration.prior.prior_map import with_prior_maps
from app.calibration.profile import CalibrationProfile
from app.calibration.prompts_file import read_prompts
from app.cli.calibration.gesture_table import gesture_table
from app.cli.calibration.map_choice import MapChoice, checks, choose, comparison
from app.cli.calibration.prior_summary import arrangement_words, prior_facts, prior_words, prompted_stretches
from app.cli.errors import InputError
from app.cli.output import dialect_summary, print_dialect, warn, write_output
from app.signals.signals import Signals, read_layout, read_signals

KINDS = {"pca": "standard", "guided": "cues", "prior": "people"}
PRINTED = ("evr", "span", "sign", "grade", "reason", "dead_zone", "full")


def calibrate(
    signals: Annotated[Path, typer.Argument(metavar="SIGNALS", help="CSV or Parquet, or the folder of a recording.")],
    *,
    layout: Annotated[Path, typer.Option(help="The shirt's layout, JSON.")],
    out: Annotated[Path, typer.Option(help="Where the calibration profile goes, JSON.")],
    prompts: Annotated[
        Path | None,
        typer.Option(help="CSV start,end,joint: when which joint moved towards its gesture. Fixes the sign."),
    ] = None,
    start: Annotated[float | None, typer.Option("--from", help="Where the free movement begins, s.")] = None,
    end: Annotated[float | None, typer.Option("--to", help="Where the free movement ends, s.")] = None,
    rest_start: Annotated[float | None, typer.Option("--rest-from", help="Where the rest begins, s.")] = None,
    rest_end: Annotated[float | None, typer.Option("--rest-to", help="Where the rest ends, s.")] = None,
    unused: Annotated[list[str] | None, typer.Option(help="A channel not to be used; may be given again.")] = None,
    prior: Annotated[
        Path | None, typer.Option(help="What `bodydrive prior` wrote of other people in the same shirt.")
    ] = None,
    chosen: Annotated[
        MapChoice,
        typer.Option(
            "--map",
            help="Which calibration drives: standard, learnt from the cues, from other people, or the best.",
        ),
    ] = "pca",
    gestures: Annotated[
        bool, typer.Option("--gestures", help="Rank every gesture that was found, there and back, and suggest four.")
    ] = False,
    as_json: Annotated[bool, typer.Option("--json", help="Print one JSON object and nothing else.")] = False,
) -> None:
    """Fit a calibration profile to a file of signals: per joint its main movement, span, sign, grade and thresholds."""
    try:
        shirt = read_layout(layout)
        recorded = read_signals(signals, shirt)
        rows = [] if prompts is None else read_prompts(prompts, shirt, float(recorded.t[0]), float(recorded.t[-1]))
        pool = None if prior is None else MapPrior.of(read_prior(prior))
    except ValueError as error:
        raise InputError(str(error)) from error
    free = window(signals, recorded, "from", start, "to", end)
    has_rest = rest_start is not None or rest_end is not None
    rest = window(signals, recorded, "rest-from", rest_start, "rest-to", rest_end) if has_rest else None
    try:
        profile = fit_profile(
            shirt,
            recorded.sample_rate,
            free=recorded.values[free],
            rest=None if rest is None else recorded.values[rest],
            repetitions=repetitions_of_prompts(recorded.t, recorded.values, rows, recorded.sample_rate),
            unused=unused or (),
        )
        fitted = with_guided_maps(
            profile,
            stretches_of_prompts(recorded.t, recorded.values, rows, recorded.sample_rate, until=end),
            None if rest is None else recorded.values[rest],
        )
        own = [] if prompts is None else prompted_stretches(recorded, prompts, shirt, end)
        known = None if pool is None else with_prior_maps(fitted.profile, pool, recorded.values[free], own)
    except PriorError as error:
        raise InputError(f"--prior {prior}: {error}") from error
    except ValueError as error:
        raise InputError(f"{signals}: {error}") from error
    before = fitted.profile if known is None else known.profile
    profile, words = choose(before, chosen, fitted.reasons, None if known is None else known.reasons)
    sources = [file for file in (signals, layout, prompts, prior) if file is not None]
    warn(recorded.damage)
    for sentence in words:
        warn(sentence)
    write_output(out, (profile.model_dump_json(indent=1) + "\n").encode(), *sources)
    found = discover(profile, [run_of_prompts(recorded.t, recorded.values, rows, free, rest)]) if gestures else None
    if as_json:
        more: dict[str, object] = {} if found is None else {"gestures": found.model_dump(mode="json")}
        if known is not None:
            more |= {
                "prior": {joint.name: prior_facts(joint, known.reasons) for joint in profile.joints},
                "arrangement": {ring: found.model_dump(mode="json") for ring, found in known.arrangement.items()},
            }
        typer.echo(
            json.dumps(summary(profile, fitted.reasons, out) | dialect_summary(recorded) | more, allow_nan=False)
        )
    else:
        typer.echo(report(profile, fitted.reasons, out))
        if known is not None:
            typer.echo()
            for line in [prior_words(joint, known.reasons) for joint in profile.joints]:
                typer.echo(line)
            for ring, found_there in known.arrangement.items():
                typer.echo(arrangement_words(ring, found_there))
        print_dialect(recorded, signals)
        if found is not None:
            typer.echo(f"\n{gesture_table(found)}")


def _rate(share: float) -> str:
    """Return a threshold as a share of the full movement per second."""
    return f"{100 * share:.0f} % / s"


def window(
    signals: Path, recorded: Signals, start_word: str, start: float | None, end_word: str, end: float | None
) -> slice:
    """Return the rows between two options (s, each may be missing); InputError for an empty range."""
    for word, given in ((start_word, start), (end_word, end)):
        if given is not None and not math.isfinite(given):
            raise InputError(f"--{word} {given}: give a number of seconds")
    rows = recorded.between(start, end)
    if rows.stop <= rows.start:
        first = recorded.t[0] if start is None else start
        last = recorded.t[-1] if end is None else end
        raise InputError(
            f"--{start_word} {first:g} --{end_word} {last:g}: nothing of {signals} lies there, "
            f"it goes from {recorded.t[0]:g} to {recorded.t[-1]:g} s"
        )
    return rows


def summary(profile: CalibrationProfile, reasons: dict[str, str], out: Path) -> dict[str, object]:
    """Return the object of `--json`; a joint without a map has a grade and a reason, but no numbers."""
    without = {
        name: {**dict.fromkeys(PRINTED), "grade": "repeat", "reason": reason}
        for name, reason in joints_without_map(profile).items()
    }
    mapped = {
        joint.name: {word: getattr(joint, word) for word in PRINTED}
        | dict(zip(("dead_zone", "full"), joint.thresholds, strict=True))
        for joint in profile.joints
    }
    maps = {joint.name: checks(joint, reasons) for joint in profile.joints}
    return {"joints": mapped | without, "maps": maps, "profile": str(out)}


def report(profile: CalibrationProfile, reasons: dict[str, str], out: Path) -> str:
    """Return a table for people: one line per joint, then the reasons, then the file of the profile."""
    without = joints_without_map(profile)
    width = max(len(name) for name in ("joint", *profile.layout.joint_names))
    head = f"{'clear':>6}  {'span':>10}  sign  {'grade':6}  {'counts from':>11}  {'full at':>9}  calibration"
    lines = [f"{'joint':{width}}  {head}"]
    lines += [
        f"{joint.name:{width}}  {joint.evr:6.1%}  {joint.span:10.4g}  {'+' if joint.sign > 0 else '-':>4}  "
        f"{joint.grade:6}  {_rate(joint.thresholds[0]):>11}  {_rate(joint.thresholds[1]):>9}  {KINDS[joint.map]}"
        for joint in profile.joints
    ]
    nothing = f"{'-':>6}  {'-':>10}  {'-':>4}  {'repeat':6}  {'-':>11}  {'-':>9}  -"
    lines += [f"{name:{width}}  {nothing}" for name in without]
    lines += [
        "",
        "Clear: share of the main movement. Span: of the full movement, in the signals' own unit.",
        "",
    ]
    lines += [f"{joint.name}: {joint.reason}" for joint in profile.joints]
    lines += [f"{name}: {reason}" for name, reason in without.items()]
    lines += [f"Channel {name} is left out: {why}." for name, why in profile.left_out.items()]
    lines += ["", *comparison(profile, reasons, width), "", f"The profile is in {out}"]
    return "\n".join(lines)
