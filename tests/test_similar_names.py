"""Names that look alike are refused in a sentence; those of one script that differ are not."""

import pytest
from clinic_rows import ClinicRows
from hypothesis import given
from hypothesis import strategies as st

from app.refusals import Conflict
from app.similar_names import mixed_word, require_distinct, similar_name, skeleton
from app.store.files.name_conflicts import name_for


@pytest.mark.parametrize(
    ("first", "second"),
    [
        ("Ada", "\u0410da"),  # Cyrillic A
        ("Cop", "\u0421\u043e\u0440"),  # all Cyrillic
        ("P-1", "P-l"),
        ("P-10", "P-1O"),
        ("HEPA", "\u0397\u0395\u03a1\u0391"),  # Greek
        ("Ana", "\uff21na"),  # full width
        ("Ana B", "Ana  B"),
    ],
)
def test_names_that_look_alike_have_one_skeleton(first: str, second: str) -> None:
    assert similar_name(second, ["Zoe", first]) == first


@pytest.mark.parametrize("name", ["P\u0430ul", "\u0391da", "Ad\u0430-2"])
def test_a_word_of_two_scripts_is_refused(name: str) -> None:
    with pytest.raises(Conflict, match="of two scripts"):
        require_distinct(name, (), "names-code-taken")


@pytest.mark.parametrize(
    "name",
    ["Zo\u00eb", "\u0410\u043d\u043d\u0430 Smith", "\u5c71\u7530\u306f\u308b", "P-12", "O'Neill", "\uae40\ubbfc", "x2"],
)
def test_a_name_of_one_script_in_each_word_is_taken(name: str) -> None:
    assert mixed_word(name) is None
    require_distinct(name, ("Heron", "P-1", "P-2"), "names-code-taken")


def test_other_letters_and_marks_do_not_look_alike() -> None:
    assert similar_name("Zo\u00eb", ["Zoe", "L-1", "P-1"]) is None
    assert similar_name("1-1", ["L-1"]) is None


@given(st.text(max_size=30))
def test_a_name_looks_like_itself_and_nothing_is_raised(name: str) -> None:
    assert similar_name(name, [name]) == name
    assert skeleton(skeleton(name)) == skeleton(name)
    mixed_word(name)


def test_people_patients_and_files_are_told_apart(rows: ClinicRows) -> None:
    rows.person("Cop")
    rows.patient("P-1")
    with pytest.raises(Conflict, match=r"There is somebody called 'Cop' already, and '.*' looks the same"):
        rows.person("\u0421\u043e\u0440", "reviewer")
    with pytest.raises(Conflict, match="a patient of the code 'P-1' already"):
        rows.patient("P-l", "Wren")
    with pytest.raises(Conflict, match="of two scripts"):
        rows.patient("P-2", "W\u0433en")
    with pytest.raises(Conflict, match="looks the same"):
        name_for("walk-l.csv", ["walk-1.csv"], "ask")
    assert name_for("walk-l.csv", ["walk-1.csv"], "keep-both") == "walk-l.csv"
