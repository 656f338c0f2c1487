"""The web application: its routes, its pages, and the life of its parts."""

import asyncio
from collections.abc import AsyncIterator, Iterable
from contextlib import asynccontextmanager
from functools import cache
from typing import Any

from fastapi import APIRouter, Depends, FastAPI, Request
from starlette.routing import BaseRoute

from app import __version__
from app.api import package_download
from app.api.assembly import StartProcess, end_parts, make_parts, start_parts
from app.api.computer import this_computer
from app.api.deps import Owner, viewer
from app.api.driving import places
from app.api.guard import Guard
from app.api.live import camera_socket, live_socket, phone_socket, screen_socket
from app.api.page_session import clinician_in_session
from app.api.pages import Pages, PagesFirst, docs_pages
from app.api.parts import Parts, parts_of
from app.api.patient_screen import patient_socket
from app.api.patient_screen import routes as patient_screen
from app.api.proxy import BehindProxy
from app.api.refusals import REFUSALS, install_refusals
from app.api.replay import replay_view, trial_replay
from app.api.request_language import RequestLanguage
from app.api.routes import (
    adaptation,
    calibration,
    chairs,
    control_quality,
    controls,
    drives,
    equipment,
    limits,
    models,
    patients,
    people,
    phone_pairing,
    plans,
    recording_imports,
    reference,
    replacements,
    review,
    start,
    stop,
    tablets,
    trial_plan,
    trials,
)
from app.api.sign_in import accept_invitation, auth, introduction, own_language, own_password
from app.api.sockets import OpenSockets
from app.api.view.view_bridge import view_router
from app.api.view.view_controls import view_controls
from app.api.view.view_keeper import OpenScene, ViewKeeper, may_view
from app.api.who_asks import who_asks
from app.computing_process import ComputingProcess
from app.features.registration import feature_routers
from app.scene.role_servers import Role
from app.scene.session_scene import LiveScene
from app.settings import Settings, docs_folder, static_folder
from app.store.database import Database
from app.store.keeping.passed_time import store_clocks
from app.store.log_chain import warn_of_changed_log
from app.texts import LANGUAGES, load_language
from app.world.scene import bundled_places

PREFIX = "/api/v1"
FIRST_PAGE = 3.0  # s: until it is shown after a start, also on a slow machine
ROUTES = (
    stop,  # a request is compared with them in this order, and nothing is as urgent
    start,
    reference,
    auth,
    accept_invitation,
    own_language,
    own_password,
    introduction,
    people,
    patients,
    equipment,
    recording_imports,
    chairs,
    limits,
    calibration,
    controls,
    adaptation,
    places,
    trials,
    trial_replay,
    replay_view,
    plans,
    models,
    replacements,
    tablets,
    this_computer,
    drives,
    review,
    control_quality,
    package_download,
    live_socket,
    screen_socket,
    camera_socket,
    phone_socket,
    phone_pairing,
    patient_screen,
    patient_socket,
    trial_plan,
)

WebApp = FastAPI


def create_app(
    settings: Settings, start_process: StartProcess, computing: ComputingProcess, open_scene: OpenScene | None = None
) -> FastAPI:
    """Return the web application; its parts start and end with it.

    `start_process` starts a control process, `computing` reads recordings, and `open_scene` opens the 3D view of a
    session; without `open_scene` there is no 3D view.
    """

    @asynccontextmanager
    async def lifespan(app: FastAPI) -> AsyncIterator[None]:
        database = await asyncio.to_thread(_opened, settings)
        parts = make_parts(app, settings, database, start_process, computing, open_scene)
        await start_parts(parts)
        reading = asyncio.create_task(_read_languages())
        # The places are validated before the first page asks for them.
        beside = [
            asyncio.create_task(asyncio.to_thread(warn_of_changed_log, settings.database)),
            asyncio.create_task(asyncio.to_thread(bundled_places)),
        ]
        try:
            yield
        finally:
            reading.cancel()
            await asyncio.gather(reading, *beside, return_exceptions=True)
            await end_parts(parts)

    app = FastAPI(
        title="bodydrive",
        version=__version__,
        lifespan=lifespan,
        openapi_url=None,  # _described() serves it, to owners; FastAPI's pages for it load foreign scripts
    )

    def scene_now() -> LiveScene | None:
        return parts_of(app)[ViewKeeper].scene

    def port_of(role: Role) -> int | None:
        return parts_of(app)[ViewKeeper].port(role)

    install_refusals(app)
    app.router.routes.extend(_routes_of_all_clinics())
    app.include_router(_api([view_controls(scene_now, clinician_in_session)]))
    app.include_router(view_router(port_of, may_view, viewer))
    pages = _pages()
    app.mount("/docs/", docs_pages(docs_folder(), pages.text("docs.html")), name="docs")
    app.mount("/", pages, name="pages")
    app.add_middleware(PagesFirst, pages=pages)
    app.add_middleware(Guard, settings=settings)
    app.add_middleware(BehindProxy, settings=settings)  # before all others, which see what the browser sent
    app.add_middleware(RequestLanguage)
    return app


async def _read_languages() -> None:
    """Read the messages, English at once and the others after the first page, long before somebody drives.

    While a thread reads, a turn of the event loop, so also a Stop, may wait for Python to switch threads (5 ms).
    """
    for language in LANGUAGES:
        await asyncio.to_thread(load_language, language)
        await asyncio.sleep(FIRST_PAGE)


def _opened(settings: Settings) -> Database:
    """Open the database, and look at the clocks before anything is written that names a time."""
    database = Database(settings.database)
    with database.transaction(closing=True) as db:
        store_clocks(db)
    return database


def _api(routers: Iterable[APIRouter]) -> APIRouter:
    """Return a router that serves these below the prefix; each route first finds who asks."""
    api = APIRouter(prefix=PREFIX, dependencies=[Depends(who_asks)], responses=REFUSALS)
    for router in routers:
        api.include_router(router)
    return api


@cache
def _pages() -> Pages:
    """Return the pages, which are read and compressed once in a process."""
    return Pages(static_folder())


@cache
def _routes_of_all_clinics() -> list[BaseRoute]:
    """Return the routes that ask the request for their application; to make them ready takes longer than all else."""
    api = _api((*(module.router for module in ROUTES), _described(), *feature_routers()))
    return [*api.routes, *replay_view.page_router.routes]


def _described() -> APIRouter:
    """Return the route of the OpenAPI document; for owners only, because it would help an attacker."""
    router = APIRouter()

    @router.get("/openapi.json", include_in_schema=False)
    def describe(_person: Owner, request: Request) -> dict[str, Any]:
        """Return the OpenAPI document."""
        document: dict[str, Any] = request.app.openapi()
        return document

    return router


def prepare_routes(app: WebApp) -> None:
    """Make what the routes otherwise make for the first request, which takes longer than a Stop may wait."""
    for route in app.routes:
        route.matches({"type": "websocket", "path": PREFIX, "root_path": "", "headers": []})


async def say_goodbye(app: WebApp) -> None:
    """Close every open page's sockets, so that nothing is waited for when the program ends."""
    parts: Parts | None = getattr(app.state, "parts", None)
    if parts is not None:
        await parts[OpenSockets].close_all()
