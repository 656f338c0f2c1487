"""`bodydrive check`: measure what this computer grants, and say whether it will do."""

import json
from dataclasses import asdict
from typing import Annotated

import typer

from app.cli.common_options import AsJson, State, folder_of
from app.cli.help_text import help_text
from app.texts import Text

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
    from app.host.machine_check import machine_findings, summary
    from app.pipeline.compiled import IS_COMPILED

    if not as_json:
        typer.echo(Text("cli-check-begins", seconds=seconds))
    findings = machine_findings(seconds, folder_of(state), own_ports or [], is_compiled=IS_COMPILED)
    last = summary(findings)
    if as_json:
        typer.echo(json.dumps({**asdict(last), "findings": [asdict(finding) for finding in findings]}, default=str))
    else:
        for finding in findings:
            typer.echo(f"{MARKS[finding.verdict]} {finding.message}")
        typer.echo(last.message)
    if last.verdict == "bad":
        raise typer.Exit(1)
