"""What every test has: generated cases without a deadline, a umask of its own; on request a database and more."""

import gc
import os
import shutil
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from clinic_rows import ClinicRows
from hypothesis import settings
from sqlalchemy.orm import Session
from store.shared_statements import share_statements

from app.calibration.profile import CalibrationProfile
from app.process.ring import TickRing
from app.store.database import Database
from building import make_ring
from small_profile import small_profile

gc.disable()  # until all tests are collected: what is imported stays
os.environ["LC_ALL"] = "C.UTF-8"  # the command line writes English, whatever the language of the terminal is
settings.register_profile("bodydrive", deadline=None, derandomize=os.environ.get("CI") == "true")
settings.load_profile("bodydrive")
share_statements()

# Side by side, what takes longest is begun first, so that no process of the tests waits for another at the end.
LONGEST = (
    *("test_axe", "test_way", "test_chair_page", "test_story", "test_drawn_plan", "test_calibrate_page"),
    *("test_without_program", "test_view", "test_layout", "test_keyboard", "test_live_words", "test_people_page"),
    *("test_short_losses", "test_removed_features", "test_stoppable", "test_study_sessions", "test_words_told"),
    *("test_drills_short", "test_odd_equipment", "test_upload_bombs", "test_backup_killed", "test_upgrade"),
)


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    if hasattr(config, "workerinput"):  # one of several processes
        items.sort(key=lambda item: LONGEST.index(item.path.stem) if item.path.stem in LONGEST else len(LONGEST))


def pytest_collection_finish() -> None:
    """Let garbage be looked for among what the tests make: the millions of objects that are there now stay anyway."""
    gc.collect()
    gc.freeze()
    gc.enable()


@pytest.fixture(autouse=True)
def _umask() -> Iterator[None]:
    """Take back what a command that ran within the test has set for files that are made after it."""
    before = os.umask(0o022)
    os.umask(before)
    yield
    os.umask(before)


@pytest.fixture(scope="session")
def new_database(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of a database that nobody used yet: its file and the head of its log, both closed."""
    folder = tmp_path_factory.mktemp("new-database")
    Database(folder / "clinic.sqlite").close()
    return folder


@pytest.fixture
def database(new_database: Path, tmp_path: Path) -> Iterator[Database]:
    shutil.copytree(new_database, tmp_path, dirs_exist_ok=True)
    opened = Database(tmp_path / "clinic.sqlite")
    yield opened
    opened.close()


@pytest.fixture
def db(database: Database) -> Iterator[Session]:
    with database.transaction() as session:
        yield session


@pytest.fixture
def rows(db: Session) -> ClinicRows:
    """Return the builder of a clinic's rows."""
    return ClinicRows(db)


@pytest.fixture
def ring() -> Iterator[TickRing]:
    made = make_ring()
    yield made
    made.close()


@pytest.fixture
def profile() -> CalibrationProfile:
    return small_profile()


@pytest.fixture
def bodydrive(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> Callable[..., tuple[Any, str, str]]:
    """Return a function that runs a command line in `tmp_path` and returns exit code, stdout and stderr."""
    monkeypatch.chdir(tmp_path)

    from app.cli.main import main

    def run(*words: object) -> tuple[Any, str, str]:
        monkeypatch.setattr(sys, "argv", ["bodydrive", *map(str, words)])
        code: Any = 0
        try:
            main()
        except SystemExit as ended:
            code = ended.code
        said = capsys.readouterr()
        return code, said.out, said.err

    return run
