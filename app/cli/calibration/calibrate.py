"""`bodydrive calibrate`: the calibration on a file, the choice of maps, and what it prints of the result."""

import json
from collections.abc import Mapping
from itertools import chain
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from app.cli.common_options import AsJson
from app.cli.errors import InputError
from app.cli.help_text import help_text
from app.cli.output import dialect_summary, print_dialect, warn, write_output
from app.cli.signal_options import (
    ChannelNames,
    SampleRate,
    TimeName,
    TimeUnit,
    reading_options,
    signals_refused,
)
from app.number_format import percent
from app.plain_table import BETWEEN, column_widths, table_lines
from app.texts import Figure, Text, value_text

if TYPE_CHECKING:
    from app.calibration.gestures.discovery import Discovery
    from app.calibration.gestures.numbers import FoundGesture
    from app.calibration.linear_map import Arrangement, Forecast, MapCheck, MapKind
    from app.calibration.prior.prior_map import PriorFit
    from app.calibration.profile import CalibrationProfile, JointMap

MAP_NAMES = {"pca": Text("cli-map-standard"), "guided": Text("cli-map-cues"), "prior": Text("cli-map-people")}
THRESHOLDS = ("dead_zone", "full")
PRINTED = ("evr", "span", "has_to_be_repeated", "reason", *THRESHOLDS)
JOINT_COLUMNS = ("joint", "clear", "span", "hits", "at-rest", "counts-from", "full-at", "calibration")
GESTURE_COLUMNS = ("score", "signal", "repeats", "along", "effort", "false", "answered")
CONTROLS = {
    "u1+": Text("cli-control-faster"),
    "u1-": Text("cli-control-slower"),
    "u2+": Text("cli-control-left"),
    "u2-": Text("cli-control-right"),
    "stop": Text("cli-control-stop"),
}
MapChoice = Literal["pca", "guided", "prior", "best"]


