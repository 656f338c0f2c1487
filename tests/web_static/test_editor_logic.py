"""What the floor plan editor does to documents; its modules run in node, without a page."""


def test_documents_tools_and_undo(run_script, reference_file):
    assert " hold" in run_script("editor_logic.mjs", reference_file)
