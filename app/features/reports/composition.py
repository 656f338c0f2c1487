"""Compose the document of a report from what the store has, and make its file; reads the recordings of trajectories."""

import math
from collections.abc import Iterable, Mapping
from datetime import datetime
from typing import Any, Final

from app import __version__
from app.features.records.service import Scale
from app.features.registration import TrialRemark
from app.features.reports.characters import without_invisible
from app.features.reports.document import NO_TABLE, Fact, Form, Paper, Remark, Report, ReportTable
from app.features.reports.drive_report import ReportedDrive, drives_table
from app.features.reports.material import (
    InterfaceTestMaterial,
    ParameterMaterial,
    ReportMaterial,
    SessionMaterial,
    TaskMaterial,
)
from app.features.reports.measure_reports import interface_test_report, task_report
from app.features.reports.rendering import render_html, render_pdf
from app.number_format import amount, with_minus
from app.store.log_chain import ChainHead
from app.store.origins import Origin

EXPLANATION: Final = (
    "Noise is how much this person’s own trials of the task differ without a change; where nothing changed, about one "
    "page in twenty says otherwise by chance. A trial that missed the goal counts as no better than the worst tenth of "
    "those before it that reached it. The first three trials of a task are for getting used to it and "
    "are not compared. No minimal detectable change has been published for these measures of wheelchair driving."
)
NO_GOAL: Final = "No goal was written down."
NO_NOTE: Final = "No notes."
NO_CONDITION: Final = "Nothing was driven, so there is no condition to report."
SESSIONS_HEAD: Final = ("Session", "Date", "Opened by", "Trials", "Discarded", "Signed off by")


def report_file(material: ReportMaterial, form: Form, paper: Paper) -> bytes:
    """Return the content of the file of a report: called in the computing process, or by the command."""
    report = compose(material)
    return render_pdf(report, paper) if form == "pdf" else render_html(report, paper)


def file_name(material: ReportMaterial, form: Form) -> str:
    """Return a name for the file, without any name of the patient."""
    what = "course" if material.session is None else f"session-{material.session}"
    return f"bodydrive-report-{material.patient_id}-{what}-{material.made:%Y%m%dT%H%M%SZ}.{form}"


def compose(material: ReportMaterial) -> Report:
    """Return the document of a report."""
    sessions, parameters = material.sessions, material.parameters
    course = material.session is None
    measured: tuple[TaskMaterial | InterfaceTestMaterial | ReportedDrive, ...]
    measured = (*material.tasks, *material.tests, *material.drives)
    sources = list(dict.fromkeys(one.source for one in measured))
    several = len(sources) > 1
    goals = _goals(sessions, course=course)
    return Report(
        title="Course of " + amount(len(sessions), "session") if course else f"Session {sessions[0].number}",
        code=without_invisible(material.code),
        clinic=without_invisible(material.clinic),
        made=_moment(material.made),
        practice=any(one.group == "simulated" for one in measured),
        source="; ".join(sources) or "No trial counted, so there is no source of signals.",
        facts=_facts(material),
        goals=goals if len(goals) < 3 else (goals[0], goals[-1]),
        other_goals=goals[1:-1],
        condition=() if parameters is None else _condition_facts(parameters),
        controls=NO_TABLE if parameters is None else _controls_table(parameters),
        condition_note=_condition_note(parameters),
        tasks=tuple(task_report(task, material.session, name_source=several) for task in material.tasks),
        tests=tuple(interface_test_report(one, material.session, name_source=several) for one in material.tests),
        drives=_visible(drives_table(material.drives, course=course)),
        sessions=_sessions_table(sessions) if course else NO_TABLE,
        scales=_scales(sessions, course=course),
        notes=_notes(sessions, course=course),
        comments=comment_remarks(material.comments, {one.id: one.number for one in sessions}, course=course),
        signed=_signed(sessions),
        identity=_identity(material),
        explanation=EXPLANATION,
    )


