"""`bodydrive demo`, with its throw-away clinic, and `bodydrive serve`: the web process, from its start to its end."""

import os
import socket
import sys
import tempfile
from contextlib import ExitStack, closing
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from app.cli.clinic_folder import keep_private, lock_folder
from app.cli.common_options import State, folder_of
from app.cli.errors import InputError
from app.cli.help_text import help_text
from app.cli.port import bind, bind_here, proxy_network, public_name
from app.clock import utc_now
from app.faulty_python import python_warning
from app.files import write_atomically
from app.network import link
from app.ports import HTTP_PORT, HTTPS_PORT
from app.realtime import collect_seldom
from app.refusals import Refusal
from app.settings import Settings, data_folder, new_code
from app.texts import Text, text_of

if TYPE_CHECKING:
    from app.cli.host.lan import Lan
    from app.process.supervisor import Launch
    from app.store.database import Database
    from app.world.floorplan import FloorPlan

Port = Annotated[int, typer.Option(min=0, max=65_535, help=help_text("cli-help-port"))]
Host = Annotated[str, typer.Option(help=help_text("cli-help-demo-host"))]
ServePort = Annotated[
    int | None,
    typer.Option(min=0, max=65_535, show_default=f"{HTTP_PORT}, https: {HTTPS_PORT}", help=help_text("cli-help-port")),
]
Hosts = Annotated[list[str] | None, typer.Option("--host", help=help_text("cli-help-serve-host"))]
Network = Annotated[bool, typer.Option("--lan", help=help_text("cli-help-serve-lan"))]
CertificateFile = Annotated[Path | None, typer.Option("--certificate", help=help_text("cli-help-serve-certificate"))]
KeyFile = Annotated[Path | None, typer.Option("--key", help=help_text("cli-help-serve-key"))]
Plans = Annotated[list[Path] | None, typer.Option("--floorplan", help=help_text("cli-help-demo-floorplan"))]
Proxy = Annotated[str | None, typer.Option("--behind-proxy", help=help_text("cli-help-serve-behind-proxy"))]
Name = Annotated[str | None, typer.Option(help=help_text("cli-help-serve-name"))]
Lsl = Annotated[bool, typer.Option("--lsl", help=help_text("cli-help-serve-lsl"))]
PATIENT = ("DEMO-1", "Kingfisher")
NEWCOMER = ("DEMO-2", "Heron")


def demo(port: Port = HTTP_PORT, host: Host = "127.0.0.1", floorplans: Plans = None) -> None:
    """Open a throw-away demonstration clinic: a simulated shirt, a patient, and the virtual chair."""
    collect_seldom()
    plans = [_floorplan(file) for file in floorplans or []]
    with ExitStack() as stack:
        listening = stack.enter_context(bind_here(host, port))
        folder = stack.enter_context(tempfile.TemporaryDirectory(prefix="bodydrive-demo-"))
        bound = int(listening.getsockname()[1])
        settings = Settings(state=Path(folder), host=host, port=bound, demo_code=new_code())
        keep_private(settings)
        launch = stack.enter_context(closing(_launch()))
        _furnish_demonstration(settings, plans)
        address = f"{link('http', host, bound)}#demo={settings.demo_code}"
        _run(settings, launch, listening, [Text("cli-demo-opened"), address])
    _leave()


