"""`bodydrive calibrate`: the calibration on a file, the choice of maps, and what it prints of the result."""

import json
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from app.cli.common_options import AsJson
from app.cli.errors import InputError
from app.cli.output import dialect_summary, print_dialect, warn, write_output
from app.number_format import percent

if TYPE_CHECKING:
    from app.calibration.gestures.discovery import Discovery
    from app.calibration.gestures.numbers import FoundGesture
    from app.calibration.linear_map import Arrangement, Forecast, MapCheck, MapKind
    from app.calibration.prior.prior_map import PriorFit
    from app.calibration.profile import CalibrationProfile, JointMap
    from app.texts import Text

MAP_NAMES = {"pca": "standard", "guided": "cues", "prior": "people"}
THRESHOLDS = ("dead_zone", "full")
PRINTED = ("evr", "span", "has_to_be_repeated", "reason", *THRESHOLDS)
GESTURE_COLUMNS = ("score", "signal", "repeats", "along", "effort", "false/min", "answered")
CONTROLS = {"u1+": "faster", "u1-": "slower", "u2+": "turn left", "u2-": "turn right", "stop": "stop"}
MapChoice = Literal["pca", "guided", "prior", "best"]
FALLBACK = "It keeps the standard calibration."


def calibrate(
    signals: Annotated[Path, typer.Argument(metavar="SIGNALS", help="CSV or Parquet, or the folder of a recording.")],
    *,
    layout: Annotated[Path, typer.Option(help="The shirt's layout, JSON.")],
    out: Annotated[Path, typer.Option(help="Where the calibration profile goes, JSON.")],
    prompts: Annotated[
        Path | None,
        typer.Option(
            help="CSV start,end,joint: when which joint moved towards its gesture; every row counts. Fixes the sign."
        ),
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
    as_json: AsJson = False,
) -> None:
    """Fit a calibration profile to a file of signals: per joint its main movement, span, sign and thresholds."""
    from app.calibration.cued_runs import run_of_prompts
    from app.calibration.gestures.discovery import discover
    from app.calibration.prior.map_prior import MapPrior, PriorError
    from app.calibration.prior.prior_file import read_prior
    from app.calibration.prompts_file import read_prompts
    from app.cli.calibration.expected_figures import expected_figures
    from app.cli.calibration.file_fit import fit_file, window
    from app.signals.signals import read_layout, read_signals

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
        fitted, prior_fit = fit_file(recorded, shirt, rows, free, rest, unused or (), end, pool)
    except PriorError as error:
        raise InputError(f"--prior {prior}: {error}") from error
    except ValueError as error:
        raise InputError(f"{signals}: {error}") from error
    all_maps = fitted.profile if prior_fit is None else prior_fit.profile
    profile, warnings = choose(all_maps, chosen, fitted.reasons, None if prior_fit is None else prior_fit.reasons)
    sources = [file for file in (signals, layout, prompts, prior) if file is not None]
    for sentence in (recorded.damage, *warnings):
        warn(sentence)
    write_output(out, (profile.model_dump_json(indent=1) + "\n").encode(), *sources)
    needs_gestures = gestures or (rows and not as_json)
    discovery = (
        discover(profile, [run_of_prompts(recorded.t, recorded.values, rows, free, rest)]) if needs_gestures else None
    )
    if as_json:
        document = _summary(profile, fitted.reasons, out) | dialect_summary(recorded)
        if discovery is not None:
            document["gestures"] = discovery.model_dump(mode="json")
        if prior_fit is not None:
            document |= _prior_summary(prior_fit)
        typer.echo(json.dumps(document, allow_nan=False))
        return
    typer.echo(_report(profile, fitted.reasons, out, expected_figures(profile, discovery)))
    if prior_fit is not None:
        typer.echo("\n".join(["", *_prior_report(prior_fit)]))
    print_dialect(recorded, signals)
    if discovery is not None and gestures:
        typer.echo(f"\n{_gesture_table(discovery)}")


def _rate(share: float) -> str:
    """Return a threshold as a share of the full movement per second."""
    return f"{100 * share:.0f} % / s"


def _summary(profile: "CalibrationProfile", reasons: "dict[str, Text]", out: Path) -> dict[str, object]:
    """Return the object of `--json`; a joint without a map has a reason, but no numbers."""
    from app.calibration.fit.profile_fit import joints_without_map

    without = {
        name: {**dict.fromkeys(PRINTED), "has_to_be_repeated": True, "reason": str(reason)}
        for name, reason in joints_without_map(profile).items()
    }
    mapped = {
        joint.name: {name: getattr(joint, name) for name in PRINTED[: -len(THRESHOLDS)]}
        | {"reason": str(joint.description)}
        | dict(zip(THRESHOLDS, joint.thresholds, strict=True))
        for joint in profile.joints
    }
    maps = {joint.name: checks(joint, reasons) for joint in profile.joints}
    return {"joints": mapped | without, "maps": maps, "profile": str(out)}


def _report(
    profile: "CalibrationProfile", reasons: "dict[str, Text]", out: Path, expected: Mapping[str, tuple[str, str]]
) -> str:
    """Return a table for people: one line per joint, then the reasons, then the file of the profile.

    `expected` are the figures per joint, as of `expected_figures`.
    """
    from app.calibration.fit.profile_fit import joints_without_map

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
            f"{_rate(joint.thresholds[0]):>11}  {_rate(joint.thresholds[1]):>9}  {MAP_NAMES[joint.map]}",
        ]
        lines.append("  ".join(cells))
    no_figures = "  ".join(f"{'-':>{size}}" for size in (6, 10, 18, 18, 11, 9))
    lines += [f"{name:{width}}  {no_figures}  -" for name in without]
    lines += [
        "",
        "Clear: share of the main movement. Span: of the full movement, in the signals' own unit.",
        "Expected: how many of 100 movements reach half of full, and how often it acts at rest, a minute.",
        "",
    ]
    lines += [f"{joint.name}: {joint.description}" for joint in profile.joints]
    lines += [f"{name}: {reason}" for name, reason in without.items()]
    lines += [f"Channel {name} is left out: {reason}." for name, reason in profile.left_out.items()]
    lines += ["", *comparison(profile, reasons, width), "", f"The profile is in {out}"]
    return "\n".join(lines)


