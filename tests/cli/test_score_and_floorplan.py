"""The commands `score` and `floorplan import`; other units and the wrong way are refused or said."""

import json

import ezdxf
import numpy as np
import pytest
from cli.answers import assert_refused, output_of
from cli.symbols import symbols_in
from PIL import Image

from app.cli.errors import InputError
from app.cli.score import FOLLOWING, score_files
from app.world.floorplan import load_floorplan
from folders import SHARED

CASES = SHARED / "data" / "cases"


@pytest.fixture
def tables(tmp_path):
    x = np.linspace(0, 10, 1001)
    driven = np.column_stack([x / 0.5, x, np.full_like(x, 0.5)])
    np.savetxt(tmp_path / "driven.csv", driven, delimiter=",", header="t,x,y", comments="")
    (tmp_path / "path.csv").write_text("x,y\n0,0\n10,0\n")
    (tmp_path / "point.csv").write_text("x,y\n3,3\n")
    (tmp_path / "back.csv").write_text("t,x,y\n0,0,0\n2,1,0\n1,2,0\n")
    return tmp_path


@pytest.fixture
def map_file(tmp_path):
    pixels = np.zeros((100, 200), np.uint8)
    pixels[10:90, 10:190] = 254
    Image.fromarray(pixels).save(tmp_path / "hall.pgm")
    (tmp_path / "hall.yaml").write_text("image: hall.pgm\nresolution: 0.05\norigin: [0, 0, 0]\n")
    return "hall.yaml"


def test_score_prints_one_object(bodydrive, tables):
    measures = json.loads(output_of(bodydrive("score", "driven.csv", "path.csv", "--json")))
    assert list(measures) == [
        *("dist", "path_length", "dist_ratio", "e_diff", "cross_track_rms", "cross_track_max", "cross_track_mean"),
        *("time", "mean_speed", "stops", "sparc", "ldlj", "reached"),
    ]
    assert measures["e_diff"] == pytest.approx(5)
    assert measures["reached"] is True


def test_the_goals_radius_can_be_set(bodydrive, tables):
    _, out, _ = bodydrive("score", "driven.csv", "path.csv", "--goal-radius", "0.4", "--json")
    assert json.loads(out)["reached"] is False


def test_score_in_words(bodydrive, tables):
    out = output_of(bodydrive("score", "driven.csv", "path.csv"))
    assert "Area off the path                            5.000 m²" in out
    assert symbols_in(out) == []


def test_loops_in_opposite_directions_cancel_in_the_area_which_is_said_beside_it(bodydrive, tables):
    turn = np.linspace(0, 2 * np.pi, 60)
    loop = np.column_stack([10 + np.sin(turn), 1 - np.cos(turn)])
    legs = [np.column_stack([np.linspace(a, b, 60), np.zeros(60)]) for a, b in ((0, 10), (10, 20))]
    sizes = {}
    for name, loops in (("none", []), ("same", [loop, loop]), ("opposite", [loop, loop[::-1]])):
        places = np.concatenate([legs[0], *loops, legs[1]])
        rows = "".join(f"{number / 20},{x},{y}\n" for number, (x, y) in enumerate(places))
        (tables / "loops.csv").write_text(f"t,x,y\n{rows}")
        (tables / "line.csv").write_text("x,y\n0,0\n20,0\n")
        measures = json.loads(bodydrive("score", "loops.csv", "line.csv", "--json")[1])
        sizes[name] = measures["e_diff"], measures["dist"]
        assert "in opposite directions cancel in the area" in bodydrive("score", "loops.csv", "line.csv")[1]
    assert [area for area, _ in sizes.values()] == pytest.approx([0, 2 * np.pi, 0], abs=0.05)
    assert [driven for _, driven in sizes.values()] == pytest.approx([20, 20 + 4 * np.pi, 20 + 4 * np.pi], abs=0.1)


