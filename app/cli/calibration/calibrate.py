"""`bodydrive calibrate`: the calibration on a file."""

import json
from pathlib import Path
from typing import Annotated

import typer

from app.cli.calibration.map_choice import MapChoice, choose
from app.cli.errors import InputError
from app.cli.output import dialect_summary, print_dialect, warn, write_output


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
    as_json: Annotated[bool, typer.Option("--json", help="Print one JSON object and nothing else.")] = False,
) -> None:
    """Fit a calibration profile to a file of signals: per joint its main movement, span, sign and thresholds."""
    from app.calibration.cued_runs import run_of_prompts
    from app.calibration.gestures.discovery import discover
    from app.calibration.prior.map_prior import MapPrior, PriorError
    from app.calibration.prior.prior_file import read_prior
    from app.calibration.prompts_file import read_prompts
    from app.cli.calibration.calibration_summary import report, summary
    from app.cli.calibration.expected_figures import expected_figures
    from app.cli.calibration.file_fit import fit_file, window
    from app.cli.calibration.gesture_table import gesture_table
    from app.cli.calibration.prior_summary import prior_report, prior_summary
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
        fitted, known = fit_file(recorded, shirt, rows, free, rest, unused or (), end, pool)
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
    needed = gestures or (rows and not as_json)
    found = discover(profile, [run_of_prompts(recorded.t, recorded.values, rows, free, rest)]) if needed else None
    if as_json:
        more: dict[str, object] = {} if found is None else {"gestures": found.model_dump(mode="json")}
        if known is not None:
            more |= prior_summary(known)
        typer.echo(
            json.dumps(summary(profile, fitted.reasons, out) | dialect_summary(recorded) | more, allow_nan=False)
        )
    else:
        typer.echo(report(profile, fitted.reasons, out, expected_figures(profile, found)))
        if known is not None:
            typer.echo()
            typer.echo("\n".join(prior_report(known)))
        print_dialect(recorded, signals)
        if found is not None and gestures:
            typer.echo(f"\n{gesture_table(found)}")
