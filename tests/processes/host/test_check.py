"""`bodydrive check` on this machine, whatever it grants."""

from processes.served_demo import bodydrive


def test_it_says_in_words_whether_this_computer_will_do(tmp_path):
    process = bodydrive("check", "--seconds", "1", "--state", str(tmp_path))
    out, errors = process.communicate(timeout=60)
    lines = out.splitlines()
    assert errors == ""
    assert "Of 100 ticks, " in lines[1]
    assert all(word in out for word in ("eal-time", "emory", "GB of the disk", "clock", "Port 8443", "middle"))
    assert all(line[:3] in {"   ", "!  ", "!! "} for line in lines[1:-1])
    is_bad = any(line.startswith("!!") for line in lines)
    assert (process.returncode, "will not do" in lines[-1]) == ((1, True) if is_bad else (0, False))
