"""Numbers as people read them: shares, changes, and counts with their nouns."""

from app.number_format import amount, percent, signed_percent


def test_a_share_has_a_space_before_its_sign() -> None:
    assert (percent(0.784), percent(0.784, 1), percent(0.0)) == ("78 %", "78.4 %", "0 %")


def test_a_change_has_its_sign() -> None:
    assert (signed_percent(0.05), signed_percent(-0.251), signed_percent(0.0)) == ("+5 %", "−25 %", "+0 %")


def test_one_of_a_thing_has_the_noun_of_one() -> None:
    assert (amount(1, "trial"), amount(0, "trial"), amount(2, "test is", "tests are")) == (
        "1 trial",
        "0 trials",
        "2 tests are",
    )
