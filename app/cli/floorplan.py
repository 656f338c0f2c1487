"""`bodydrive floorplan`: the places to drive in, and new ones from maps, drawings and pictures."""

import json
from pathlib import Path
from typing import Annotated

import typer

from app.cli.common_options import AsJson
from app.cli.errors import InputError
from app.cli.help_text import help_text
from app.cli.output import write_output
from app.texts import Figure, Text, text_of
from app.world.imports.options import THRESHOLD

floorplan_app = typer.Typer(no_args_is_help=True, pretty_exceptions_enable=False)


@floorplan_app.command("import", help=help_text("cli-help-floorplan-import"))
def import_file(
    file: Annotated[Path, typer.Argument(metavar="FILE", help=help_text("cli-help-floorplan-import-file"))],
    out: Annotated[Path, typer.Option(help=help_text("cli-help-floorplan-import-out"))],
    *,
    name: Annotated[str | None, typer.Option(help=help_text("cli-help-floorplan-import-name"))] = None,
    title: Annotated[str | None, typer.Option(help=help_text("cli-help-floorplan-import-title"))] = None,
    unit: Annotated[str | None, typer.Option(help=help_text("cli-help-floorplan-import-unit"))] = None,
    layer: Annotated[list[str] | None, typer.Option(help=help_text("cli-help-floorplan-import-layer"))] = None,
    metres_per_pixel: Annotated[
        float | None, typer.Option(help=help_text("cli-help-floorplan-import-metres-per-pixel"))
    ] = None,
    width: Annotated[float | None, typer.Option(help=help_text("cli-help-floorplan-import-width"))] = None,
    threshold: Annotated[float, typer.Option(help=help_text("cli-help-floorplan-import-threshold"))] = THRESHOLD,
    outside: Annotated[bool, typer.Option("--outside", help=help_text("cli-help-floorplan-import-outside"))] = False,
    as_json: AsJson = False,
) -> None:
    """Make a floor plan from a ROS map, a DXF drawing or a picture: walls, and a path to drive."""
    from pydantic import ValidationError

    from app.sentences import one_sentence
    from app.world.imports.draft import plan_of
    from app.world.imports.options import Options
    from app.world.imports.plan_files import import_plan

    if out.suffix != ".json":
        raise InputError(Text("cli-plan-suffix", file=str(out)))
    fields = {
        "unit": unit,
        "layers": layer,
        "metres_per_pixel": metres_per_pixel,
        "width": width,
        "threshold": threshold,
        "outside": outside,
        "title": title,
        "name": name,
    }
    try:
        options = Options.model_validate_json(
            json.dumps({key: value for key, value in fields.items() if value is not None})
        )
    except ValidationError as error:
        raise InputError(one_sentence(error, Text("cli-the-options"))) from error
    try:
        draft = import_plan(file, options)
        if not draft.document["paths"]:
            raise ValueError(Text("cli-plan-no-room", file=str(file)))
        plan = plan_of(draft, str(file))
    except ValueError as error:
        raise InputError(text_of(error)) from error
    write_output(out, plan.model_dump_json(exclude_none=True).encode() + b"\n", file)
    walls, length = len(plan.segments()), plan.paths[0].line.length
    summary = {
        "name": plan.name,
        "title": plan.title,
        "walls": walls,
        "path_length": length,
        "out": str(out),
        "messages": [str(message) for message in draft.messages],
    }
    if as_json:
        typer.echo(json.dumps(summary))
    else:
        typer.echo(Text("cli-plan-made", title=plan.title, walls=walls, length=Figure(length, 1), out=str(out)))
        for sentence in draft.messages[1:]:
            typer.echo(sentence)


@floorplan_app.command("list", help=help_text("cli-help-floorplan-list"))
def list_plans(as_json: AsJson = False) -> None:
    """List what can be driven in and comes with the software: scenes by level, buildings, and their tasks."""
    from app.world.place_texts import plan_for_reader
    from app.world.scene import bundled_places

    try:
        plans = [offer.plan for offer in bundled_places().values()]
    except (ValueError, FileNotFoundError) as error:
        raise InputError(text_of(error)) from error
    listed = [
        {
            "name": plan.name,
            "title": plan.title,
            "paths": [
                {"name": path.name, "title": path.title, "length": path.line.length, "task": path.task.kind}
                for path in plan.paths
            ],
        }
        for plan in plans
    ]
    if as_json:
        typer.echo(json.dumps({"floorplans": listed}))
        return
    for plan in map(plan_for_reader, plans):
        typer.echo(f"{plan.name}: {plan.title}")
        for path in plan.paths:
            typer.echo(f"  {path.name:<14} {path.line.length:5.1f} m  {path.task.kind:<7} {path.title}")


@floorplan_app.command("check", help=help_text("cli-help-floorplan-check"))
def check_plan(
    file: Annotated[Path, typer.Argument(metavar="FILE.json", help=help_text("cli-help-floorplan-check-file"))],
    as_json: AsJson = False,
) -> None:
    """Say whether a floor plan or a scene can be driven in, and if not, what is wrong where."""
    from app.world.floorplan import load_floorplan
    from app.world.scene import is_scene, places_in

    try:
        plans = list(places_in(file)) if is_scene(file) else [load_floorplan(file).name]
    except ValueError as error:
        raise InputError(text_of(error)) from error
    typer.echo(
        json.dumps({"floorplans": plans}) if as_json else Text("cli-plan-fine", file=str(file), plans=", ".join(plans))
    )