def serve(
    port: ServePort = None,
    host: Hosts = None,
    state: State = None,
    lan: Network = False,
    certificate: CertificateFile = None,
    key: KeyFile = None,
    behind_proxy: Proxy = None,
    name: Name = None,
    *,
    lsl: Lsl = False,
) -> None:
    """Open a clinic; its database and recordings are kept."""
    from app.api.sign_in.set_up import VALID_FOR
    from app.cli.host.lan import Lan, bind_local, own_files

    collect_seldom()
    if (behind_proxy is None) != (name is None):
        raise InputError(Text("cli-proxy-needs-name"))
    if behind_proxy is not None and lan:
        raise InputError(Text("cli-proxy-or-lan"))
    if lsl:
        _load_lsl()
    proxy = None if behind_proxy is None else proxy_network(behind_proxy)
    reached_by = "" if name is None else public_name(name)
    folder = folder_of(state)
    own_certificate, hosts = own_files(certificate, key, lan=lan), host or []
    if len(hosts) > 1 and not lan:
        raise InputError(Text("cli-one-host"))
    first = hosts[0] if hosts and not lan else "127.0.0.1"
    with ExitStack() as stack:
        if lan:
            listening = stack.enter_context(bind_local(port))
        else:  # a proxy on another machine, the only one that is answered, reaches an address of the network
            bind_to = bind_here if proxy is None else bind
            listening = stack.enter_context(bind_to(first, HTTP_PORT if port is None else port))
        bound = int(listening.getsockname()[1])
        local_address = link("http", first, bound)
        write_address = stack.enter_context(lock_folder(folder))
        settings = Settings(state=folder)
        warnings = keep_private(settings)
        launch = stack.enter_context(closing(_launch()))
        other_machines = stack.enter_context(Lan(hosts, port, settings.authority, own_certificate)) if lan else None
        settings = Settings(
            state=folder,
            host=first,
            port=bound,
            setup_code=new_code() if _nobody_yet(folder) else None,
            proxy=proxy,
            public_name=reached_by,
            network=None if other_machines is None else other_machines.service,
            lsl=lsl,
        )
        opened = f"https://{reached_by}/" if reached_by else local_address
        write_address(opened if other_machines is None else other_machines.service.link())
        lines: list[Text | str] = [Text("cli-serve-opened", folder=str(folder)), *warnings]
        if settings.setup_code is None:
            lines.append(opened)
        else:
            printed = Text("cli-setup-code", code=settings.setup_code, minutes=round(VALID_FOR / 60))
            lines += [printed, f"{opened}#setup={settings.setup_code}"]
        lines += [] if other_machines is None else other_machines.refresh()
        _run(settings, launch, listening, lines, other_machines)
    _leave()


def _load_lsl() -> None:
    """Load what `--lsl` needs: nothing may be loaded later, while a chair may move."""
    from app.features import names
    from app.lsl_library import LSL_MISSING, load_lsl

    try:
        if "lsl" not in names():
            raise ImportError
        load_lsl()
    except LSL_MISSING as error:
        raise InputError(Text("shirtdev-lsl-no-library")) from error


def _launch() -> "Launch":
    """Launch the control process, which loads its libraries while this one loads its own."""
    from app.process.supervisor import launch

    try:
        return launch()
    except OSError as error:
        raise InputError(Text("cli-control-process-failed", reason=error.strerror or error)) from error


def _run(
    settings: Settings,
    launch: "Launch",
    listening: socket.socket,
    lines: list[Text | str],
    other_machines: "Lan | None" = None,
) -> None:
    from app.cli.server import run_clinic

    warning = python_warning(sys.version_info[:3])
    message = "\n".join(map(str, filter(None, [*lines, warning])))
    run_clinic(settings, launch, listening, message, other_machines)


def _leave() -> None:
    """End the process at once: everything is closed and on the disk, and unloading the libraries would take long."""
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(0)


def _floorplan(file: Path) -> "FloorPlan":
    from app.world.floorplan import load_floorplan

    try:
        return load_floorplan(file)
    except ValueError as error:
        raise InputError(text_of(error)) from error


def _furnish_demonstration(settings: Settings, plans: "list[FloorPlan]") -> None:
    from app.store.database import Database

    for plan in plans:
        write_atomically(settings.floorplans / f"{plan.name}.json", plan.model_dump_json().encode())
    database = Database(settings.database)
    try:
        furnish(database)
    finally:
        database.close()


def furnish(database: "Database") -> None:
    """Make the demonstration clinic: a patient in an open session, ready to drive, and one never calibrated.

    The first patient was calibrated by the application's own calibration.
    """
    from app.calibration.profile import CalibrationProfile
    from app.calibration.vocabulary import standard_parameters
    from app.store.parameters import save_parameters, save_profile
    from app.store.patients import add_patient, start_session
    from app.store.people import add_clinic

    shipped = CalibrationProfile.model_validate_json(profile_file().read_bytes())
    profile = shipped.model_copy(update={"created": utc_now().isoformat(timespec="seconds")})
    with database.transaction() as db:
        add_clinic(db, str(Text("cli-demo-clinic")))
        patient = add_patient(db, *PATIENT, str(Text("cli-demo-calibrated")))
        add_patient(db, *NEWCOMER, str(Text("cli-demo-newcomer")))
        session = start_session(db, patient.id)
        row = save_profile(db, patient.id, session.id, profile, simulated=True)
        save_parameters(db, row, standard_parameters(profile))


def profile_file() -> Path:
    """Return the file of the simulated person's calibration; `make shipped FILE=demo-profile` writes it."""
    return data_folder() / "demo" / "profile.json"


def _nobody_yet(folder: Path) -> bool:
    from app.store.database import Database
    from app.store.people import count_people

    try:
        database = Database(Settings(state=folder).database)
    except Refusal as refusal:
        raise InputError(text_of(refusal)) from refusal
    try:
        with database.reading() as db:
            return count_people(db) == 0
    finally:
        database.close()
