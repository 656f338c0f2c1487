"""Codes for the patient's screen are short enough to type, and read as people type them."""

from hypothesis import given
from hypothesis import strategies as st

from app.session.screen_codes import CODE_LENGTH, LETTERS, PairingCodes, as_typed

CODES = st.text(LETTERS, min_size=CODE_LENGTH, max_size=CODE_LENGTH)
# What people write for a letter; what looks like another letter is none of the alphabet.
WRITTEN = {"0": "0oO", "1": "1iIlL"}


@given(CODES, st.data())
def test_a_code_is_read_however_it_is_typed(code: str, data: st.DataObject) -> None:
    typed = ""
    for letter in code:
        typed += data.draw(st.sampled_from(["", " ", "-"]))
        typed += data.draw(st.sampled_from(WRITTEN.get(letter, letter + letter.lower())))
    assert as_typed(typed) == code


@given(st.text(max_size=200))
def test_any_text_is_read_without_an_error(text: str) -> None:
    assert as_typed(as_typed(text)) == as_typed(text)


def test_codes_use_every_letter_and_differ() -> None:
    codes = PairingCodes()
    made = [codes.offer(1, "Ada").code for _ in range(500)]
    assert len(set(made)) == len(made)
    assert set("".join(made)) == set(LETTERS)
    assert {len(code) for code in made} == {CODE_LENGTH}
