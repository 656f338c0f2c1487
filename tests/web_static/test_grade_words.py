"""A signal and a repetition have the same word on the pages as in the sentences of the server."""

from app.calibration.grades import SIGNAL_TO_NOISE_LIMITS, SPREAD_LIMITS, repeats_word, signal_word

NEAR = 1e-6


def test_the_pages_and_the_server_have_the_same_words(answered, reference_file):
    signals = [value for limit in SIGNAL_TO_NOISE_LIMITS for value in (limit - NEAR, limit, limit + NEAR)]
    spreads = [value for limit in SPREAD_LIMITS for value in (limit - NEAR, limit, limit + NEAR)]
    words = answered("grade_words.mjs", {"signals": signals, "spreads": spreads}, reference_file)
    assert words == [[signal_word(value) for value in signals], [repeats_word(value) for value in spreads]]