def test_columns_of_controls_and_contacts_give_more(bodydrive, tables):
    (tables / "more.csv").write_text("t,x,y,u1,u2,in_contact,extra\n0,0,0,1,0,0,a\n10,5,0,0,1,1,b\n20,10,0,0,-1,0,c\n")
    measures = json.loads(bodydrive("score", "more.csv", "path.csv", "--json")[1])
    assert (measures["collisions"], measures["contact_time"], measures["turn_reversals"]) == (1, 10, 1)
    assert measures["pulses_per_metre"] == pytest.approx(0.3)


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (("none.csv", "path.csv"), "none.csv: there is no such file"),
        (("driven.csv", "none.csv"), "none.csv: there is no such file"),
        (("path.csv", "path.csv"), "path.csv: there is no column 't'"),
        (("driven.csv", "point.csv"), "point.csv: a line needs at least two different points"),
        (("back.csv", "path.csv"), "back.csv: t goes backwards in row 3"),
        (("driven.csv", "path.csv", "--goal-radius", "nan"), "--goal-radius nan"),
        (("driven.csv", "path.csv", "--goal-radius", "-1"), "--goal-radius -1"),
    ],
)
def test_score_refuses_in_one_sentence(bodydrive, tables, words, sentence):
    assert_refused(bodydrive("score", *words), sentence)


def test_a_map_becomes_a_plan(bodydrive, tmp_path, map_file):
    words = ("--out", "plans/hall.json", "--title", "Hall", "--json")
    summary = json.loads(output_of(bodydrive("floorplan", "import", map_file, *words)))
    assert (summary["name"], summary["title"], summary["walls"]) == ("hall", "Hall", 4)
    plan = json.loads((tmp_path / "plans" / "hall.json").read_text())
    assert plan["title"] == "Hall"
    assert [file.name for file in (tmp_path / "plans").iterdir()] == ["hall.json"]


def test_a_drawing_and_a_picture_become_plans(bodydrive, tmp_path):
    document = ezdxf.new()
    document.modelspace().add_lwpolyline([(0, 0), (8, 0), (8, 6), (0, 6)], close=True)
    document.header["$INSUNITS"] = 0
    document.saveas(tmp_path / "room.dxf")
    pixels = np.full((100, 200), 255, np.uint8)
    pixels[5:95, 5:195] = 0
    pixels[10:90, 10:190] = 255
    Image.fromarray(pixels).save(tmp_path / "room.png")
    for words, length in (
        ("room.dxf --unit m", 8),
        ("room.png --metres-per-pixel 0.05", 9),
        ("room.png --width 10", 9),
    ):
        out = output_of(bodydrive("floorplan", "import", *words.split(), "--out", "room.json", "--json"))
        assert json.loads(out)["walls"] == 4
        plan = load_floorplan(tmp_path / "room.json")
        assert plan.bounds[2] - plan.bounds[0] == pytest.approx(length, abs=0.11)
    for words, sentence in (
        ("room.dxf", "room.dxf: this drawing does not say in which unit"),
        ("room.dxf --unit yard", "the options, unit"),
        ("room.dxf --unit m --layer DOORS", "room.dxf: there is no layer 'DOORS'"),
        ("room.png", "room.png: a picture has no scale"),
        ("room.png --width nan", "the options, width"),
        ("room.txt", "room.txt: this is no .yaml"),
    ):
        assert_refused(bodydrive("floorplan", "import", *words.split(), "--out", "other.json"), sentence)
    assert not (tmp_path / "other.json").exists()


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (("none.yaml", "--out", "plan.json"), "none.yaml: there is no such file"),
        (("hall.yaml", "--out", "plan.yaml"), "must end in .json"),
        (("hall.yaml", "--out", "hall.pgm/plan.json"), "cannot be written"),
        (("hall.yaml", "--out", "plan.json", "--name", "../plan"), "name"),
        (("hall.pgm", "--out", "plan.json"), "hall.pgm"),
    ],
)
def test_import_refuses_in_one_sentence_and_writes_nothing(bodydrive, tmp_path, map_file, words, sentence):
    before = sorted(tmp_path.iterdir())
    assert_refused(bodydrive("floorplan", "import", *words), sentence)
    assert sorted(tmp_path.iterdir()) == before


def test_list_names_the_bundled_plans(bodydrive):
    listed = json.loads(bodydrive("floorplan", "list", "--json")[1])["floorplans"]
    names = [plan["name"] for plan in listed]
    assert names[-3:] == ["apartment", "clinic", "corridors"]
    assert {"desert.easy", "obstacles.hard", "building.easy"} <= set(names)
    assert {path["task"] for plan in listed for path in plan["paths"]} == {"path", "follow", "turn", "back", "course"}
    assert "clinic: Clinic storey" in bodydrive("floorplan", "list")[1]