def calibrate(
    signals: Annotated[Path, typer.Argument(metavar="SIGNALS", help=help_text("cli-help-signals"))],
    *,
    layout: Annotated[Path, typer.Option(help=help_text("cli-help-layout"))],
    out: Annotated[Path, typer.Option(help=help_text("cli-help-calibrate-out"))],
    prompts: Annotated[Path | None, typer.Option(help=help_text("cli-help-calibrate-prompts"))] = None,
    start: Annotated[float | None, typer.Option("--from", help=help_text("cli-help-calibrate-from"))] = None,
    end: Annotated[float | None, typer.Option("--to", help=help_text("cli-help-calibrate-to"))] = None,
    rest_start: Annotated[
        float | None, typer.Option("--rest-from", help=help_text("cli-help-calibrate-rest-from"))
    ] = None,
    rest_end: Annotated[float | None, typer.Option("--rest-to", help=help_text("cli-help-calibrate-rest-to"))] = None,
    unused: Annotated[list[str] | None, typer.Option(help=help_text("cli-help-calibrate-unused"))] = None,
    prior: Annotated[Path | None, typer.Option(help=help_text("cli-help-calibrate-prior"))] = None,
    chosen: Annotated[MapChoice, typer.Option("--map", help=help_text("cli-help-calibrate-map"))] = "pca",
    gestures: Annotated[bool, typer.Option("--gestures", help=help_text("cli-help-calibrate-gestures"))] = False,
    time: TimeName = None,
    unit: TimeUnit = None,
    rate: SampleRate = None,
    channels: ChannelNames = None,
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

    options = reading_options(time, unit, rate, channels)
    try:
        shirt = read_layout(layout)
        recorded = read_signals(signals, shirt, options)
        rows = [] if prompts is None else read_prompts(prompts, shirt, float(recorded.t[0]), float(recorded.t[-1]))
        pool = None if prior is None else MapPrior.of(read_prior(prior))
    except ValueError as error:
        raise signals_refused(error) from error
    free = window(signals, recorded, "from", start, "to", end)
    has_rest = rest_start is not None or rest_end is not None
    rest = window(signals, recorded, "rest-from", rest_start, "rest-to", rest_end) if has_rest else None
    try:
        fitted, prior_fit = fit_file(recorded, shirt, rows, free, rest, unused or (), end, pool)
    except PriorError as error:
        raise InputError(Text("cli-prior-problem", file=str(prior), problem=error)) from error
    except ValueError as error:
        raise InputError(Text("cli-named", name=str(signals), text=error)) from error
    all_maps = fitted.profile if prior_fit is None else prior_fit.profile
    profile, warnings = choose(all_maps, chosen, fitted.reasons, None if prior_fit is None else prior_fit.reasons)
    sources = [file for file in (signals, layout, prompts, prior) if file is not None]
    warn(recorded.damage)
    for sentence in warnings:
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
        typer.echo(json.dumps(document, allow_nan=False, default=str))
        return
    typer.echo(_report(profile, fitted.reasons, out, expected_figures(profile, discovery)))
    if prior_fit is not None:
        typer.echo("\n".join(["", *map(str, _prior_report(prior_fit))]))
    print_dialect(recorded, signals)
    if discovery is not None and gestures:
        typer.echo(f"\n{_gesture_table(discovery)}")


def _rate(share: float) -> Text:
    """Return a threshold as a share of the full movement per second."""
    return Text("cli-calibrate-rate", share=Figure(100 * share))


def _title(name: str) -> str:
    """Return the title of a column of the table of joints."""
    return str(Text(f"cli-joints-{name}"))


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
    profile: "CalibrationProfile", reasons: "dict[str, Text]", out: Path, expected: Mapping[str, tuple[Text, Text]]
) -> str:
    """Return a table for people: one line per joint, then the reasons, then the file of the profile.

    `expected` are the figures per joint, as of `expected_figures`.
    """
    from app.calibration.fit.profile_fit import joints_without_map

    without = joints_without_map(profile)
    rows: list[tuple[object, ...]] = [
        (
            joint.name,
            _percent(joint.evr),
            value_text(float(f"{joint.span:.4g}")),
            *expected[joint.name],
            *map(_rate, joint.thresholds),
            MAP_NAMES[joint.map],
        )
        for joint in profile.joints
    ]
    rows += [(name, *["-"] * (len(JOINT_COLUMNS) - 1)) for name in without]
    titles = [_title(column) for column in JOINT_COLUMNS]
    lines = table_lines([titles, *rows], left=(0, len(JOINT_COLUMNS) - 1))
    lines += ["", str(Text("cli-calibrate-clear-means")), str(Text("cli-calibrate-expected-means")), ""]
    lines += [_named(joint.name, joint.description) for joint in profile.joints]
    lines += [_named(name, reason) for name, reason in without.items()]
    lines += [
        str(Text("cli-channel-left-out", channel=name, reason=reason)) for name, reason in profile.left_out.items()
    ]
    lines += ["", *comparison(profile, reasons), "", str(Text("cli-calibrate-out", out=str(out)))]
    return "\n".join(lines)


def _named(name: str, text: Text | str) -> str:
    return str(Text("cli-named", name=name, text=text))


def _gesture_table(discovery: "Discovery") -> str:
    """Return one line per gesture, the best first, then the suggestion; `-` where there is no measurement."""
    titles = [Text("cli-gesture"), *(Text(f"cli-gestures-{column}") for column in GESTURE_COLUMNS)]
    lines = table_lines([titles, *((gesture.name, *_cells(gesture)) for gesture in discovery.gestures)])
    suggestion = discovery.suggestion
    bound = [_named(str(CONTROLS[binding.control]), " + ".join(binding.gestures)) for binding in suggestion.bindings]
    return "\n".join([*lines, "", str(suggestion.reason), ", ".join(bound)])


