"""`bodydrive floorplan`: the storeys to drive in, and new ones from a robot's map."""

import json
from pathlib import Path
from typing import Annotated

import typer

from app.cli.errors import InputError
from app.cli.output import write_output
from app.world.floorplan import bundled_floorplans, load_floorplan
from app.world.map_import import import_ros_map

floorplan_app = typer.Typer(
    help="List the floor plans that come with the software, or make one from a ROS map.",
    no_args_is_help=True,
    pretty_exceptions_enable=False,
)

AsJson = Annotated[bool, typer.Option("--json", help="Print one JSON object and nothing else.")]


@floorplan_app.command("import")
def import_map(
    map_file: Annotated[Path, typer.Argument(metavar="MAP.yaml", help="The YAML file of a ROS map_server map.")],
    out: Annotated[Path, typer.Option(help="Where the floor plan goes: a .json file.")],
    name: Annotated[str | None, typer.Option(help="The plan's name: letters, digits, dots, dashes.")] = None,
    title: Annotated[str | None, typer.Option(help="What people call it.")] = None,
    as_json: AsJson = False,
) -> None:
    """Make a floor plan from a ROS map: walls around the free space, and a path to drive in it."""
    if out.suffix != ".json":
        raise InputError(f"--out {out}: its name must end in .json")
    try:
        plan = import_ros_map(map_file, title, name)
    except ValueError as error:
        raise InputError(str(error)) from error
    write_output(out, plan.model_dump_json(exclude_none=True).encode() + b"\n", map_file)
    path = plan.paths[0]
    summary = {
        "name": plan.name,
        "title": plan.title,
        "walls": len(plan.segments()),
        "path_length": path.line.length,
        "out": str(out),
    }
    if as_json:
        typer.echo(json.dumps(summary))
    else:
        typer.echo(
            f"{plan.title}: {summary['walls']} wall pieces, a path of {path.line.length:.1f} m, written to {out}"
        )


@floorplan_app.command("list")
def list_plans(as_json: AsJson = False) -> None:
    """List the floor plans that come with the software, and their paths."""
    try:
        plans = [load_floorplan(file) for file in bundled_floorplans().values()]
    except (ValueError, FileNotFoundError) as error:
        raise InputError(str(error)) from error
    listed = [
        {
            "name": plan.name,
            "title": plan.title,
            "paths": [{"name": path.name, "title": path.title, "length": path.line.length} for path in plan.paths],
        }
        for plan in plans
    ]
    if as_json:
        typer.echo(json.dumps({"floorplans": listed}))
        return
    for plan in plans:
        typer.echo(f"{plan.name}: {plan.title}")
        for path in plan.paths:
            typer.echo(f"  {path.name:<14} {path.line.length:5.1f} m  {path.title}")
