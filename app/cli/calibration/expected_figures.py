"""What is expected of each joint of a calibration, as `bodydrive calibrate` prints it."""

from app.calibration.gestures.discovery import Discovery
from app.calibration.linear_map import Forecast
from app.calibration.prior.map_prior import JointPrior
from app.calibration.prior.solving import solve, thresholds
from app.calibration.profile import CalibrationProfile, JointMap
from app.texts import Figure, Text

UNKNOWN = Text("cli-unknown")
ANY_RATE = 100.0  # Hz: without own frames the weights do not depend on it


def expected_figures(profile: CalibrationProfile, discovery: Discovery | None) -> dict[str, tuple[Text, Text]]:
    """Return per joint the expected hits of 100 movements, and the expected activations a minute at rest.

    Each is followed by its uncertainty: one standard deviation for a calibration learnt from other people, the bound
    that the repetitions show for one of the person's own. `discovery` holds the gestures of the prompted movements;
    without them nothing is known of the latter.
    """
    return {joint.name: _figures(joint, discovery) for joint in profile.joints}


def _figures(joint: JointMap, discovery: Discovery | None) -> tuple[Text, Text]:
    if joint.map == "prior" and joint.prior is not None:
        return _forecast(joint.prior.hits, 0), _forecast(joint.prior.false_per_minute, 1)
    gestures = [] if discovery is None or not joint.prompted else discovery.gestures
    prediction = next(
        (gesture.prediction for gesture in gestures if gesture.joint == joint.name and gesture.direction == 1), None
    )
    if prediction is None:
        return UNKNOWN, UNKNOWN
    hits, least = prediction.hit_rate, prediction.hit_at_least
    falsely, most = prediction.false_per_minute, prediction.counted_at_most
    return (
        UNKNOWN
        if hits is None or least is None
        else Text("cli-at-least", figure=Figure(100 * hits), least=Figure(100 * least)),
        UNKNOWN
        if falsely is None or most is None
        else Text("cli-at-most", figure=Figure(falsely, 1), most=Figure(most)),
    )


def _forecast(forecast: Forecast | None, digits: int) -> Text:
    if forecast is None:
        return UNKNOWN
    value, uncertainty = Figure(forecast.value, digits), Figure(forecast.uncertainty, digits)
    return Text("cli-forecast", value=value, uncertainty=uncertainty)


def stroke_rates(joint: JointPrior) -> dict[str, float] | None:
    """Return how fast other people's strokes of a joint are, as shares of the rate that counts as full.

    Their mean, their standard deviation, and from where a rate counts; None when the people have nothing in common.
    """
    weights = solve(joint.mean, ANY_RATE)
    dead_zone, full = thresholds(weights, joint.mean)
    if not full > 0.0:
        return None
    mean = float(weights @ joint.mean.stroke_mean)
    deviation = max(0.0, float(weights @ joint.mean.stroke_gram @ weights) - mean * mean) ** 0.5
    shares = {"mean": mean, "deviation": deviation, "counts_from": dead_zone}
    return {name: round(value / full, 3) for name, value in shares.items()}
