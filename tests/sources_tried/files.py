"""Files of signals: brought to the machine on the Shirt page, replayed, and driven by."""

from contextlib import ExitStack

import numpy as np
from browser.driving import ends_by_hand, go_on_until, speed_in
from browser.tablets import go_to
from playwright.sync_api import Error, expect
from sources_tried.figures import Tried
from sources_tried.person import FLOORPLAN, PATH
from sources_tried.story import (
    LAMPS_WITHIN,
    Story,
    demonstration,
    good_lamps,
    is_scored,
    made,
    opened_browser,
    opened_page,
    opens_form,
    stop_words,
    uses,
)

from app.calibration.profile import CalibrationProfile
from app.calibration.vocabulary import standard_parameters
from app.cli.serve import profile_file
from app.hardware.body.person import SimulatedPerson
from app.study.participant import Participant
from app.study.simulated_trial import drive_trial
from app.world.scene import find_place

FAST = 0.1  # m/s
DRIVEN_WITHIN = 120  # s: twice the length of a recorded drive


def recorded_drive():
    """Return the layout of the simulated shirt, its rate (Hz), and the frames (n, n_channels) of a drive in it.

    The shirt and the body are those in which the patient of a demonstration was calibrated.
    """
    profile = CalibrationProfile.model_validate_json(profile_file().read_bytes())
    participant = Participant(SimulatedPerson("practised", 1), profile.layout, profile.sample_rate, 1)
    plan = find_place(FLOORPLAN)
    assert plan is not None
    frames = []
    drive_trial(1, participant, standard_parameters(profile), plan, plan.path_named(PATH), frames)
    return profile.layout, profile.sample_rate, np.array([values for values, _ in frames])


def write_csv(file, names, t, values):
    """Write signals as text."""
    numbers = np.column_stack((t, values))
    np.savetxt(file, numbers, fmt="%.5f", delimiter=",", header=",".join(("t", *names)), comments="")


def write_parquet(file, names, t, values):
    """Write signals as Parquet."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    columns = {"t": t, **dict(zip(names, values.T, strict=True))}
    pq.write_table(pa.table({name: np.ascontiguousarray(column) for name, column in columns.items()}), file)


FILES = {"csv": write_csv, "parquet": write_parquet}
"""What writes a file of each kind, by the end of its name."""


def try_file(playwright, kind, folder, photographs):
    """Bring a file of a kind to a demonstration, replay it, let it drive, and return what it came to."""
    tried, story = Tried(f"{kind} file"), None
    layout, rate, values = recorded_drive()
    file = made(folder / "files") / f"drive.{kind}"
    FILES[kind](file, layout.channel_names, np.arange(len(values)) / rate, values)
    layout_file = file.with_name("layout.json")
    layout_file.write_text(layout.model_dump_json(), encoding="utf-8")
    with ExitStack() as ends:
        browser = ends.enter_context(opened_browser(playwright, {}, made(folder / "browser")))
        link, _ = ends.enter_context(demonstration(made(folder / "demo"), {}))
        page, log = ends.enter_context(opened_page(browser, link))
        try:
            story = Story(page, link, tried.name.replace(" ", "-"), photographs)
            brings(story, file)
            uses(story, {"File": file.name, "Layout from a file": str(layout_file)})
            story.wait_until(lambda: good_lamps(story) == len(layout.channels), LAMPS_WITHIN, "the green lamps")
            tried.lamps = good_lamps(story)
            story.photograph("source")
            is_driven(story)
            is_scored(story, "Recorded signals, virtual chair: practice only.")
            log.assert_quiet()
        except (AssertionError, Error) as error:
            tried.stopped = stop_words(story, error)
        if story is not None:
            tried.taps = story.taps
    tried.came_to = "" if tried.stopped else "driven by the recording, ended by hand"
    return tried


def brings(story, file):
    """Choose the replay of a file on the Shirt page, and bring the file."""
    story.stage = "source"
    card = story.card
    story.tap_rail("shirt")
    opens_form(story, "Replay of a file")
    card.locator("input[type=file][accept*=csv]").set_input_files(file)
    story.taps += 1  # the button that opens the choice of a file
    expect(card.get_by_label("File", exact=True)).to_be_visible()


def is_driven(story):
    """Start a trial, wait until the recording drives the chair, and end the trial."""
    story.stage = "drive"
    page = story.page
    go_to(page, f"drive/task/{FLOORPLAN}/{PATH}")
    story.tap(page.get_by_role("button", name="Start trial"))
    speed = page.locator(".bar .speed .big")
    go_on_until(page, lambda: speed_in(speed.inner_text()) >= FAST, f"a speed of {FAST} m/s", seconds=DRIVEN_WITHIN)
    story.photograph("drive")
    ends_by_hand(page)
