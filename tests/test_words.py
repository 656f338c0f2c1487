"""What `make words` says of a language that is being translated."""

from pseudo_language import PSEUDO

import words

ENGLISH = """
stop = STOP
begin = Begin
rate = { $value } m/s
trials =
    { $count ->
        [one] One trial
       *[other] { $count } trials
    }
"""
BEGUN = ENGLISH.replace("Begin", "Commencer").replace("$value", "$rate").replace("stop = STOP", "halt = STOP")


def test_what_is_missing_left_over_and_still_in_english_is_named(tmp_path, monkeypatch):
    monkeypatch.setattr(words, "WORDS", tmp_path)
    for language, source in (("en", ENGLISH), (PSEUDO, BEGUN)):
        (tmp_path / language).mkdir()
        (tmp_path / language / "trial.ftl").write_text(source, encoding="utf-8")
    assert words.differences(PSEUDO) == [
        "trial.ftl: stop is missing",
        "trial.ftl: halt is no message of English",
        "trial.ftl: rate has the values ['rate'], English has ['value']",
    ]
    assert words.untranslated(PSEUDO) == ["trial.ftl: trials is as in English"]
    (tmp_path / PSEUDO / "trial.ftl").write_text(ENGLISH, encoding="utf-8")
    assert words.differences(PSEUDO) == []
    names = ("stop", "begin", "trials")
    assert words.untranslated(PSEUDO) == [f"trial.ftl: {name} is as in English" for name in names]
