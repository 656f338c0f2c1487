"""What the trials of a person lead to: warnings of control, a proposal to adapt a calibration, an earlier one to use.

The answers of the server are put together from its own documents.
"""

from typing import Any

from browser.eyes.eyes_clinic import EyesClinic
from browser.eyes.opening import Open, answered, open_all, opened, tap
from browser.eyes.states.session_places import review, written_session
from playwright.sync_api import expect

from app.api.routes.adaptation import JointView, MapView, ProposalView
from app.clock import utc_now
from app.scoring.control_quality import BadChannel, ControlQuality
from app.scoring.control_warnings import control_warnings
from app.scoring.trial_assessment import TrialAssessment
from app.scoring.trial_forecast import Effect

TURNED = {"map_angle_deg": 31.0, "evr": 0.9, "null_space_share": 0.27}  # of a movement that left its calibration
CHANGING = JointView(
    name="right_elbow", label="Right elbow", status="applied", felt_change=0.062,
    angle_proposed_deg=9.4, angle_applied_deg=6.0, angle_from_calibration_deg=6.0,
    evr_before=0.71, evr_after=0.86, cross_talk_before=0.12, cross_talk_after=0.08,
    dead_zone_before=0.15, dead_zone_after=0.13, full_before=0.6, full_after=0.55,
    reason="Its movements lie off the calibration: turned by 6.0 degrees of the 9.4 that its movements ask for; counts "
    "from 13% / s instead of 15% / s.",
)  # fmt: skip
REFUSED = JointView(
    name="left_shoulder", label="Left shoulder", status="refused", angle_proposed_deg=14.2, felt_change=0.13,
    evr_before=0.64, evr_after=0.64, cross_talk_before=0.2, cross_talk_after=0.2,
    dead_zone_before=0.15, dead_zone_after=0.15, full_before=0.6, full_after=0.6,
    reason="Its movements lie off the calibration. The patient would feel a change of 13%, and from 10% on it is "
    "refused: calibrate again.",
)  # fmt: skip
STAYS = [
    JointView(name=name, label=label, status="unchanged", reason="Nothing is lost.")
    for name, label in (("right_wrist", "Right wrist"), ("left_wrist", "Left wrist"))
]
EFFECT = Effect(
    seconds=41.0,
    activations_before=58,
    activations_after=52,
    false_before=9,
    false_after=4,
    alike=0.94,
    felt_change=0.062,
)
SENTENCE = "After the last 3 trials, right elbow would change; left shoulder may not."
DIFFERENCE = {
    "by_itself": True,
    "felt_change": 0.031,
    "joints": {"right_elbow": {"angle_applied_deg": 3.1, "dead_zone_before": 0.15, "dead_zone_after": 0.13}},
}


def warned(page: Any, clinic: EyesClinic, open_place: Open) -> None:
    """Open a place for a patient whose last trials give reason for warnings."""
    quality = ControlQuality.model_validate(clinic.good("GET", f"/trials/{clinic.trials[0]}")["quality"])
    first, second, *others = quality.joints
    joints = [first.model_copy(update=TURNED), second.model_copy(update=TURNED), *others]
    silent = BadChannel(name=others[0].channels[0], joint=others[0].name, share=0.34, silent=True)
    bad = quality.model_copy(update={"joints": tuple(joints), "bad_channels": (silent,)})
    found = control_warnings([TrialAssessment(number, number, 1, 1, "a task", bad) for number in (1, 2)])
    assert {one.kind for one in found.warnings} >= {"sensor", "map"}
    warnings = [one.model_dump(mode="json") for one in found.warnings]
    real = clinic.good("GET", "/patients/1/quality?source=simulated")
    page.context.route("**/patients/1/quality*", lambda route: route.fulfill(json={**real, "warnings": warnings}))
    clinic.when_left.append(lambda: page.context.unroute("**/patients/1/quality*"))
    open_place(page, clinic)
    open_all(page)
    expect(page.locator(".control-warnings li").first).to_be_visible()


def warned_before_the_next_trial(page: Any, clinic: EyesClinic) -> None:
    warned(page, clinic, opened("drive"))


def warned_in_review(page: Any, clinic: EyesClinic) -> None:
    written_session(clinic)  # with the consent, so that the links of a report are there
    warned(page, clinic, review(""))


