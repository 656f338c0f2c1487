"""The measures of trials and two-minute tests that are exported: their words, and their units as UCUM codes."""

from typing import Any

MEASURES: dict[str, tuple[str, str]] = {
    "dist": ("Distance driven", "m"),
    "dist_ratio": ("Distance driven, divided by the length of the path", "1"),
    "e_diff": ("Area between trajectory and path", "m2"),
    "time": ("Time to the goal", "s"),
    "cross_track_rms": ("Root mean square distance to the path", "m"),
    "cross_track_max": ("Largest distance to the path", "m"),
    "mean_speed": ("Mean speed", "m/s"),
    "stops": ("Number of stops", "1"),
    "collisions": ("Number of collisions", "1"),
    "contact_time": ("Time in contact", "s"),
    "stages_done": ("Number of stages done", "1"),
    "follow_error_rms": ("Root mean square error of the distance to the leader", "m"),
    "follow_error_max": ("Largest error of the distance to the leader", "m"),
    "follow_near": ("Share of the time near the asked distance", "1"),
    "heading_error_deg": ("Error of the heading", "deg"),
    "turn_drift": ("Largest distance from the place of the turn", "m"),
    "cones_touched": ("Number of cones touched", "1"),
    "gap_clearance": ("Smallest clearance in gaps", "m"),
    "door_contacts": ("Number of contacts at doors", "1"),
    "turn_reversals": ("Number of reversals of the turning command", "1"),
    "pulses_per_metre": ("Commands per metre", "/m"),
    "sparc": ("Smoothness: spectral arc length", "1"),
    "ldlj": ("Smoothness: logarithmic dimensionless jerk", "1"),
    "halts": ("Number of halts by the machine; no other measure includes their time", "1"),
    "halt_time": ("Time halted by the machine", "s"),
    "pauses": ("Number of pauses because of the screen", "1"),
    "pause_time": ("Time paused because of the screen", "s"),
    "person_stops": ("Number of stops by a person", "1"),
    "person_stop_time": ("Time stopped by a person", "s"),
}
TEST_MEASURES: dict[str, tuple[str, str]] = {
    "acquisitions_per_minute": ("Two-minute test: targets per minute", "/min"),
    "throughput": ("Two-minute test: throughput (ISO 9241-411, effective width)", "bit/s"),
    "first_entry": ("Two-minute test: time to the first entry into a target", "s"),
    "dial_in": ("Two-minute test: time from the first entry to the last one", "s"),
    "path_efficiency": ("Two-minute test: straight way divided by the way of the cursor", "1"),
}


def is_number(value: Any) -> bool:
    """Return whether a measure was measured, and is no truth value."""
    return isinstance(value, int | float) and not isinstance(value, bool)
