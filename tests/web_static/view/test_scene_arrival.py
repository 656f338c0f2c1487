"""The canvas of the 3D view is hidden until the scene is drawn; the script of the view's page runs in node."""

from app.scene.viewer_page import SCRIPT, STYLE


def test_no_cross_of_axes_is_seen_before_the_scene(run_script, tmp_path):
    file = tmp_path / "script.js"
    file.write_text(SCRIPT)
    assert " holds" in run_script("view/scene_arrival.mjs", file)
    assert "html:not([data-scene]) canvas { visibility: hidden; }" in STYLE
