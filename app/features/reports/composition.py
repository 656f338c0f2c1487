"""Compose the document of a report from what the store has, and make its file; reads the recordings of trajectories."""

import math
from collections.abc import Iterable, Mapping
from datetime import date, datetime
from typing import Any, Final

from app import __version__
from app.download_name import download_name
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
from app.layout import Joint, joint_title
from app.source import source_description
from app.store.origins import Origin
from app.texts import ENGLISH, Figure, Text, Value, reader_language, value_text

NO_GOAL: Final = Text("report-no-goal")
NO_NOTE: Final = Text("report-no-note")
NO_CONDITION: Final = Text("report-condition-none")
SESSIONS_HEAD: Final = (
    *(Text("report-sessions-session"), Text("report-sessions-date"), Text("report-sessions-opened")),
    *(Text("report-sessions-trials"), Text("report-sessions-discarded"), Text("report-sessions-signed")),
)


def report_file(material: ReportMaterial, form: Form, paper: Paper, language: str = ENGLISH) -> bytes:
    """Return the content of the file of a report, in one of LANGUAGES.

    Called in the computing process, or by the command.
    """
    with reader_language(language):
        report = compose(material)
        return render_pdf(report, paper) if form == "pdf" else render_html(report, paper)


def file_name(material: ReportMaterial, form: Form) -> str:
    """Return a name for the file, without any name of the patient."""
    what = "course" if material.session is None else f"session-{material.session}"
    return download_name(f"report-{material.patient_id}-{what}", material.made, form)


def compose(material: ReportMaterial) -> Report:
    """Return the document of a report, in the language of the reader."""
    sessions, parameters = material.sessions, material.parameters
    course = material.session is None
    measured: tuple[TaskMaterial | InterfaceTestMaterial | ReportedDrive, ...]
    measured = (*material.tasks, *material.tests, *material.drives)
    sources = list(dict.fromkeys(source_description(one.source) for one in measured))
    several = len(sources) > 1
    goals = _goals(sessions, course=course)
    return Report(
        title=str(Text("report-of-course", count=len(sessions)) if course else _session_name(sessions[0].number)),
        code=without_invisible(material.code),
        clinic=without_invisible(material.clinic),
        made=value_text(material.made),
        practice=any(one.group == "simulated" for one in measured),
        source="; ".join(sources) or str(Text("report-no-source")),
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
        explanation=str(Text("report-explanation")),
    )


def _fact(name: Text, value: Text | str) -> Fact:
    return Fact(str(name), str(value))


def _session_name(session: int) -> Text:
    return Text("report-of-session", session=session)


def _facts(material: ReportMaterial) -> tuple[Fact, ...]:
    people = dict.fromkeys(session.opened_by for session in material.sessions if session.opened_by)
    opened_by = without_invisible(", ".join(people)) or Text("report-fact-opened-unknown")
    reader = _fact(Text("report-fact-reader"), Text("report-fact-reader-patient"))
    return (
        *((reader,) if material.for_patient else ()),
        _fact(Text("report-fact-when"), _when(material)),
        _fact(Text("report-fact-opened"), opened_by),
        _fact(Text("report-fact-trials"), _counted(material.sessions)),
        *_imported(material.sessions),
    )


def _when(material: ReportMaterial) -> str:
    first, last = material.sessions[0], material.sessions[-1]
    if material.session is None:
        return _days(_day(first.started), _day(last.started))
    if first.ended is None:
        return str(Text("report-when-open", begun=first.started))
    return str(Text("report-when-ended", begun=first.started, ended=first.ended.astimezone().time()))


def _days(first: date, last: date) -> str:
    return value_text(first) if first == last else str(Text("report-days", first=first, last=last))


def _counted(sessions: tuple[SessionMaterial, ...]) -> str:
    counted = sum(session.counted for session in sessions)
    left_out = [entry for session in sessions for entry in session.left_out]
    if not left_out:
        return str(Text("report-trials-counted", count=counted))
    unmeasured = str(Text("report-trial-not-measured"))
    reasons = "; ".join(dict.fromkeys(without_invisible(str(reason or unmeasured)) for *_, reason in left_out))
    return str(Text("report-trials-left-out", count=counted, left=len(left_out), reasons=reasons))


def _imported(sessions: tuple[SessionMaterial, ...]) -> tuple[Fact, ...]:
    """Return which sessions were held in another clinic; nothing when all were held here.

    Sessions that were imported together follow each other.
    """
    found: dict[Origin, list[int]] = {}
    for session in sessions:
        if session.origin is not None:
            found.setdefault(session.origin, []).append(session.number)
    texts = [
        Text(
            "report-imported",
            count=len(numbers),
            first=numbers[0],
            last=numbers[-1],
            clinic=without_invisible(origin.clinic),
            person=without_invisible(origin.person),
            day=_day(origin.at),
        )
        for origin, numbers in found.items()
    ]
    return (_fact(Text("report-fact-imported"), "; ".join(map(str, texts))),) if texts else ()