def _facts(material: ReportMaterial) -> tuple[Fact, ...]:
    first, last = material.sessions[0], material.sessions[-1]
    if material.session is None:
        when = f"{_day(first.started)} to {_day(last.started)}" if first is not last else _day(first.started)
    else:
        end = "still open" if first.ended is None else f"{first.ended.astimezone():%H:%M}"
        when = f"{_moment(first.started)} to {end}" if first.ended else f"{_moment(first.started)}, {end}"
    people = dict.fromkeys(session.opened_by for session in material.sessions if session.opened_by)
    counted = sum(session.counted for session in material.sessions)
    left_out = [entry for session in material.sessions for entry in session.left_out]
    trials = f"{amount(counted, 'trial')} counted"
    if left_out:
        reasons = "; ".join(dict.fromkeys(without_invisible(reason) for *_, reason in left_out))
        trials += f", {len(left_out)} left out ({reasons})"
    return (
        *((Fact("Made for", "Copy for the patient"),) if material.for_patient else ()),
        Fact("When", when),
        Fact("Opened by", without_invisible(", ".join(people)) or "not recorded"),
        Fact("Trials", trials),
        *_imported(material.sessions),
    )


def _imported(sessions: tuple[SessionMaterial, ...]) -> tuple[Fact, ...]:
    """Return which sessions were held in another clinic; nothing when all were held here."""
    found: dict[Origin, list[int]] = {}
    for session in sessions:
        if session.origin is not None:
            found.setdefault(session.origin, []).append(session.number)
    texts = [
        f"{_numbers(numbers)} from {without_invisible(origin.clinic)}, by {without_invisible(origin.person)}, "
        f"{_day(origin.at)}"
        for origin, numbers in found.items()
    ]
    return (Fact("Imported", "; ".join(texts)),) if texts else ()


def _numbers(numbers: list[int]) -> str:
    """Return the numbers of sessions that were imported together; they follow each other."""
    return f"Session {numbers[0]}" if len(numbers) == 1 else f"Sessions {numbers[0]} to {numbers[-1]}"


def _goals(sessions: tuple[SessionMaterial, ...], *, course: bool) -> tuple[Remark, ...]:
    """Return the goals in the patient's words; of a course, each once with the session that it was written in."""
    goals: dict[str, int] = {}
    for session in sessions:
        if session.record.goal.strip():
            goals.setdefault(without_invisible(session.record.goal.strip()), session.number)
    if not goals:
        return (Remark("", NO_GOAL),)
    return tuple(Remark(f"Session {number}" if course else "", goal) for goal, number in goals.items())


def _condition_note(parameters: ParameterMaterial | None) -> str:
    if parameters is None:
        return NO_CONDITION
    if not parameters.others:
        return ""
    return f"The newest set is shown; {amount(parameters.others, 'other set was', 'other sets were')} driven with, too."


def _sessions_table(sessions: tuple[SessionMaterial, ...]) -> ReportTable:
    return ReportTable(
        SESSIONS_HEAD,
        tuple(
            (
                str(session.number),
                _day(session.started),
                without_invisible(session.opened_by or ""),
                str(session.counted),
                str(len(session.left_out) or ""),
                "" if session.record.sign_off is None else without_invisible(session.record.sign_off.person),
            )
            for session in sessions
        ),
    )


def _visible(table: ReportTable) -> ReportTable:
    return ReportTable(table.head, tuple(tuple(map(without_invisible, row)) for row in table.rows))


def _scales(sessions: tuple[SessionMaterial, ...], *, course: bool) -> ReportTable:
    """Return the outcome scales; of a course a row for each scale, with all of its totals."""
    scales_of: dict[str, list[Scale]] = {}
    for session in sessions:
        for scale in session.record.scales:
            scales_of.setdefault(without_invisible(scale.name), []).append(scale)
    if not course:
        return ReportTable(
            ("Scale", "Total", "Day"),
            tuple((name, f"{scale.total:g}", str(scale.day)) for name, scales in scales_of.items() for scale in scales),
        )
    rows = []
    for name, scales in scales_of.items():
        ordered = sorted(scales, key=lambda scale: scale.day)
        totals = ", ".join(f"{scale.total:g}" for scale in ordered)
        days = " to ".join(dict.fromkeys((str(ordered[0].day), str(ordered[-1].day))))
        rows.append((name, totals, days))
    return ReportTable(("Scale", "Totals, the oldest first", "Day"), tuple(rows))


