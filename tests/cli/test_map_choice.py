"""`bodydrive calibrate --map`: which map decodes, and the sentence where a map is missing."""

import json

import numpy as np
import pytest
from cli.answers import invoke
from cli.symbols import symbols_in

from app.calibration.linear_map import LinearMap, MapCheck
from app.calibration.profile import CalibrationProfile
from app.cli.calibration.calibrate import checks, choose, comparison
from app.cli.decode import read_parameters
from app.cli.errors import InputError
from app.layout import Channel, Joint, ShirtLayout
from building import make_profile

GOOD = MapCheck(in_phase=0.97, hit_rate=0.8, false_per_minute=0.0, false_count=0)
POOR = MapCheck(in_phase=0.85, hit_rate=0.8, false_per_minute=3.0, false_count=1)
REASON = "Nothing is learnt from 1 prompted repetition: prompt at least 3."


def guided(pca, own):
    return LinearMap(rates=((0.1, 0.1),), dead_zone=0.3, full=1.5, lag=0.3, repetitions=3, pca_check=pca, check=own)


@pytest.fixture
def profile():
    """Right elbow: better guided; left elbow: worse; the shoulders have no guided map."""
    profile = make_profile(n_channels=8)
    candidates = (guided(POOR, GOOD), guided(GOOD, POOR), None, None)
    joints = [joint.model_copy(update={"guided": g}) for joint, g in zip(profile.joints, candidates, strict=True)]
    return profile.model_copy(update={"joints": tuple(joints)})


REASONS = {"right_shoulder": REASON, "left_shoulder": REASON}


@pytest.mark.parametrize(
    ("chosen", "maps", "sentences"),
    [
        ("pca", ["pca"] * 4, 0),
        ("best", ["guided", "pca", "pca", "pca"], 0),
        ("guided", ["guided", "guided", "pca", "pca"], 3),
    ],
)
def test_each_joint_gets_what_was_asked_for_where_it_can_be_had(profile, chosen, maps, sentences):
    taken, words = choose(profile, chosen, REASONS)
    assert [joint.map for joint in taken.joints] == maps
    assert len(words) == sentences
    for sentence in map(str, words):
        assert "not better" in sentence or "keeps the standard calibration" in sentence


def test_without_any_guided_map_guided_is_refused(profile):
    plain = make_profile(n_channels=8)
    with pytest.raises(InputError, match=r"--map guided, right_elbow: Nothing is learnt from"):
        choose(plain, "guided", {"right_elbow": REASON})


def test_both_figures_are_shown(profile):
    assert checks(profile.joints[0], REASONS)["offered"] is True
    assert checks(profile.joints[2], REASONS) == {"map": "pca", "offered": False, "reason": REASON}
    table = "\n".join(comparison(profile, REASONS))
    for words in ("85.0 %", "97.0 %", "3.0", "yes", "no", f"left_shoulder: {REASON}"):
        assert words in table
    assert symbols_in(table) == []


@pytest.fixture
def files(tmp_path):
    """Four movements of one joint, felt by two channels, with prompts that lead by 0.3 s."""
    rng = np.random.default_rng(1)
    t = np.arange(3000) / 100
    angle = np.zeros(3000)
    starts = (3.0, 9.0, 15.0, 21.0)
    for start in starts:
        there, back = np.clip((t - start) / 0.8, 0, 1), np.clip((t - start - 0.9) / 1.2, 0, 1)
        angle += 0.5 * (np.cos(np.pi * back) - np.cos(np.pi * there))
    values = np.outer(angle, (1.0, -0.6)) + 0.004 * rng.normal(size=(3000, 2))
    header = "t,elbow_0,elbow_1"
    np.savetxt(tmp_path / "signals.csv", np.column_stack((t, values)), delimiter=",", header=header, comments="")
    rows = [f"{start - 0.3:g},{start + 0.5:g},elbow" for start in starts]
    (tmp_path / "prompts.csv").write_text("\n".join(["start,end,joint", *rows]) + "\n")
    layout = ShirtLayout(
        name="one elbow",
        channels=tuple(Channel(name=f"elbow_{i}", joint="elbow") for i in range(2)),
        joints=(Joint(name="elbow", label="Elbow"),),
    )
    (tmp_path / "layout.json").write_text(layout.model_dump_json())
    return tmp_path


def run(files, command, *words):
    return invoke(command, files / "signals.csv", *words)


def calibrated(files, *words):
    return run(files, "calibrate", "--layout", files / "layout.json", "--out", files / "profile.json", *words)


def test_the_profile_says_which_map_decodes_and_decode_does_so(files):
    prompts = ("--prompts", files / "prompts.csv")
    decoded = {}
    for kind in ("pca", "guided"):
        result = calibrated(files, *prompts, "--map", kind, "--json")
        assert result.exit_code == 0, result.output
        answer = json.loads(result.stdout)
        profile = CalibrationProfile.model_validate_json((files / "profile.json").read_bytes())
        assert answer["maps"]["elbow"]["map"] == profile.joints[0].map == kind
        assert answer["maps"]["elbow"]["repetitions"] == 4
        assert {"in_phase", "hit_rate", "false_per_minute"} <= set(answer["maps"]["elbow"]["pca_check"])
        assert answer["joints"]["elbow"]["dead_zone"] == profile.joints[0].thresholds[0]
        assert read_parameters(files / "profile.json").gestures[0].dead_zone == profile.joints[0].thresholds[0]
        result = run(files, "decode", "--profile", files / "profile.json", "--out", files / "out.csv")
        assert result.exit_code == 0, result.output
        decoded[kind] = np.genfromtxt(files / "out.csv", delimiter=",", names=True)
    assert np.abs(decoded["pca"]["elbow_rate"] - decoded["guided"]["elbow_rate"]).max() > 0.01
    np.testing.assert_allclose(decoded["pca"]["elbow_score"], decoded["guided"]["elbow_score"])
    moving = decoded["guided"]["elbow_activation"] > 0
    assert {round(t) for t in decoded["guided"]["t"][moving]} <= {3, 4, 9, 10, 15, 16, 21, 22}
    assert moving.sum() > 100


def test_without_prompts_there_is_no_guided_map_and_best_is_the_paper_s(files):
    refused = calibrated(files, "--map", "guided")
    assert refused.exit_code != 0
    assert isinstance(refused.exception, InputError) or "never prompted" in refused.output
    result = calibrated(files, "--map", "best")
    assert result.exit_code == 0
    assert "never prompted" in result.output