def proposed(applied: int | None) -> Open:
    """Return what opens the proposal for a calibration, which waits or is applied, above three versions of it."""
    proposal = ProposalView(
        id="proposal", trials=[1, 2, 3], felt_change=0.062, warns=True, reason=SENTENCE, changes=True,
        joints=[CHANGING, REFUSED, *STAYS], effect=EFFECT, applied=applied,
        message="The patient would feel it: it waits for you." if applied is None else "",
    )  # fmt: skip

    def versions(number: int, origin: str, difference: Any, trials: list[int]) -> Any:
        parent = None if number == 1 else number - 1
        view = MapView(
            version=number, origin=origin, parent=parent, difference=difference, created=utc_now(), trials=trials
        )
        return view.model_dump(mode="json")

    maps = [
        versions(3, "back", {"back_to": 1, "joints": {}}, []),
        versions(2, "adaptation", DIFFERENCE, [3]),
        versions(1, "calibration", None, [1, 2]),
    ]

    def change(view: Any) -> Any:
        state = {"mode": "suggest", "back_to": None if applied is None else 2, "practised": 0}
        return {**view, **state, "proposal": proposal.model_dump(mode="json")}

    def open_place(page: Any, clinic: EyesClinic) -> None:
        page.context.route("**/patients/1/maps", lambda route: route.fulfill(json=maps))
        clinic.when_left.append(lambda: page.context.unroute("**/patients/1/maps"))
        answered("/adaptation", "adapt", change)(page, clinic)
        expect(page.locator(".adapt-joint")).to_have_count(2)

    return open_place


def earlier_calibration(page: Any, clinic: EyesClinic) -> None:
    """Show that an earlier calibration can be fitted to how the shirt sits."""
    clinic.set_calibration("free")
    earlier = {"version": 2, "created": "2026-03-01T10:00:00+00:00"}
    change = {"earlier": earlier, "may_fit_earlier": True, "current": "free"}
    answered("/calibration", "calibrate", lambda view: {**view, **change})(page, clinic)
    expect(page.locator(".drive-now")).to_be_visible()


def export_goes_on(page: Any, clinic: EyesClinic) -> None:
    """Show an export of which one recording is packed."""
    written_session(clinic)  # with the consent
    opened("session/patient/1")(page, clinic)
    course = {"packed": 1, "recordings": 2, "sent": 3_400_000, "state": "going on"}
    page.route("**/api/v1/exports?course=*", lambda route: route.fulfill(json=course))
    tap(page, "Export of P-1")
    expect(page.locator("progress")).to_be_visible()
    expect(page.get_by_text("3.4 MB")).to_be_visible()


INTERRUPTED = (
    "the machine interrupted it (halted 3 times, 14 s; paused 2 times, 5 s), and nobody has said yet that it counts"
)
INTERRUPTIONS = {
    "halts": 3, "halt_time": 14.2, "pauses": 2, "pause_time": 5.1, "person_stops": 1, "person_stop_time": 8.0,
    "interrupted": True,
}  # fmt: skip


def interrupted(trial: Any) -> Any:
    """Return a trial, as it is answered, as one that was interrupted so much that a person has to count it."""
    measures = {**trial["measures"], **INTERRUPTIONS}
    return {**trial, "measures": measures, "kept": False, "discard_reason": INTERRUPTED}


def interrupted_in_review(page: Any, clinic: EyesClinic) -> None:
    """Show the list of trials, of which the first was interrupted by the machine and by a person."""

    def answer(route: Any) -> None:
        first, *others = route.fetch().json()
        route.fulfill(json=[interrupted(first), *others])

    page.context.route("**/trials?patient=1", answer)
    clinic.when_left.append(lambda: page.context.unroute("**/trials?patient=1"))
    review("")(page, clinic)
    expect(page.get_by_text("Stopped once by a person, 8 s")).to_be_attached()


def interrupted_trial(page: Any, clinic: EyesClinic) -> None:
    """Show the end of a trial that was interrupted, and that does not count until somebody says so."""
    first = clinic.trials[0]

    answered(f"/trials/{first}", f"drive/over/{first}", interrupted)(page, clinic)
    expect(page.get_by_role("button", name="Count it")).to_be_visible()


TRIALS_PLACES: dict[str, Open] = {
    "drive, warnings": warned_before_the_next_trial,
    "review, warnings": warned_in_review,
    "review, interrupted": interrupted_in_review,
    "drive, interrupted": interrupted_trial,
    "adapt, proposal": proposed(None),
    "adapt, applied": proposed(4),
    "calibrate, earlier": earlier_calibration,
    "session patient, export": export_goes_on,
}