def test_a_plan_or_scene_is_checked(bodydrive, tmp_path):
    file = tmp_path / "mine.json"
    scene = {"name": "mine", "title": "Mine", "about": "Mine.", "levels": [{"name": "easy", "title": "Easy"}]}
    path = {"name": "main", "title": "Main", "points": [[0, 0], [{"easy": 4}, 0]], "instruction": "Go."}
    file.write_text(json.dumps({**scene, "paths": [path]}))
    assert bodydrive("floorplan", "check", str(file)) == (0, f"{file}: fine (mine.easy)\n", "")
    path["points"] = [[0, 0], [{"easy": "far"}, 0]]
    file.write_text(json.dumps({**scene, "paths": [path]}))
    code, _, words = bodydrive("floorplan", "check", str(file))
    assert code != 0
    assert f"{file}, level easy, paths[0].points[1][0]: " in words


@pytest.fixture
def scored(tmp_path):
    def measures(t, x):
        rows = "\n".join(f"{a},{b},0" for a, b in zip(t, x, strict=True))
        (tmp_path / "driven.csv").write_text(f"t,x,y\n{rows}\n")
        (tmp_path / "path.csv").write_text("x,y\n0,0\n10,0\n")
        return score_files(tmp_path / "driven.csv", tmp_path / "path.csv", 0.5)

    return measures


T, X = np.linspace(0, 20, 401), np.linspace(0, 10, 401)


def test_the_wrong_way_has_no_measures_of_following(scored):
    measures = scored(T, X[::-1])
    assert not measures["reached"]
    assert [measures[name] for name in FOLLOWING] == [None] * len(FOLLOWING)
    assert measures["dist"] == pytest.approx(10)


@pytest.mark.parametrize("end", [1.0, 0.6])
def test_the_right_way_has_them_whether_or_not_it_reaches_the_goal(scored, end):
    measures = scored(T, X * end)
    assert measures["reached"] == (end == 1.0)
    assert measures["e_diff"] == pytest.approx(0, abs=1e-6)


@pytest.mark.parametrize(
    ("t", "x", "words"),
    [
        (T * 1000, X, "give t in seconds, not in milliseconds"),
        (np.arange(401) * 1.0, X / 4, "its mean speed is 0.0063 m/s with rows 1 s apart: give t in seconds"),
        (T, X * 1000, "give x and y in metres"),
    ],
)
def test_times_in_milliseconds_and_places_in_millimetres_are_refused(scored, t, x, words):
    with pytest.raises(InputError, match=words):
        scored(t, x)


@pytest.mark.skipif(not CASES.is_dir(), reason="the files of other laboratories are not here")
def test_the_trajectories_that_were_seen():
    path = CASES / "score-path.csv"
    with pytest.raises(InputError, match="give t in seconds"):
        score_files(CASES / "score-ms.csv", path, 0.5)
    wrong = score_files(CASES / "score-wrong-way.csv", path, 0.5)
    assert wrong["reached"] is False
    assert [wrong[name] for name in FOLLOWING] == [None] * len(FOLLOWING)
    loops = score_files(CASES / "score-two-loops-opposite.csv", path, 0.5)
    assert loops["e_diff"] == pytest.approx(0, abs=1e-6)  # as the command says: opposite loops cancel
    assert loops["dist"] == pytest.approx(10 + 4 * np.pi, abs=0.01)


@pytest.mark.parametrize(
    ("header", "row"),
    [
        (",Time (ms),x,y,", "{i},{ms:.0f},{x},0,"),
        ("timestamp_us;x [m];y [m]", "{us:.0f};{x};0"),
        ("# seconds\tx\ty", "{s}\t{x}\t0"),
    ],
)
def test_a_trajectory_of_another_program_is_read(tmp_path, header, row):
    rows = [row.format(i=i, s=t, ms=t * 1e3, us=t * 1e6, x=x) for i, (t, x) in enumerate(zip(T, X, strict=True))]
    (tmp_path / "driven.csv").write_text("\n".join([header, *rows]) + "\n")
    (tmp_path / "path.csv").write_text("x,y\n0,0\n10,0\n")
    measures = score_files(tmp_path / "driven.csv", tmp_path / "path.csv", 0.5)
    assert (measures["time"], measures["reached"]) == (pytest.approx(20), True)