def _gesture_table(discovery: "Discovery") -> str:
    """Return one line per gesture, the best first, then the suggestion; `-` where there is no measurement."""
    width = max(len(gesture.name) for gesture in discovery.gestures)
    lines = [f"{'gesture':{width}}  {'  '.join(f'{title:>9}' for title in GESTURE_COLUMNS)}"]
    lines += [
        f"{gesture.name:{width}}  {'  '.join(f'{cell:>9}' for cell in _cells(gesture))}"
        for gesture in discovery.gestures
    ]
    suggestion = discovery.suggestion
    bound = [f"{CONTROLS[binding.control]}: {' + '.join(binding.gestures)}" for binding in suggestion.bindings]
    return "\n".join([*lines, "", str(suggestion.reason), ", ".join(bound)])


def _cells(gesture: "FoundGesture") -> list[str]:
    from app.calibration.grades import repeats_word, signal_word

    forecast = gesture.prediction
    return [
        f"{gesture.score:.2f}",
        str(signal_word(gesture.signal_to_noise)),
        "-" if gesture.repeatability is None else str(repeats_word(gesture.repeatability)),
        _share(gesture.cross_talk),
        _share(gesture.effort),
        "-" if forecast is None or forecast.false_per_minute is None else f"{forecast.false_per_minute:.1f}",
        _share(None if forecast is None else forecast.hit_rate),
    ]


def _share(value: float | None) -> str:
    return "-" if value is None else percent(value)


def _prior_summary(prior_fit: "PriorFit") -> dict[str, object]:
    """Return the part of `--json` on the maps from other people and on the arrangement of the rings."""
    return {
        "prior": {joint.name: _prior_facts(joint, prior_fit.reasons) for joint in prior_fit.profile.joints},
        "arrangement": {
            ring: arrangement.model_dump(mode="json") for ring, arrangement in prior_fit.arrangement.items()
        },
    }


def _prior_report(prior_fit: "PriorFit") -> list[str]:
    """Return the lines on maps from other people, one per joint, and on the arrangement of the rings, one per ring."""
    joints = [_joint_sentence(joint, prior_fit.reasons) for joint in prior_fit.profile.joints]
    return joints + [_ring_sentence(ring, arrangement) for ring, arrangement in prior_fit.arrangement.items()]


def _prior_facts(joint: "JointMap", reasons: "dict[str, Text]") -> dict[str, object]:
    prior = joint.prior
    if prior is None:
        return {"offered": False, "reason": str(reasons[joint.name])}
    return {
        "offered": prior.is_better,
        "source": str(prior.source),
        "people": prior.people,
        "repetitions": prior.repetitions,
        "dropped": list(prior.dropped),
        "dead_zone": prior.dead_zone,
        "full": prior.full,
        "hits_of_100": _forecast(prior.hits),
        "false_per_minute": _forecast(prior.false_per_minute),
        "prior_check": _check_facts(prior.check),
        "pca_check": _check_facts(prior.pca_check),
    }


def _forecast(forecast: "Forecast | None") -> object:
    return "not known" if forecast is None else forecast.model_dump(mode="json")


def _joint_sentence(joint: "JointMap", reasons: "dict[str, Text]") -> str:
    prior = joint.prior
    if prior is None:
        return f"{joint.name}: {reasons[joint.name]}"
    hits, false = (
        "not known" if forecast is None else f"{forecast.value:g} ± {forecast.uncertainty:g}"
        for forecast in (prior.hits, prior.false_per_minute)
    )
    dropped = f"; channels that hardly move: {', '.join(prior.dropped)}" if prior.dropped else ""
    return (
        f"{joint.name}: {prior.source} ({prior.people} people, {prior.repetitions} own repetitions); expected hits of "
        f"100 movements: {hits}; expected false activations a minute: {false}{dropped}"
    )