def _cells(gesture: "FoundGesture") -> list[object]:
    from app.calibration.map_grades import repeats_word, signal_word

    forecast = gesture.prediction
    return [
        value_text(Figure(gesture.score, 2)),
        str(signal_word(gesture.signal_to_noise)),
        "-" if gesture.repeatability is None else str(repeats_word(gesture.repeatability)),
        _share(gesture.cross_talk),
        _share(gesture.effort),
        "-"
        if forecast is None or forecast.false_per_minute is None
        else value_text(Figure(forecast.false_per_minute, 1)),
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


def _prior_report(prior_fit: "PriorFit") -> list[Text]:
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


def _joint_sentence(joint: "JointMap", reasons: "dict[str, Text]") -> Text:
    prior = joint.prior
    if prior is None:
        return Text("cli-named", name=joint.name, text=reasons[joint.name])
    hits, false = (
        Text("cli-unknown")
        if forecast is None
        else Text("cli-forecast", value=forecast.value, uncertainty=forecast.uncertainty)
        for forecast in (prior.hits, prior.false_per_minute)
    )
    return Text(
        "cli-prior-joint-dropped" if prior.dropped else "cli-prior-joint",
        joint=joint.name,
        source=prior.source,
        people=prior.people,
        repetitions=prior.repetitions,
        hits=hits,
        false=false,
        channels=", ".join(prior.dropped),
    )


def _ring_sentence(ring: str, arrangement: "Arrangement") -> Text:
    from app.calibration.linear_map import Arrangement

    if arrangement == Arrangement():
        return Text("cli-ring-as-others", ring=ring)
    return Text("cli-ring-mirrored" if arrangement.mirrored else "cli-ring-turned", ring=ring, places=arrangement.shift)


def choose(
    profile: "CalibrationProfile",
    chosen: MapChoice,
    reasons: "dict[str, Text]",
    prior_reasons: "dict[str, Text] | None" = None,
) -> "tuple[CalibrationProfile, list[Text]]":
    """Return the profile with the chosen map of each joint, and a sentence for each joint without it.

    `reasons` say why a joint has no guided map, `prior_reasons` why none from other people (None without a prior).
    """
    if chosen == "guided" and not any(joint.guided for joint in profile.joints):
        name, reason = next(iter(reasons.items()))
        raise InputError(Text("cli-map-guided-missing", joint=name, reason=reason))
    if chosen == "prior" and prior_reasons is None:
        raise InputError(Text("cli-map-needs-prior"))
    if chosen == "prior" and prior_reasons and not any(joint.prior for joint in profile.joints):
        name, reason = next(iter(prior_reasons.items()))
        raise InputError(Text("cli-map-prior-missing", joint=name, reason=reason))
    sentences = []
    for joint in profile.joints:
        if chosen == "guided" and joint.guided is None:
            sentences.append(Text("cli-map-fallback", joint=joint.name, reason=reasons[joint.name]))
        elif chosen == "guided" and joint.guided is not None and not joint.guided.is_better:
            sentences.append(Text("cli-map-guided-not-better", joint=joint.name))
        elif chosen == "prior" and joint.prior is None and prior_reasons is not None:
            sentences.append(Text("cli-map-fallback", joint=joint.name, reason=prior_reasons[joint.name]))
        elif chosen == "prior" and joint.prior is not None and not joint.prior.is_better:
            sentences.append(Text("cli-map-prior-worse", joint=joint.name))
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


def comparison(profile: "CalibrationProfile", reasons: "dict[str, Text]") -> list[str]:
    """Return the table of both maps on the held-out repetitions, then the reasons for missing guided maps."""
    both = [(joint.name, joint.guided) for joint in profile.joints if joint.guided]
    lines = []
    if both:
        titles = [str(Text(f"cli-compared-{title}")) for title in ("in-phase", "time-driven", "false")]
        rows: list[tuple[object, ...]] = [
            (_title("joint"), *(MAP_NAMES["pca"], MAP_NAMES["guided"]) * len(titles), Text("cli-compare-offered"))
        ]
        for name, guided in both:
            pairs = zip(_figures(guided.pca_check), _figures(guided.check), strict=True)
            rows.append((name, *chain(*pairs), Text("cli-yes" if guided.is_better else "cli-no")))
        widths = column_widths(rows)
        for second, title in enumerate(titles, start=1):  # over two columns
            widths[2 * second] = max(widths[2 * second], len(title) - widths[2 * second - 1] - len(BETWEEN))
        over = [widths[2 * second - 1] + len(BETWEEN) + widths[2 * second] for second in range(1, len(titles) + 1)]
        lines += [str(Text("cli-compare-title")), *table_lines([("", *titles)], [widths[0], *over])]
        lines += table_lines(rows, widths, left=(0, len(widths) - 1))
    return lines + [_named(name, reason) for name, reason in reasons.items()]


def _figures(check: "MapCheck | None") -> tuple[str, ...]:
    if check is None:
        return "-", "-", "-"
    return _percent(check.in_phase), _percent(check.hit_rate), value_text(Figure(check.false_per_minute, 1))


def _percent(share: float) -> str:
    return f"{value_text(Figure(100.0 * share, 1))} %"
