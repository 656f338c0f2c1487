"""What stands in the document of a report: facts, verdicts, recordings, and words where there is nothing."""

import pytest
from clinic_rows import rows_in
from features.reports.conftest import SESSIONS
from features.reports.reported_clinic import CODE, GOAL, HEAD, NOTE, PLAN, TRIALS, material_of, report_of

from app import __version__
from app.features.reports.composition import NO_CONDITION, NO_GOAL, NO_NOTE, file_name, report_file
from app.refusals import NotFound
from app.store.tables import Trial
from app.texts import reader_language
from app.world.place_texts import plan_for_reader
from app.world.scene import find_place


def test_a_session_says_who_when_and_what_was_written(session_report):
    report = session_report
    assert (report.title, report.code) == (f"Session {SESSIONS}", CODE)
    assert [goal.text for goal in report.goals] == [GOAL]
    assert [note.text for note in report.notes] == [NOTE]
    assert "Dr. Weiß" in report.notes[0].head
    assert report.scales.rows == (("SCIM III", "46", "2026-11-20"),)
    assert report.signed.startswith("Signed off by Dr. Weiß, ")
    assert {fact.name: fact.value for fact in report.facts}["Trials"] == f"{TRIALS} trials counted"


def test_a_session_says_with_what_it_was_made_and_that_it_was_practice(reported, session_report):
    identity = {fact.name: fact.value for fact in session_report.identity}
    parameters = material_of(*reported, SESSIONS).parameters
    assert identity["Fingerprint of the controls (SHA-256)"] == parameters.hash
    assert identity["Head of the log"] == f"{HEAD.rows} rows, {HEAD.hash}"
    assert identity["Software"].startswith(f"bodydrive {__version__}")
    assert session_report.practice
    assert session_report.source == "Simulated shirt (simulated person), virtual chair: practice only"


def test_a_measure_has_its_level_its_band_and_the_word_of_the_verdict(session_report, course_report):
    rows = {row.name: row for row in session_report.tasks[0].measures}
    assert list(rows) == ["Area off the path", "Distance driven", "Time", "Goal reached"]
    words = {"better than noise", "within noise", "worse than noise", "too few trials"}
    assert {row.verdict for row in rows.values()} <= words
    area = {row.name: row for row in course_report.tasks[0].measures}["Area off the path"]
    assert (area.verdict, area.tone) == ("better than noise", "good")
    low, high = (float(part) for part in area.noise.removesuffix(" m²").split(" to "))
    assert float(area.now.removesuffix(" m²")) < low < float(area.before.removesuffix(" m²")) < high


def test_a_course_compares_with_the_first_session_and_a_session_with_the_one_before(session_report, course_report):
    assert session_report.tasks[0].before == f"Session {SESSIONS - 1}"
    assert course_report.tasks[0].before == "Session 1"
    assert len(course_report.sessions.rows) == SESSIONS
    assert session_report.sessions.rows == ()
    totals = ", ".join(["46"] * SESSIONS)
    assert course_report.scales.rows == (("SCIM III", totals, "2026-11-20"),)
    assert course_report.signed == ""  # five of its sessions are not signed off


def test_a_task_has_the_titles_of_its_floor_plan_and_its_path(reported, session_report):
    plan = find_place(PLAN)
    assert session_report.tasks[0].title == f"{plan.title}: {plan.paths[0].title}"


def test_the_curve_is_said_in_plain_words_with_the_statistics_behind_them(course_report):
    curve, sessions = course_report.tasks[0].sentences
    trials = SESSIONS * TRIALS
    assert curve.startswith(
        f"Better than noise over {trials} trials in {SESSIONS} sessions: the area off the path fell"
    )
    assert f"(on average of {SESSIONS} sessions)" in sessions
    assert "Mann-Kendall" not in curve + sessions
    change, of_sessions = course_report.tasks[0].statistics
    assert "last third of the sessions" in change
    assert "99 %" in of_sessions


def test_the_trajectories_of_the_recordings_are_drawn(session_report, course_report):
    assert session_report.tasks[0].trajectories.svg.count("<polyline") == 2 * TRIALS + 3  # path twice, and the scale
    assert f"{TRIALS} trajectories of session {SESSIONS}" in session_report.tasks[0].trajectories_description
    assert course_report.tasks[0].trajectories.svg.count("<polyline") == TRIALS + 30 + 3
    assert f"chosen evenly of {SESSIONS * TRIALS} trials" in course_report.tasks[0].trajectories_description


def test_a_later_session_is_not_in_the_report_of_an_earlier_one(reported):
    report = report_of(*reported, 2)
    assert report.tasks[0].before == "Session 1"
    assert report.tasks[0].curve.description == f"Area off the path over {2 * TRIALS} trials."
    first = report_of(*reported, 1).tasks[0]
    assert (first.before, {row.verdict for row in first.measures}) == ("", {"nothing to compare with"})
    assert all(row.now for row in first.measures)


def test_empty_things_have_words(database, tmp_path):
    with rows_in(database) as rows:
        patient = rows.patient()
    with pytest.raises(NotFound, match="no session yet"):
        report_of(database, tmp_path, patient.id, None)
    with rows_in(database) as rows:
        rows.open_session(patient)
    with pytest.raises(NotFound, match="no session 2"):
        report_of(database, tmp_path, patient.id, 2)
    report = report_of(database, tmp_path, patient.id, 1)
    assert (report.goals[0].text, report.notes[0].text) == (str(NO_GOAL), str(NO_NOTE))
    assert report.condition_note == str(NO_CONDITION)
    assert "still open" in report.facts[0].value
    assert (report.tasks, report.signed) == ((), "")


def test_a_trial_that_was_left_out_is_named_with_its_reason_and_counts_nowhere(reported):
    database, _, _ = reported
    with database.transaction() as db:
        trial = db.query(Trial).order_by(Trial.id).first()
        trial.kept, trial.discard_reason = False, "the chair was pushed"
    try:
        report = report_of(*reported, 1)
    finally:
        with database.transaction() as db:
            db.get_one(Trial, trial.id).kept = True
    assert report.facts[2].value == f"{TRIALS - 1} trials counted, 1 left out (the chair was pushed)"


def test_a_report_is_in_the_language_that_was_asked_for(reported):
    material = material_of(*reported, SESSIONS)
    assert b'<html lang="en">' in report_file(material, "html", "a4")
    german = report_file(material, "html", "a4", "de")
    assert b'<html lang="de">' in german
    with reader_language("de"):
        place = plan_for_reader(find_place(PLAN))
    assert f"{place.title}: {place.paths[0].title}".encode() in german
    assert place.title != find_place(PLAN).title


def test_the_name_of_the_file_names_nobody(reported):
    name = file_name(material_of(*reported, SESSIONS), "pdf")
    assert name.startswith(f"bodydrive-report-1-session-{SESSIONS}-")
    assert CODE not in name
    assert file_name(material_of(*reported, None), "html").startswith("bodydrive-report-1-course-")
