"""Names of columns: no two are equal."""

from hypothesis import given
from hypothesis import strategies as st

from app.signals.column_names import unique_names


def test_a_name_that_was_there_before_has_a_number_behind():
    assert unique_names(["EMG", "t", "EMG", "EMG"]) == ["EMG", "t", "EMG (2)", "EMG (3)"]
    assert unique_names(["EMG", "EMG", "EMG (2)"]) == ["EMG", "EMG (2)", "EMG (2) (2)"]
    assert unique_names(["EMG (2)", "EMG", "EMG"]) == ["EMG (2)", "EMG", "EMG (3)"]


@given(st.lists(st.sampled_from(["a", "a (2)", "a (3)", "a (2) (2)", "b"])))
def test_no_two_are_equal_and_those_that_differ_begin_as_they_did(names):
    found = unique_names(names)
    assert len(set(found)) == len(found) == len(names)
    assert all(own.startswith(name) for own, name in zip(found, names, strict=True))