def _notes(sessions: tuple[SessionMaterial, ...], *, course: bool) -> tuple[Remark, ...]:
    notes = []
    for session in sessions:
        for note in session.record.notes:
            where = f"Session {session.number}, " if course else ""
            revised = "" if note.revised is None else f", revised {_moment(note.revised)}"
            head = f"{where}{_moment(note.written)}, {note.person}{revised}"
            notes.append(Remark(without_invisible(head), without_invisible(note.text)))
    return tuple(notes) or (Remark("", NO_NOTE),)


def _signed(sessions: tuple[SessionMaterial, ...]) -> str:
    """Return who signed off; of a course only when every session is signed off."""
    signed = [session.record.sign_off for session in sessions]
    if signed[-1] is None or None in signed:
        return ""
    if len(signed) == 1:
        return without_invisible(f"Signed off by {signed[-1].person}, {_moment(signed[-1].at)}")
    return without_invisible(f"All sessions are signed off, the last by {signed[-1].person}, {_moment(signed[-1].at)}")


def _identity(material: ReportMaterial) -> tuple[Fact, ...]:
    parameters = material.parameters
    began = list(dict.fromkeys(session.record.version for session in material.sessions if session.record.version))
    recorded = f"recorded with {', '.join(began)}" if began else "at the time of the session: not recorded"
    return (
        Fact("Software", f"bodydrive {__version__}; {recorded}"),
        Fact(
            "Fingerprint of the controls (SHA-256)",
            "none: nothing was driven" if parameters is None else parameters.hash,
        ),
        Fact("Head of the log", _head_text(material.head)),
    )


def _head_text(head: ChainHead | None) -> str:
    return "not recorded" if head is None else f"{amount(head.rows, 'row')}, {head.hash}"


def _day(moment: datetime) -> str:
    return f"{moment.astimezone():%Y-%m-%d}"


def _moment(moment: datetime) -> str:
    return f"{moment.astimezone():%Y-%m-%d %H:%M}"


MOST_COMMENTS: Final = 100  # in one report: those of the newest trials


def comment_remarks(comments: Iterable[TrialRemark], sessions: dict[int, int], *, course: bool) -> tuple[Remark, ...]:
    """Return the comments on trials of the reported sessions, by their trials and moments.

    `sessions` are the numbers of the reported sessions by their ids. Each remark names who said it and when, the
    trial, and the moment on the trial's time line.
    """
    remarks = [comment for comment in comments if comment.session_id in sessions]
    shown = remarks[-MOST_COMMENTS:]
    left_out = len(remarks) - len(shown)
    are_not = amount(left_out, "comment on earlier trials is", "comments on earlier trials are")
    first = (Remark("", f"{are_not} not shown."),) if left_out else ()
    return (*first, *(_remark(comment, sessions[comment.session_id] if course else None) for comment in shown))


def _remark(comment: TrialRemark, session: int | None) -> Remark:
    where = "" if session is None else f"Session {session}, "
    revised = "" if comment.revised is None else f", revised {comment.revised.astimezone():%Y-%m-%d %H:%M}"
    said = f"{comment.person}, {comment.written.astimezone():%Y-%m-%d %H:%M}{revised}"
    moment = with_minus(f"{comment.t:.1f} s")
    head = f"{where}{comment.floorplan_title}, trial {comment.number}, at {moment}: {said}"
    return Remark(without_invisible(head), without_invisible(comment.text))


CONTROL_WORDS: Final = {
    "u1+": "Faster",
    "u1-": "Slower",
    "u2+": "Turn left",
    "u2-": "Turn right",
    "stop": "Stop",
}
MODE_WORDS: Final = {
    "mode_u1": {"acceleration": "keeps its speed", "velocity": "follows the movement"},
    "mode_u2": {"acceleration": "keeps turning", "velocity": "follows the movement"},
}
ORIGIN_WORDS: Final = {
    "calibration": "",
    "adaptation": ", adapted",
    "donning": ", fitted to how the shirt sat",
    "back": ", taken back",
}
METHOD_WORDS: Final = {"pca": "standard", "guided": "learnt from the cues", "prior": "learnt from other people"}
CONTROLS_HEAD: Final = ("Control", "Movement", "Counts from", "Full at", "Gain")


