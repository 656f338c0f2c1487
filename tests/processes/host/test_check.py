"""`bodydrive check` on this machine, whatever it grants."""

import json

from processes.served_demo import bodydrive


def test_it_says_in_words_whether_this_computer_will_do(tmp_path):
    process = bodydrive("check", "--seconds", "1", "--state", str(tmp_path))
    out, errors = process.communicate(timeout=60)
    lines = out.splitlines()
    assert errors == ""
    assert "Of 100 ticks of the control loop, " in lines[1]
    assert all(word in out for word in ("eal-time", "emory", "GB of the disk", "clock", "Port 8443", "calculations"))
    assert all(line[:3] in {"   ", "!  ", "!! "} for line in lines[1:-1])
    is_bad = any(line.startswith("!!") for line in lines)
    assert (process.returncode, "not good enough" in lines[-1]) == ((1, True) if is_bad else (0, False))


def test_it_prints_one_document_for_programs(tmp_path):
    process = bodydrive("check", "--json", "--seconds", "1", "--own-port", "8099", "--state", str(tmp_path))
    found = json.loads(process.communicate(timeout=60)[0])
    assert set(found) == {"verdict", "message", "findings"}
    assert [one["message"] for one in found["findings"] if "Port" in one["message"]] == [
        "Port 8099 is the one of this clinic."
    ]
    assert (process.returncode == 1) == (found["verdict"] == "bad")
