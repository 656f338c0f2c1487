"""`bodydrive demo` and `bodydrive serve`: the web process, from its start to its end."""

import os
import socket
import sys
import tempfile
from contextlib import ExitStack
from pathlib import Path
from typing import Annotated

import typer

from app.cli.clinic_folder import held, keep_private
from app.cli.errors import InputError
from app.cli.port import bind, link_to, proxy_network, public_name
from app.files import write_atomically
from app.refusals import Refusal
from app.settings import Settings, new_code, state_folder
from app.world.floorplan import FloorPlan, load_floorplan

Port = Annotated[int, typer.Option(min=0, max=65_535, help="The port to listen on; 0 takes any free one.")]
Host = Annotated[str, typer.Option(help="The address to listen on; other machines reach only other ones than this.")]
Plans = Annotated[list[Path] | None, typer.Option("--floorplan", help="A floor plan of your own to drive in, too.")]
State = Annotated[Path | None, typer.Option(help="The folder of the clinic's database and recordings.")]
Proxy = Annotated[
    str | None,
    typer.Option(
        "--behind-proxy", help="The address of the clinic's own reverse proxy, the only way in; needs --name."
    ),
]
Name = Annotated[str | None, typer.Option(help="The name, or NAME:PORT, by which browsers reach the proxy.")]

LOOPBACK = ("127.0.0.1", "localhost", "::1")


def demo(port: Port = 8080, host: Host = "127.0.0.1", floorplans: Plans = None) -> None:
    """Open a throw-away demonstration clinic: a simulated shirt, a patient, and the virtual chair."""
    plans = [_floorplan(file) for file in floorplans or []]
    with bind(host, port) as listening, tempfile.TemporaryDirectory(prefix="bodydrive-demo-") as folder:
        bound = int(listening.getsockname()[1])
        settings = Settings(state=Path(folder), host=host, port=bound, demo_code=new_code())
        keep_private(settings)
        _furnish_demonstration(settings, plans)
        words = ["A demonstration, kept nowhere. Ctrl-C ends it.", *_warning(host)]
        words.append(f"{link_to(host, bound)}#demo={settings.demo_code}")
        _run(settings, listening, words)
    _leave()


def serve(
    port: Port = 8080, host: Host = "127.0.0.1", state: State = None, behind_proxy: Proxy = None, name: Name = None
) -> None:
    """Open a clinic; its database and recordings are kept."""
    if (behind_proxy is None) != (name is None):
        raise InputError("--behind-proxy and --name belong together: give the proxy's address, and its name.")
    proxy = None if behind_proxy is None else proxy_network(behind_proxy)
    reached_by = "" if name is None else public_name(name)
    folder = (state or state_folder()).expanduser().resolve()
    with ExitStack() as stack:
        listening = stack.enter_context(bind(host, port))
        bound = int(listening.getsockname()[1])
        stack.enter_context(held(folder, link_to(host, bound)))
        warnings = keep_private(Settings(state=folder))
        code = new_code() if _nobody_yet(folder) else None
        settings = Settings(state=folder, host=host, port=bound, setup_code=code, proxy=proxy, public_name=reached_by)
        link = f"https://{reached_by}/" if reached_by else link_to(host, bound)
        words = [f"The clinic in {folder}. Ctrl-C ends it.", *_warning(host), *warnings]
        if code is None:
            words.append(link)
        else:
            words += [
                f"Set-up code, for the first owner, within 30 minutes: {code}",
                f"{link}#setup={code}",
            ]
        _run(settings, listening, words)
    _leave()


def _run(settings: Settings, listening: socket.socket, words: list[str]) -> None:
    from app.cli.server import run_clinic

    run_clinic(settings, listening, "\n".join(words))


def _leave() -> None:
    """End the process at once: everything is closed and on the disk, and unloading the libraries would take long."""
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(0)


def _warning(host: str) -> list[str]:
    if host in LOOPBACK:
        return []
    return ["Others on the network can reach this, and nothing on the way is encrypted."]


def _floorplan(file: Path) -> FloorPlan:
    try:
        return load_floorplan(file)
    except ValueError as error:
        raise InputError(str(error)) from error


def _furnish_demonstration(settings: Settings, plans: list[FloorPlan]) -> None:
    from app.cli.demonstration import furnish
    from app.store.database import Database

    for plan in plans:
        write_atomically(settings.floorplans / f"{plan.name}.json", plan.model_dump_json().encode())
    database = Database(settings.database)
    try:
        furnish(database)
    finally:
        database.close()


def _nobody_yet(folder: Path) -> bool:
    from app.store.database import Database
    from app.store.people import count_people

    try:
        database = Database(Settings(state=folder).database)
    except Refusal as refusal:
        raise InputError(str(refusal)) from refusal
    try:
        with database.transaction() as db:
            return count_people(db) == 0
    finally:
        database.close()
