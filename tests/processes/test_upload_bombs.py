"""Files that would need far more memory or time than their size: refused, not kept, and other requests do not wait."""

import os
from collections.abc import Iterator
from pathlib import Path

import psutil
import pytest
from drills.bomb_effects import MOST_GROWTH, memory, send_bomb
from drills.bombs import BOMBS, glb_with_pictures, png
from drills.results import Watcher
from processes.served_demo import Demo

# One for each library that reads what is uploaded; `make drills` sends all of them.
EACH_READER = (
    "a picture of 13,000 x 13,000 in a GLB",
    "a GLB with 9,000 copies of a million points",
    "a PNG of 30,000 x 30,000",
    "a map of 1,000 million cells",
    "a YAML document of 1,000 million words",
    "a DXF of 10,000 million lines",
    "a Parquet file of 100 million rows",
)
pytestmark = pytest.mark.xdist_group("upload bombs")  # one program for all of them
HELD_UP = 3.0  # s: a file that is unpacked by the event loop holds every answer up for longer


@pytest.fixture(scope="module")
def demo(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Demo]:
    with Demo.running(tmp_path_factory.mktemp("served")) as running:
        yield running


@pytest.fixture(scope="module")
def before(demo: Demo) -> int:
    demo.client.get("/models").raise_for_status()
    return memory(demo.process.pid, "VmRSS")


@pytest.fixture(scope="module")
def watcher() -> Iterator[Watcher]:
    made = Watcher()
    yield made
    made.close()


def kept(state: Path) -> list[Path]:
    return [file for part in ("models", "floorplans", "files", "replaced") for file in (state / part).rglob("*")]


@pytest.mark.parametrize(
    "name", [*EACH_READER, *(pytest.param(name, marks=pytest.mark.long) for name in BOMBS if name not in EACH_READER)]
)
def test_a_bomb_is_refused_and_nobody_waits(demo: Demo, before: int, watcher: Watcher, name: str) -> None:
    effect = send_bomb(demo, BOMBS[name](), watcher, before)
    assert effect.status in {413, 415, 422}
    assert effect.detail.endswith(".")
    assert str(demo.state) not in effect.detail
    assert effect.growth < MOST_GROWTH
    assert max(effect.answers) <= HELD_UP  # `make drills` has a limit of 0.2 s, on a quiet machine
    assert [file for file in kept(demo.state) if file.is_file()] == []


def test_an_object_that_an_older_version_stored_is_not_unpacked(demo: Demo, before: int) -> None:
    stored = demo.state / "models" / "old.glb"
    stored.parent.mkdir(exist_ok=True)
    stored.write_bytes(glb_with_pictures(png(13_000)))
    for _ in range(2):
        assert demo.client.get("/models").json() == []
    assert memory(demo.process.pid, "VmHWM") - before < MOST_GROWTH
    assert stored.exists()
    stored.unlink()


def test_no_reader_stays(demo: Demo) -> None:
    children = psutil.Process(demo.process.pid).children(recursive=True)
    assert [child for child in children if "app.isolated_reader" in child.cmdline()] == []
    assert os.path.exists(f"/proc/{demo.process.pid}")