def _goals(sessions: tuple[SessionMaterial, ...], *, course: bool) -> tuple[Remark, ...]:
    """Return the goals in the patient's words; of a course, each once with the session that it was written in."""
    goals: dict[str, int] = {}
    for session in sessions:
        if session.record.goal.strip():
            goals.setdefault(without_invisible(session.record.goal.strip()), session.number)
    if not goals:
        return (Remark("", str(NO_GOAL)),)
    return tuple(Remark(str(_session_name(number)) if course else "", goal) for goal, number in goals.items())


def _condition_note(parameters: ParameterMaterial | None) -> str:
    if parameters is None:
        return str(NO_CONDITION)
    if not parameters.others:
        return ""
    return str(Text("report-condition-others", count=parameters.others))


def _sessions_table(sessions: tuple[SessionMaterial, ...]) -> ReportTable:
    return ReportTable(
        tuple(map(str, SESSIONS_HEAD)),
        tuple(
            (
                str(session.number),
                value_text(_day(session.started)),
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
    rows = []
    if not course:
        head = Text("report-scales-scale"), Text("report-scales-total"), Text("report-scales-day")
        for name, scales in scales_of.items():
            rows += [(name, _number(scale.total), value_text(scale.day)) for scale in scales]
        return ReportTable(tuple(map(str, head)), tuple(rows))
    head = Text("report-scales-scale"), Text("report-scales-totals"), Text("report-scales-day")
    for name, scales in scales_of.items():
        ordered = sorted(scales, key=lambda scale: scale.day)
        totals = ", ".join(_number(scale.total) for scale in ordered)
        rows.append((name, totals, _days(ordered[0].day, ordered[-1].day)))
    return ReportTable(tuple(map(str, head)), tuple(rows))


def _notes(sessions: tuple[SessionMaterial, ...], *, course: bool) -> tuple[Remark, ...]:
    notes = []
    for session in sessions:
        for note in session.record.notes:
            head = Text("report-note", written=note.written, person=note.person)
            if note.revised is not None:
                head = Text("report-note-revised", written=note.written, person=note.person, revised=note.revised)
            notes.append(_remark(head, session.number if course else None, note.text))
    return tuple(notes) or (Remark("", str(NO_NOTE)),)


def _remark(head: Text, session: int | None, text: str) -> Remark:
    if session is not None:
        head = Text("report-remark-of-session", session=session, remark=head)
    return Remark(without_invisible(str(head)), without_invisible(text))


def _signed(sessions: tuple[SessionMaterial, ...]) -> str:
    """Return who signed off; of a course only when every session is signed off."""
    signed = [session.record.sign_off for session in sessions]
    if signed[-1] is None or None in signed:
        return ""
    person, at = signed[-1].person, signed[-1].at
    one = Text("report-signed", person=person, moment=at)
    return without_invisible(str(one if len(signed) == 1 else Text("report-signed-all", person=person, moment=at)))


def _identity(material: ReportMaterial) -> tuple[Fact, ...]:
    parameters, head = material.parameters, material.head
    recorded = dict.fromkeys(session.record.version for session in material.sessions if session.record.version)
    software = Text("report-software-unknown", version=__version__)
    if recorded:
        software = Text("report-software", version=__version__, recorded=", ".join(recorded))
    no_controls, no_head = Text("report-fingerprint-none"), Text("report-head-unknown")
    log_head = no_head if head is None else Text("report-head", count=head.rows, hash=head.hash)
    return (
        _fact(Text("report-fact-software"), software),
        _fact(Text("report-fact-fingerprint"), no_controls if parameters is None else parameters.hash),
        _fact(Text("report-fact-head"), log_head),
    )


def _day(moment: datetime) -> date:
    return moment.astimezone().date()


def _number(value: float) -> str:
    return value_text(float(f"{value:g}"))


MOST_COMMENTS: Final = 100  # in one report: those of the newest trials


def comment_remarks(comments: Iterable[TrialRemark], sessions: dict[int, int], *, course: bool) -> tuple[Remark, ...]:
    """Return the comments on trials of the reported sessions, by their trials and moments.

    `sessions` are the numbers of the reported sessions by their ids. Each remark names who said it and when, the
    trial, and the moment on the trial's time line.
    """
    remarks = [comment for comment in comments if comment.session_id in sessions]
    shown = remarks[-MOST_COMMENTS:]
    left_out = len(remarks) - len(shown)
    first = (Remark("", str(Text("report-comments-left-out", count=left_out))),) if left_out else ()
    return (*first, *(_comment(comment, sessions[comment.session_id] if course else None) for comment in shown))


def _comment(comment: TrialRemark, session: int | None) -> Remark:
    values: dict[str, Value] = {
        "plan": comment.floorplan_title,
        "number": comment.number,
        "time": Figure(comment.t, 1),
        "person": comment.person,
        "written": comment.written,
    }
    head = Text("report-comment", **values)
    if comment.revised is not None:
        head = Text("report-comment-revised", **values, revised=comment.revised)
    return _remark(head, session, comment.text)


CONTROLS: Final = {
    "u1+": Text("report-control-faster"),
    "u1-": Text("report-control-slower"),
    "u2+": Text("report-control-left"),
    "u2-": Text("report-control-right"),
    "stop": Text("report-control-stop"),
}
METHODS: Final = {
    "pca": Text("report-method-pca"),
    "guided": Text("report-method-guided"),
    "prior": Text("report-method-prior"),
}
CONTROLS_HEAD: Final = (
    *(Text("report-controls-control"), Text("report-controls-movement"), Text("report-controls-from")),
    *(Text("report-controls-full"), Text("report-controls-gain")),
)
UNKNOWN: Final = Text("report-setting-unknown")


def _condition_facts(parameters: ParameterMaterial) -> tuple[Fact, ...]:
    """Return the map, the modes and the speeds in words."""
    settings = parameters.settings
    maps = {joint.get("map", "pca") for joint in parameters.profile.get("joints", ())}
    calibration = Text(
        "report-calibration",
        version=parameters.version,
        origin=parameters.origin,
        parent=parameters.parent or 0,
        methods=[method for name, method in METHODS.items() if name in maps] or [METHODS["pca"]],
        source=parameters.calibrated,
    )
    modes = Text("report-modes", forward=settings.get("mode_u1", ""), turning=settings.get("mode_u2", ""))
    return (
        _fact(Text("report-fact-calibration"), calibration),
        _fact(Text("report-fact-modes"), modes),
        _fact(Text("report-fact-set"), parameters.title),
        _fact(Text("report-fact-stops"), _stops(settings)),
        _fact(Text("report-fact-speeds"), _speeds(settings)),
        _fact(Text("report-fact-damping"), _damping(settings)),
    )


def _controls_table(parameters: ParameterMaterial) -> ReportTable:
    """Return what each movement does, from where it counts, where it is full, and its gain."""
    gestures = {gesture["name"]: gesture for gesture in parameters.settings.get("gestures", ())}
    titles = _joint_titles(parameters.profile)
    rows = []
    for binding in parameters.settings.get("bindings", ()):
        control, named = binding["control"], [gestures[name] for name in binding["gestures"] if name in gestures]
        control_name = str(CONTROLS.get(control, control))
        if control == "stop":
            rows.append((control_name, " + ".join(_gesture_text(one, titles) for one in named), "", "", ""))
        else:
            gain = _number(binding.get("gain", 1.0))
            rows += [
                (control_name, _gesture_text(one, titles), _share(one, "dead_zone"), _share(one, "full"), gain)
                for one in named
            ]
    return ReportTable(tuple(map(str, CONTROLS_HEAD)), tuple(rows)) if rows else NO_TABLE


def _joint_titles(profile: Mapping[str, Any]) -> dict[str, str]:
    joints = [Joint.model_construct(**joint) for joint in profile.get("layout", {}).get("joints", ())]
    return {joint.name: str(joint_title(joint)) for joint in joints}


def _gesture_text(gesture: Mapping[str, Any], titles: Mapping[str, str]) -> str:
    joint = titles.get(gesture["joint"], gesture["joint"])
    direction = "back" if gesture.get("direction", 1) < 0 else "forth"
    return str(Text("report-movement", joint=joint, direction=direction, feature=gesture.get("feature", "rate")))


def _share(gesture: Mapping[str, Any], name: str) -> str:
    share = Figure(100 * gesture[name])
    of_rate = gesture.get("feature", "rate") == "rate"
    text = Text("report-share-rate", share=share) if of_rate else Text("report-share", share=share)
    return str(text).replace(" ", "\u00a0")


def _speeds(settings: Mapping[str, Any]) -> Text:
    speeds = settings.get("speeds", {})
    if not {"forward", "reverse", "turn"} <= speeds.keys():
        return UNKNOWN
    forward, reverse = (float(f"{speeds[name]:.2g}") for name in ("forward", "reverse"))
    return Text("report-speeds", forward=forward, reverse=reverse, turn=Figure(math.degrees(speeds["turn"])))


def _stops(settings: Mapping[str, Any]) -> Text:
    time, turning = settings.get("cruise_time"), settings.get("turn_cruise_time")
    if time is None:
        return UNKNOWN
    if turning is None:
        return Text("report-stops", time=_number(time))
    return Text("report-stops-turning", time=_number(time), turning=_number(turning))


def _damping(settings: Mapping[str, Any]) -> Text:
    cutoff = settings.get("cutoff")
    return UNKNOWN if cutoff is None else Text("report-damping", frequency=_number(cutoff))
