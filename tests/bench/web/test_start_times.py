from bench.web.start import measure_start


def test_link_help_and_memory_are_measured() -> None:
    link, help_of_slowest, memory = measure_start(runs=1, help_runs=1, commands=("log",))
    assert link.figure > 0
    assert help_of_slowest.details.startswith("log, of 1 commands")
    assert 20 < memory.figure < 2000  # MB
