"""`bodydrive floorplan`: the places to drive in, and new ones from a robot's map."""

import json
from pathlib import Path
from typing import Annotated

import typer

from app.cli.errors import InputError
from app.cli.output import write_output
from app.world.floorplan import load_floorplan
from app.world.map_import import import_ros_map
from app.world.scene import bundled_places, is_scene, offers_in

floorplan_app = typer.Typer(
    help="List the places that come with the software, check one, or make one from a ROS map.",
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
    """List what can be driven in and comes with the software: scenes by level, buildings, and their tasks."""
    try:
        plans = [offer.plan for offer in bundled_places().values()]
    except (ValueError, FileNotFoundError) as error:
        raise InputError(str(error)) from error
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
    for plan in plans:
        typer.echo(f"{plan.name}: {plan.title}")
        for path in plan.paths:
            typer.echo(f"  {path.name:<14} {path.line.length:5.1f} m  {path.task.kind:<7} {path.title}")


@floorplan_app.command("check")
def check_plan(
    file: Annotated[Path, typer.Argument(metavar="FILE.json", help="A floor plan or a scene.")], as_json: AsJson = False
) -> None:
    """Say whether a floor plan or a scene can be driven in, and if not, what is wrong where."""
    try:
        plans = list(offers_in(file)) if is_scene(file) else [load_floorplan(file).name]
    except ValueError as error:
        raise InputError(str(error)) from error
    typer.echo(json.dumps({"floorplans": plans}) if as_json else f"{file}: fine ({', '.join(plans)})")
