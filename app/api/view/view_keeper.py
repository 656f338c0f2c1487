"""The 3D view of the open session: opened and closed with it, showing the floor plan of the trial."""

import asyncio
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager, suppress
from pathlib import Path
from typing import Protocol

import numpy as np
from fastapi import WebSocket

from app.api.driving.clinic_places import ClinicPlaces
from app.api.parts import parts_of
from app.api.sockets import NOT_VISIBLE, OpenSockets
from app.realtime import return_memory
from app.scene.role_servers import Role, RoleServers
from app.scene.scene_thread import SceneThread, start_scene
from app.scene.session_scene import LiveScene
from app.session.open_session import SessionFlow
from app.world.floorplan import FloorPlan

ReadNewest = Callable[[], "np.void | None"]


class SessionScene(Protocol):
    """One session's scene and the ports of its servers."""

    @property
    def scene(self) -> LiveScene:
        """Return the scene."""
        ...

    def port(self, role: Role) -> int:
        """Return the port of a role's server."""
        ...

    def stop(self) -> None:
        """End threads and servers."""
        ...


class ServedScene:
    """A scene that viser serves, with its servers and its thread."""

    def __init__(self, read_newest: ReadNewest, models: Path | None = None) -> None:
        self._servers = RoleServers()
        try:
            self._thread: SceneThread = start_scene(self._servers, read_newest, models)
        except BaseException:
            self._servers.stop()
            raise

    @property
    def scene(self) -> LiveScene:
        """Return the scene."""
        return self._thread.scene

    def port(self, role: Role) -> int:
        """Return the port of a role's server."""
        return self._servers.port(role)

    def stop(self) -> None:
        """End the thread, then the servers."""
        self._thread.stop()
        self._servers.stop()


OpenScene = Callable[[ReadNewest], SessionScene]


class ViewKeeper:
    """Keeps the scene of the open session; without `open_scene` there is never one."""

    def __init__(self, open_scene: OpenScene | None, read_newest: ReadNewest) -> None:
        self._open_scene = open_scene
        self._read_newest = read_newest
        self._scene: SessionScene | None = None
        self._shown: tuple[FloorPlan, str] | None = None
        self._one_at_a_time = asyncio.Lock()

    @property
    def scene(self) -> LiveScene | None:
        """Return the scene, None while no session is open."""
        return None if self._scene is None else self._scene.scene

    def port(self, role: Role) -> int | None:
        """Return the port of a role's server, None while no session is open."""
        return None if self._scene is None else self._scene.port(role)

    async def open(self, plan: FloorPlan | None, path: str | None) -> None:
        """Close the old scene and open one for a new session, showing this plan at first."""
        async with self._one_at_a_time:
            await self._close()
            if self._open_scene is not None:
                self._scene = await asyncio.to_thread(self._open_scene, self._read_newest)
                if plan is not None and path is not None:
                    await self._show(plan, path)

    async def close(self) -> None:
        """Close the scene, because the session has ended."""
        async with self._one_at_a_time:
            await self._close()

    async def show(self, plan: FloorPlan, path: str) -> None:
        """Show the plan of a trial that begins, without the trajectory of the one before."""
        async with self._one_at_a_time:
            await self._show(plan, path)

    async def _show(self, plan: FloorPlan, path: str) -> None:
        scene = self.scene
        if scene is None:
            return
        if self._shown == (plan, path):
            await asyncio.to_thread(scene.new_trial)
        else:
            await asyncio.to_thread(scene.set_floorplan, plan, path)
            self._shown = (plan, path)

    async def _close(self) -> None:
        if self._scene is None:
            return
        ending, self._scene, self._shown = [self._scene], None, None
        await asyncio.to_thread(_end, ending)


def _end(ending: list[SessionScene]) -> None:
    """End the only scene of the list, and return its memory.

    viser's objects refer to each other, so that only a collection frees them, with every message that was sent. Python
    itself may let several sessions pass until it does a full one. The scene is taken out of the list, because whoever
    called, and the thread that does the work, keep the list until this has returned.
    """
    with suppress(RuntimeError):  # its servers may have ended already
        ending.pop().stop()
    return_memory()


async def open_view(keeper: ViewKeeper, places: ClinicPlaces) -> None:
    """Open a 3D view for the session that began."""
    await keeper.open(*await asyncio.to_thread(places.first))


@asynccontextmanager
async def may_view(websocket: WebSocket, role: Role) -> AsyncIterator[bool]:
    """Admit a websocket of the 3D view by origin and sign-in (the patient's view: or pairing) until that ends.

    Who may not see the patient of the open session is answered as when there is no session.
    """
    parts = parts_of(websocket.app)
    sockets, session = parts[OpenSockets], parts[SessionFlow]
    viewer = await (sockets.admit_viewer if role == "patient" else sockets.admit)(websocket)
    if viewer is None:
        yield False
        return
    if not viewer.sees(session.patient_id):
        await websocket.close(NOT_VISIBLE)
        yield False
        return
    async with sockets.guarded(websocket, viewer, lambda now: now.sees(session.patient_id)):
        yield True
