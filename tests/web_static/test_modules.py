"""What single modules of the pages do; each script runs some of them in node, without a page."""

import pytest

from app.texts import LANGUAGES

SCRIPTS = {
    "camera/camera": "a page is the camera from its start to its end, and sends nothing but samples",
    "camera/placement": "who sits before a camera is told to move back, or that there is too little light",
    "camera/pose_engine": "the engine that reads a camera's pictures runs in a worker and in a frame",
    "charts/curve_marks": "sessions and versions of the map stand where they belong along a learning curve",
    "charts/extent": "few values fill the axis of a chart",
    "cue_motion": "where reduced motion is preferred, the cue changes in steps and does not glide",
    "device": "the page that connects a device knows which one it is",
    "editor_logic": "the floor plan editor changes documents by its tools, and takes changes back",
    "moment_word": "the patient's screen has a large word for every end of a trial",
    "moving_channels": "a sensor that is moved is seen to move, and no other one",
    "news": "a page asks again only after news that may concern what it shows",
    "page_help": "every page has its module and its name, says what it is for in three sentences, and has a drawing",
    "pages/arrivals": "the Shirt page says why nothing arrives",
    "pages/first_path": "review begins with a task that can be compared, and says what counts",
    "pages/import_recording": "what is stored is what was shown, for the session whose page this is",
    "pages/layout_drafts": "each layout has its own unsaved changes, and another one of its id has none",
    "pages/layout_document": "the editor of layouts changes places, joints and groups, and names places on the body",
    "pages/obstacle_link": "a calibration that does not fit leads to a new one",
    "patient/arrow_and_sounds": "the arrow and the sounds of the patient's screen mean what happens",
    "results/source_group": "worn trials come first in review, otherwise what was driven last",
    "results/verdict_words": "the verdict on a measure has its unit, and no arrow within noise",
    "tablet_head": "a tablet tells where it looks, as the head tracker",
    "words": "a text has its values, numbers as given, and the right plural",
    "view/picture_age": "a picture is too old to drive by after a second, unless the page itself is late (S24)",
}


@pytest.mark.parametrize("script", SCRIPTS)
def test_it_holds(run_script, reference_file, monkeypatch, script):
    monkeypatch.setenv("TZ", "America/New_York")
    assert " hold" in run_script(f"{script}.mjs", reference_file), SCRIPTS[script]


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("script", ["formats", "joint_words"])
def test_numbers_lists_times_and_joints_are_written_as_the_language_does(run_script, monkeypatch, script, language):
    monkeypatch.setenv("TZ", "America/New_York")
    assert " hold" in run_script(f"{script}.mjs", language=language)
