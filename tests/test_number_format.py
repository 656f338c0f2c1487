"""Numbers as people read them: shares and changes."""

from app.number_format import percent, signed_percent


def test_a_share_has_a_space_before_its_sign() -> None:
    assert (percent(0.784), percent(0.784, 1), percent(0.0)) == ("78 %", "78.4 %", "0 %")


def test_a_change_has_its_sign() -> None:
    assert (signed_percent(0.05), signed_percent(-0.251), signed_percent(0.0)) == ("+5 %", "−25 %", "+0 %")
