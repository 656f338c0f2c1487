"""The driver of docs/drivers.md, as it stands there: registered, on the page, and read by the loop for a minute."""

import os
import pty
import re
import sys
import tty
from collections.abc import Iterator
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from select import select
from types import ModuleType

import numpy as np
import pytest
from fake_clock import FakeClock
from hardware.shirt.shirts import small_layout

from app.api.routes.equipment import shirt_kind_view
from app.hardware.base import HardwareError
from app.hardware.configs import SHIRTS
from app.hardware.registry import make_shirt, parse_shirt
from app.hardware.shirt.kind import NO_CABLE
from app.pipeline.loop import ControlLoop
from app.pipeline.opening import reason
from app.pipeline.setup import Setup
from app.process.ring import TickRing
from folders import ROOT

PAGE = (ROOT / "docs" / "drivers.md").read_text(encoding="utf-8")
EXAMPLE = PAGE.split("```python\n")[1].split("```")[0]
RATE = 50  # Hz
MINUTE = 60 * RATE  # frames


@pytest.fixture
def lines(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    """The module of the page, registered."""
    file = tmp_path / "lines.py"
    file.write_text(EXAMPLE, encoding="utf-8")
    spec = spec_from_file_location("example_of_a_driver", file)
    assert spec is not None
    assert spec.loader is not None
    module = module_from_spec(spec)
    monkeypatch.setitem(sys.modules, spec.name, module)
    spec.loader.exec_module(module)
    monkeypatch.setitem(SHIRTS, module.KIND.name, module.KIND)
    return module


@pytest.fixture
def line() -> Iterator[tuple[int, int]]:
    """Our end of a pseudo terminal, and the driver's end."""
    ours, theirs = pty.openpty()
    tty.setraw(theirs)
    yield ours, theirs
    os.close(ours)
    os.close(theirs)


def test_the_loop_reads_a_minute_of_frames(lines: ModuleType, line: tuple[int, int], ring: TickRing) -> None:
    ours, theirs = line
    device = os.ttyname(theirs)
    clock = FakeClock()
    setup = Setup(clock)
    layout = small_layout().model_dump(mode="json")
    change = setup.change_shirt(parse_shirt({"kind": "lines", "device": device, "layout": layout}))
    change.use(change.open())
    assert (setup.source.shirt, setup.source.simulated, setup.mistrust) == ("lines", False, NO_CABLE)
    assert setup.shirt_description == f"Shirt on {device}, 3 sensors."
    loop = ControlLoop(setup, ring, None, clock)
    sent = np.arange(3 * MINUTE, dtype=np.float32).reshape(MINUTE, 3) / 4
    for values in sent:
        os.write(ours, ",".join(f"{value:g}" for value in values).encode() + b"\r\n")
        clock.time += 1 / RATE
        assert select([theirs], [], [], 20.0)[0]
        loop.turn()
    ticks, _ = ring.since(0)
    assert (len(ticks), setup.shirt and setup.shirt.lost) == (MINUTE, 0)
    assert ticks["has_frame"].all()
    assert ticks["frame_seq"].tolist() == list(range(1, MINUTE + 1))
    np.testing.assert_allclose(ticks["t_device"], np.arange(1, MINUTE + 1) / RATE)
    np.testing.assert_array_equal(ticks["values"][:, :3], sent)
    setup.close()


def test_what_is_no_frame_is_counted_and_a_closed_shirt_waits(lines: ModuleType, line: tuple[int, int]) -> None:
    ours, theirs = line
    device = os.ttyname(theirs)
    clock = FakeClock()
    layout = small_layout().model_dump(mode="json")
    shirt = make_shirt(parse_shirt({"kind": "lines", "device": device, "layout": layout}), clock)
    assert shirt.read(0.5) is None
    assert (clock.now(), shirt.pending()) == (0.5, False)
    shirt.open()
    os.write(ours, b"1,2\nready\n" + 5000 * b"x" + b"\n7,8,9\n")
    frame = next(frame for _ in range(20) if (frame := shirt.read(1.0)) is not None)
    assert (frame.values.tolist(), shirt.lost) == ([7, 8, 9], 3)
    shirt.close()
    shirt.close()
    with pytest.raises(HardwareError, match="/dev/ttyNONE99 cannot be opened"):
        make_shirt(parse_shirt({"kind": "lines", "device": "/dev/ttyNONE99"}), clock).open()


def test_its_form_has_the_words_of_the_page(lines: ModuleType) -> None:
    view = shirt_kind_view(lines.KIND)
    assert (view.kind, view.simulated, view.network) == ("lines", False, False)
    assert (view.form["title"], view.form["in_use"]) == ("A shirt on a serial line", "Serial shirt on {device}")
    assert view.form["properties"]["sample_rate"]["title"] == "Frames a second"


def test_a_missing_library_is_a_sentence(lines: ModuleType, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "serial", None)
    with pytest.raises(ModuleNotFoundError) as missing:
        make_shirt(parse_shirt({"kind": "lines"}), FakeClock()).open()
    assert str(reason(missing.value, "shirt")).startswith(
        "The shirt needs the library 'serial', which is not installed"
    )


def test_the_page_counts_the_lines_and_names_every_format() -> None:
    code = [row for row in EXAMPLE.splitlines()[1:] if row.strip() and not re.match(r"(from|import) ", row)]
    assert len(code) == 40
    fields = (ROOT / "web_static/js/pages/shirt/config_fields.js").read_text(encoding="utf-8")
    formats = re.findall(r'^  "?([a-z-]+)"?[:,]', fields.split("const OF_FORMAT = {")[1].split("};")[0], re.MULTILINE)
    types = {"signal-file": "SignalFile", "shirt-key": "ShirtKey", "layout": "LayoutFile"}
    assert [name for name in formats if f"| `{types.get(name, f'format` `{name}')}` |" not in PAGE] == []
    assert len(formats) == 7
