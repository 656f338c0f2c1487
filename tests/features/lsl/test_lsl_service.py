"""The streams of LSL begin and end with the program, where that was chosen, and name what the session has."""

import asyncio
import sys
from types import SimpleNamespace

import pytest
from api.fake_clinic import until
from fake_clock import FakeClock
from features.lsl.lsl_ring import Names, Ring, described
from hardware.shirt.fake_lsl import FakeLsl

from app import features
from app.cues import Cue
from app.features.lsl import service
from app.features.lsl.service import LslOutlets


def outlets(is_chosen, load):
    return LslOutlets(Ring(), Names(), is_chosen=is_chosen, clock=FakeClock(), load=load)


def run_for_a_moment(part):
    async def run():
        part.start()
        await asyncio.sleep(0)
        await part.close()

    asyncio.run(run())


def test_nothing_is_loaded_unless_it_was_chosen():
    def load():
        raise AssertionError("loaded")

    run_for_a_moment(outlets(False, load))


def test_it_begins_and_ends_with_the_program_and_a_missing_library_is_logged(caplog):
    lsl = FakeLsl(FakeClock())
    run_for_a_moment(outlets(True, lambda: lsl))
    assert {outlet.info.type() for outlet in lsl.outlets} >= {"Control", "Markers"}

    def missing():
        raise RuntimeError("no liblsl")

    run_for_a_moment(outlets(True, missing))
    assert "Nothing is sent over LSL" in caplog.text


@pytest.mark.parametrize("missing", ["library", "feature"])
def test_serve_refuses_in_one_sentence_what_it_cannot_send(bodydrive, monkeypatch, missing):
    if missing == "library":
        monkeypatch.setitem(sys.modules, "pylsl", None)
    else:
        monkeypatch.setattr(features, "NEEDS", {name: needs for name, needs in features.NEEDS.items() if name != "lsl"})
    code, _, said = bodydrive("serve", "--lsl", "--state", "clinic")
    assert code == 2
    assert said == (
        "bodydrive: LSL is not installed completely: install the packages pylsl and liblsl, then try again\n"
    )


@pytest.fixture
def received(settings, monkeypatch):
    """Return what a clinic sends that was started with `--lsl`."""
    lsl = FakeLsl(FakeClock())
    monkeypatch.setattr(service, "load_lsl", lambda: lsl)
    object.__setattr__(settings, "lsl", True)
    return lsl


def test_a_trial_of_the_running_program_is_marked_with_its_id(received, calibrated):
    def marked(what):
        sent = [outlet.sent for outlet in received.outlets if outlet.info.type() == "Markers"]
        return [row[0] for _, row in sent[0] if row[0].startswith(what)]

    calibrated.start_trial()
    until(lambda: marked("start trial"))
    trial = calibrated.end_trial()
    until(lambda: marked("end trial"))
    assert marked("start trial") == [f"start trial {trial['id']}"]
    assert marked("end trial") == [f"end trial {trial['id']}"]
    (gestures,) = [outlet.info for outlet in received.outlets if outlet.info.type() == "Gestures"]
    assert ("activation.right_elbow", "1") in described(gestures)


def test_runs_and_gestures_have_the_names_of_the_session():
    from app.features.lsl.feature import SessionNames
    from app.session.open_session import SessionFlow
    from app.session.real_drive import RealDriveFlow
    from app.session.runs import SessionRuns
    from app.session.trial import TrialFlow

    run = SimpleNamespace(number=3, kind="drive", cues=(Cue(start=0.0, end=1.0, kind="rest"),))
    nobody = SimpleNamespace(current=None)
    runs, trials, session = SimpleNamespace(open=run), SimpleNamespace(current=None), SimpleNamespace(loaded=None)
    names = SessionNames({SessionRuns: runs, TrialFlow: trials, RealDriveFlow: nobody, SessionFlow: session})
    assert names.name_of(3) is None, "a drive run has its name once the trial is there"
    trials.current = SimpleNamespace(id=12, run=run)
    assert (names.name_of(3), names.name_of(4)) == ("trial 12", None)
    assert (names.cue_of(3, 0), names.cue_of(3, 1), names.cue_of(4, 0)) == (run.cues[0], None, None)
    runs.open, trials.current = SimpleNamespace(number=5, kind="rest", cues=()), None
    assert names.name_of(5) == "recording rest"
    assert names.gestures() == []
    session.loaded = SimpleNamespace(gestures=[SimpleNamespace(name="nod")])
    assert names.gestures() == ["nod"]
