"""The ranking of `calibrate --gestures`, as a table for people."""

from app.calibration.gestures.discovery import Discovery
from app.calibration.gestures.numbers import FoundGesture
from app.calibration.grades import repeats_word, signal_word
from app.number_words import percent

HEAD = ("score", "signal", "repeats", "along", "effort", "false/min", "answered")


CONTROLS = {"u1+": "faster", "u1-": "slower", "u2+": "turn left", "u2-": "turn right", "stop": "stop"}


def gesture_table(found: Discovery) -> str:
    """Return one line per gesture, the best first, then the suggestion; `-` where there is no measurement."""
    width = max(len(gesture.name) for gesture in found.gestures)
    lines = [f"{'gesture':{width}}  {'  '.join(f'{word:>9}' for word in HEAD)}"]
    lines += [
        f"{gesture.name:{width}}  {'  '.join(f'{cell:>9}' for cell in _cells(gesture))}" for gesture in found.gestures
    ]
    bound = [f"{CONTROLS[binding.control]}: {' + '.join(binding.gestures)}" for binding in found.suggestion.bindings]
    return "\n".join([*lines, "", found.suggestion.reason, ", ".join(bound)])


def _cells(gesture: FoundGesture) -> list[str]:
    forecast = gesture.prediction
    return [
        f"{gesture.score:.2f}",
        signal_word(gesture.signal_to_noise),
        "-" if gesture.repeatability is None else repeats_word(gesture.repeatability),
        _share(gesture.cross_talk),
        _share(gesture.effort),
        "-" if forecast is None or forecast.false_per_minute is None else f"{forecast.false_per_minute:.1f}",
        _share(None if forecast is None else forecast.hit_rate),
    ]


def _share(value: float | None) -> str:
    return "-" if value is None else percent(value)
