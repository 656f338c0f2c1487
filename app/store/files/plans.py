"""The clinic's own floor plans: one file each, and beside them every saved version."""

from contextlib import suppress
from pathlib import Path
from threading import Lock
from typing import NamedTuple

from app.files import write_atomically
from app.refusals import Conflict, NotFound
from app.store.files.name_conflicts import SameName, name_for
from app.store.files.replacements import ReplacedFiles
from app.texts import Text
from app.world.floorplan import FloorPlan, bundled_floorplans, load_floorplan
from app.world.scene import bundled_scenes

MOST_PLANS = 200
VERSIONS = "versions"  # folder beside the plans; one folder for each plan, one file for each version


class OwnPlan(NamedTuple):
    """An entry of the list of own floor plans."""

    name: str
    title: str
    version: int


class OwnPlans:
    """Saves, replaces, deletes and restores floor plans in a folder; nothing that was saved is ever lost."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._one_at_a_time = Lock()  # two people may save at the same time, in threads of the web process

    def listed(self) -> list[OwnPlan]:
        """Return the plans by name; one that cannot be used, which opening it says, has its name as its title."""
        plans = []
        for file in sorted(self._folder.glob("*.json")):
            title = file.stem
            with suppress(ValueError):
                title = load_floorplan(file).title
            plans.append(OwnPlan(file.stem, title, self.version(file.stem)))
        return plans

    def version(self, name: str) -> int:
        """Return the number of a plan's current version; of a deleted plan, of its last one."""
        versions = self._version_files(name)
        file = self._file(name)
        # A file that was written by another program counts as a version that is not stored yet.
        foreign = file.is_file() and (not versions or versions[-1].read_bytes() != file.read_bytes())
        return len(versions) + foreign

    def add(self, plan: FloorPlan, same_name: SameName, shelf: ReplacedFiles) -> OwnPlan:
        """Save a plan; one that it replaces goes on the shelf. NameTaken when the name is taken and nobody chose."""
        with self._one_at_a_time:
            if is_bundled(plan.name):
                raise Conflict(Text("store-plan-name-bundled", name=plan.name))
            taken = [file.stem for file in self._folder.glob("*.json")]
            name = name_for(plan.name, taken, same_name)
            if name not in taken and len(taken) >= MOST_PLANS:
                raise Conflict(Text("store-plans-most", most=MOST_PLANS))
            shelf.shelve("floorplan", self._file(name))
            saved = plan.model_copy(update={"name": name})
            return OwnPlan(name, saved.title, self._save(saved))

    def replace(self, plan: FloorPlan, version: int) -> int:
        """Save the next version of a plan that is at `version`; Conflict when somebody saved it meanwhile."""
        with self._one_at_a_time:
            if is_bundled(plan.name):
                raise Conflict(Text("store-plan-bundled-kept"))
            self._needed(plan.name)
            if self.version(plan.name) != version:
                raise Conflict(Text("store-plan-saved-meanwhile"))
            return self._save(plan)

    def remove(self, name: str) -> None:
        """Delete a plan; its versions stay."""
        with self._one_at_a_time:
            if is_bundled(name):
                raise Conflict(Text("store-plan-bundled-not-deleted"))
            self._needed(name)
            self._store_version(name)
            self._file(name).unlink()

    def restore(self, name: str) -> int:
        """Restore a deleted plan, and return its version."""
        with self._one_at_a_time:
            versions = self._version_files(name)
            if self._file(name).is_file() or not versions:
                raise NotFound(Text("store-no-deleted-plan", name=name))
            write_atomically(self._file(name), versions[-1].read_bytes())
            return len(versions)

    def _save(self, plan: FloorPlan) -> int:
        self._store_version(plan.name)
        content = plan.model_dump_json(exclude_none=True).encode() + b"\n"
        versions = self._version_files(plan.name)
        if not versions or versions[-1].read_bytes() != content:
            write_atomically(self._versions(plan.name) / f"{len(versions) + 1:06d}.json", content)
        write_atomically(self._file(plan.name), content)
        return len(self._version_files(plan.name))

    def _store_version(self, name: str) -> None:
        """Store the current file as a version, if it is not stored yet."""
        file, number = self._file(name), self.version(name)
        if number > len(self._version_files(name)):
            write_atomically(self._versions(name) / f"{number:06d}.json", file.read_bytes())

    def _needed(self, name: str) -> None:
        if not self._file(name).is_file():
            raise NotFound(Text("store-no-plan", name=name))

    def _file(self, name: str) -> Path:
        return self._folder / f"{name}.json"

    def _versions(self, name: str) -> Path:
        return self._folder / VERSIONS / name

    def _version_files(self, name: str) -> list[Path]:
        return sorted(self._versions(name).glob("*.json"))


def is_bundled(name: str) -> bool:
    """Return whether a name belongs to a bundled building, or to a bundled scene at one of its levels."""
    plain = name.lower()
    return plain in map(str.lower, bundled_floorplans()) or plain.partition(".")[0] in map(str.lower, bundled_scenes())
