"""`bodydrive check`: measure what this computer grants, and say whether it will do."""

from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from app.cli.errors import InputError
from app.cli.port import bind
from app.settings import state_folder

if TYPE_CHECKING:
    from app.host.machine_check import Finding

MARKS = {"good": "  ", "attention": "! ", "bad": "!!"}


def check(
    seconds: Annotated[int, typer.Option(min=1, max=600, help="How long to measure the loop.")] = 10,
    state: Annotated[Path | None, typer.Option(help="The folder of the clinic's database and recordings.")] = None,
) -> None:
    """Measure what this computer grants, and say whether it will do; exit code 1 when it will not."""
    from app.clock import MonotonicClock, utc_now
    from app.host import machine_check as measured
    from app.pipeline.compiled import IS_COMPILED
    from app.realtime import go_real_time

    typer.echo(f"Measuring for {seconds} s, as the control loop would run ...")
    folder = (state or state_folder()).expanduser().resolve()
    real_time = measured.real_time_findings(go_real_time())
    installed = datetime.fromtimestamp(measured.install_time(), UTC)
    findings = [
        measured.lateness_finding(measured.measure_lateness(MonotonicClock(), seconds)),
        *real_time,
        measured.disk_finding(measured.free_room(folder)),
        measured.clock_finding(utc_now(), installed, is_kept=measured.clock_is_kept()),
        *(_port_finding(port) for port in (8080, 8443)),
        measured.Finding("good", "The middle of the program runs compiled.")
        if IS_COMPILED
        else measured.Finding("attention", "The middle of the program runs as plain Python: the same, but slower."),
    ]
    last = measured.summary(findings)
    for finding in findings:
        typer.echo(f"{MARKS[finding.verdict]} {finding.words}")
    typer.echo(last.words)
    if last.verdict == "bad":
        raise typer.Exit(1)


def _port_finding(port: int) -> "Finding":
    from app.host.machine_check import Finding

    try:
        bind("127.0.0.1", port).close()
    except InputError:
        return Finding("attention", f"Port {port} is in use, perhaps by the clinic itself.")
    return Finding("good", f"Port {port} is free.")
