import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.derived_results import DerivedResults


def test_a_result_is_derived_once():
    results, asked = DerivedResults(2), []
    assert [results.of("a", lambda: asked.append("a") or len(asked)) for _ in range(3)] == [1, 1, 1]


def test_a_result_may_be_none():
    results = DerivedResults(2)
    assert results.of("a", lambda: None) is None
    assert results.of("a", lambda: pytest.fail("derived again")) is None


def test_what_fails_is_derived_again():
    results = DerivedResults(2)
    with pytest.raises(ZeroDivisionError):
        results.of("a", lambda: 1 // 0)
    assert results.of("a", lambda: 5) == 5


def test_what_was_replaced_is_forgotten():
    results = DerivedResults(9)
    results.store({("a", 1): 1, ("a", 2): 2, ("b", 1): 3})
    results.forget(lambda key: key[0] == "a")
    assert results.find([("a", 1), ("a", 2), ("b", 1)]) == {("b", 1): 3}


@given(st.lists(st.integers(0, 6), max_size=40), st.integers(1, 4))
def test_those_that_were_used_last_are_known(keys, most):
    results, used = DerivedResults(most), []
    for key in keys:
        assert results.of(key, lambda key=key: key) == key
        used = [*(one for one in used if one != key), key][-most:]
    assert sorted(results.find(range(7))) == sorted(used)