def _condition_facts(parameters: ParameterMaterial) -> tuple[Fact, ...]:
    """Return the map, the modes and the speeds in words."""
    settings = parameters.settings
    maps = {joint.get("map", "pca") for joint in parameters.profile.get("joints", ())}
    origin = ORIGIN_WORDS.get(parameters.origin, parameters.origin)
    parent = "" if parameters.parent is None else f" from version {parameters.parent}"
    method = (
        " and ".join(METHOD_WORDS[method_name] for method_name in METHOD_WORDS if method_name in maps)
        or METHOD_WORDS["pca"]
    )
    of_body = {True: ", of a simulated shirt", False: "", None: ", source not recorded"}[parameters.simulated]
    modes = [MODE_WORDS[name].get(settings.get(name, ""), "not recorded") for name in MODE_WORDS]
    return (
        Fact("Calibration", f"Version {parameters.version}{origin}{parent}, {method}{of_body}"),
        Fact("How it drives", f"Forward and back: {modes[0]}. Turning: {modes[1]}"),
        Fact("Set", parameters.title),
        Fact("Stops by itself after", _stops(settings)),
        Fact("Speeds", _speeds(settings)),
        Fact("Tremor damping", _figure(settings, "cutoff", "Hz")),
    )


def _controls_table(parameters: ParameterMaterial) -> ReportTable:
    """Return what each movement does, from where it counts, where it is full, and its gain."""
    gestures = {gesture["name"]: gesture for gesture in parameters.settings.get("gestures", ())}
    labels = _joint_labels(parameters.profile)
    rows = []
    for binding in parameters.settings.get("bindings", ()):
        control, named = binding["control"], [gestures[name] for name in binding["gestures"] if name in gestures]
        control_name = CONTROL_WORDS.get(control, control)
        if control == "stop":
            rows.append((control_name, " + ".join(_gesture_text(one, labels) for one in named), "", "", ""))
        else:
            gain = f"{binding.get('gain', 1.0):g}"
            rows += [
                (control_name, _gesture_text(one, labels), _share(one, "dead_zone"), _share(one, "full"), gain)
                for one in named
            ]
    return ReportTable(CONTROLS_HEAD, tuple(rows)) if rows else NO_TABLE


def _joint_labels(profile: Mapping[str, Any]) -> dict[str, str]:
    return {joint["name"]: joint["label"] for joint in profile.get("layout", {}).get("joints", ())}


def _gesture_text(gesture: Mapping[str, Any], labels: Mapping[str, str]) -> str:
    joint = labels.get(gesture["joint"], gesture["joint"])
    movement = f"{joint}, going back" if gesture.get("direction", 1) < 0 else joint
    return f"{movement}, held" if gesture.get("feature") == "displacement" else movement


def _share(gesture: Mapping[str, Any], name: str) -> str:
    unit = "% / s" if gesture.get("feature", "rate") == "rate" else "%"
    return f"{100 * gesture[name]:.0f} {unit}".replace(" ", "\u00a0")


def _speeds(settings: Mapping[str, Any]) -> str:
    speeds = settings.get("speeds", {})
    if not {"forward", "reverse", "turn"} <= speeds.keys():
        return "not recorded"
    turn = math.degrees(speeds["turn"])
    return f"Forward {speeds['forward']:.2g}, back {speeds['reverse']:.2g} m/s, turning {turn:.0f} °/s"


def _stops(settings: Mapping[str, Any]) -> str:
    turning = settings.get("turn_cruise_time")
    return _figure(settings, "cruise_time", "s") + ("" if turning is None else f", turning {turning:g} s")


def _figure(settings: Mapping[str, Any], name: str, unit: str) -> str:
    value = settings.get(name)
    return "not recorded" if value is None else f"{value:g} {unit}"