def _ring_sentence(ring: str, arrangement: "Arrangement") -> str:
    from app.calibration.linear_map import Arrangement

    if arrangement == Arrangement():
        return f"Ring {ring}: it sits as on other people."
    places = f"turned by {arrangement.shift} {'place' if arrangement.shift == 1 else 'places'}"
    mirrored = "mirrored and " if arrangement.mirrored else ""
    return f"Ring {ring}: it is {mirrored}{places} against other people; the calibration allows for that."


def choose(
    profile: "CalibrationProfile",
    chosen: MapChoice,
    reasons: "dict[str, Text]",
    prior_reasons: "dict[str, Text] | None" = None,
) -> "tuple[CalibrationProfile, list[str]]":
    """Return the profile with the chosen map of each joint, and a sentence for each joint without it.

    `reasons` say why a joint has no guided map, `prior_reasons` why none from other people (None without a prior).
    """
    if chosen == "guided" and not any(joint.guided for joint in profile.joints):
        name, reason = next(iter(reasons.items()))
        raise InputError(f"--map guided, {name}: {reason}")
    if chosen == "prior" and prior_reasons is None:
        raise InputError("--map prior: other people's movements are in a prior, give it with --prior")
    if chosen == "prior" and prior_reasons and not any(joint.prior for joint in profile.joints):
        name, reason = next(iter(prior_reasons.items()))
        raise InputError(f"--map prior, {name}: {reason}")
    sentences = []
    for joint in profile.joints:
        if chosen == "guided" and joint.guided is None:
            sentences.append(f"{joint.name}: {reasons[joint.name]} {FALLBACK}")
        elif chosen == "guided" and joint.guided is not None and not joint.guided.is_better:
            sentences.append(
                f"{joint.name}: what was learnt from the cues is not better on the held-out repetitions. Use --map "
                f"best to keep the standard calibration there."
            )
        elif chosen == "prior" and joint.prior is None and prior_reasons is not None:
            sentences.append(f"{joint.name}: {prior_reasons[joint.name]} {FALLBACK}")
        elif chosen == "prior" and joint.prior is not None and not joint.prior.is_better:
            sentences.append(
                f"{joint.name}: what was learnt from other people is worse on the held-out repetitions. Use --map "
                f"best to leave it out there."
            )
    joints = tuple(joint.model_copy(update={"map": _map_of(joint, chosen)}) for joint in profile.joints)
    return profile.model_copy(update={"joints": joints}), sentences


def _map_of(joint: "JointMap", chosen: MapChoice) -> "MapKind":
    """Return the map that decodes a joint: the chosen one where there is one, the best one that is offered, or PCA."""
    if chosen == "prior":
        return "pca" if joint.prior is None else "prior"
    if chosen == "guided":
        return "pca" if joint.guided is None else "guided"
    return joint.best_map if chosen == "best" else "pca"


def checks(joint: "JointMap", reasons: "dict[str, Text]") -> dict[str, object]:
    """Return the map in use and the checks of both maps, or the reason why there is no guided map."""
    if joint.guided is None:
        return {"map": joint.map, "offered": False, "reason": str(reasons[joint.name])}
    guided = joint.guided
    return {
        "map": joint.map,
        "offered": guided.is_better,
        "lag": guided.lag,
        "repetitions": guided.repetitions,
        "dead_zone": guided.dead_zone,
        "full": guided.full,
        "pca_check": _check_facts(guided.pca_check),
        "guided_check": _check_facts(guided.check),
    }


def _check_facts(check: "MapCheck | None") -> object:
    """Return a check as `--json` has it."""
    return None if check is None else check.model_dump(mode="json")


def comparison(profile: "CalibrationProfile", reasons: "dict[str, Text]", width: int) -> list[str]:
    """Return the table of both maps on the held-out repetitions, then the reasons for missing guided maps."""
    both = [(joint.name, joint.guided) for joint in profile.joints if joint.guided]
    lines = []
    if both:
        lines += [
            "On prompted repetitions that were kept apart, the standard calibration and the one learnt from the cues:",
            f"{'':{width}}  {'in phase':>16}  {'time driven':>16}  {'false per min':>16}",
            f"{'joint':{width}}" + f"  {'standard':>8}  {'cues':>6}" * 3 + "  offered",
        ]
        lines += [
            f"{name:{width}}  "
            + "  ".join(
                f"{standard:>8}  {cues:>6}"
                for standard, cues in zip(_figures(guided.pca_check), _figures(guided.check), strict=True)
            )
            + f"  {'yes' if guided.is_better else 'no'}"
            for name, guided in both
        ]
    return lines + [f"{name}: {reason}" for name, reason in reasons.items()]


def _figures(check: "MapCheck | None") -> tuple[str, ...]:
    if check is None:
        return "-", "-", "-"
    return percent(check.in_phase, 1), percent(check.hit_rate, 1), f"{check.false_per_minute:.1f}"
