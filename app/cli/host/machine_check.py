"""`bodydrive check`: measure what this computer grants, and say whether it will do."""

import json
from dataclasses import asdict
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from app.cli.common_options import AsJson, State, folder_of
from app.cli.help_text import help_text
from app.texts import Text

if TYPE_CHECKING:
    from app.host.machine_check import Finding

MARKS = {"good": "  ", "attention": "! ", "bad": "!!"}


def check(
    seconds: Annotated[int, typer.Option(min=1, max=600, help=help_text("cli-help-check-seconds"))] = 10,
    state: State = None,
    own_ports: Annotated[
        list[int] | None,
        typer.Option("--own-port", min=1, max=65_535, help=help_text("cli-help-check-own-port")),
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Measure what this computer grants, and say whether it is good enough for driving; exit code 1 when it is not."""
    from app.host.machine_check import summary

    if not as_json:
        typer.echo(Text("cli-check-begins", seconds=seconds))
    findings = _findings(seconds, folder_of(state), own_ports or [])
    last = summary(findings)
    if as_json:
        typer.echo(json.dumps({**asdict(last), "findings": [asdict(finding) for finding in findings]}, default=str))
    else:
        for finding in findings:
            typer.echo(f"{MARKS[finding.verdict]} {finding.message}")
        typer.echo(last.message)
    if last.verdict == "bad":
        raise typer.Exit(1)


def _findings(seconds: int, folder: Path, own_ports: list[int]) -> list["Finding"]:
    from app.clock import MonotonicClock, utc_now
    from app.host import machine_check as measured
    from app.pipeline.compiled import IS_COMPILED
    from app.realtime import go_real_time

    real_time = measured.real_time_findings([Text(message) for message in go_real_time()])
    installed = datetime.fromtimestamp(measured.install_time(), UTC)
    return [
        measured.lateness_finding(measured.measure_lateness(MonotonicClock(), seconds)),
        *real_time,
        measured.disk_finding(measured.free_room(folder)),
        measured.clock_finding(utc_now(), installed, is_kept=measured.clock_is_kept()),
        *(measured.port_finding(port, is_own=bool(own_ports)) for port in own_ports or measured.PORTS),
        measured.program_finding(is_compiled=IS_COMPILED),
    ]
