"""A clinic of two patients is made and measured as `make large-clinic` does it with two hundred."""

import sys

import pytest
from large_clinic.__main__ import main
from large_clinic.measured import PAGES, REPORTS


@pytest.mark.long
def test_every_page_and_report_of_a_small_clinic_is_answered_and_measured(monkeypatch, capsys):
    small = ["--patients", "2", "--sessions", "2", "--trials", "1", "--rounds", "1"]
    monkeypatch.setattr(sys, "argv", ["large_clinic", *small])
    main()
    table = capsys.readouterr().out
    for address in [*(address for page in PAGES.values() for address in page), *REPORTS]:
        assert f"| GET {address}, p95 | " in table
    assert "| first backup into a folder | " in table
    assert "| next backup, of what is new | " in table
