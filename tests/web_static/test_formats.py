"""How times, days and sizes are written; the module runs in node, without a page."""


def test_times_days_and_sizes(run_script, monkeypatch):
    monkeypatch.setenv("TZ", "America/New_York")
    assert " hold" in run_script("formats.mjs")
