"""The pseudo language of the tests: all that a message holds is in it, and its words are longer and have accents."""

from pseudo_language import PSEUDO, accented, copy_pages, pseudo_words

from app.settings import static_folder
from words import messages_of


def test_a_message_has_accents_brackets_and_two_fifths_more() -> None:
    assert pseudo_words("title = Settings\n") == "title = [Šéţţíñĝš ŵŵŵ]\n"
    assert pseudo_words("lead = { $name } drives\n") == "lead = [{ $name } ðŕíṽéš ŵŵŵ]\n"


def test_values_units_choices_and_references_stay() -> None:
    source = """rate = { $value } m/s
far = { NUMBER($count, useGrouping: 1) ->
    [one] One metre, { $d } m
   *[other] { $count } metres{ "" }
}
-name = bodydrive
"""
    assert (
        pseudo_words(source)
        == """rate = { $value } m/s
far = [{ NUMBER($count, useGrouping: 1) ->
        [one] Óñé ḿéţŕé, { $d } m
       *[other] { $count } ḿéţŕéš{ "" }
    } ŵŵŵŵŵ]
-name = ƀóðýðŕíṽé
"""
    )


def test_a_unit_is_a_whole_word() -> None:
    assert accented("5 mm, some 3 km/h and mmm") == "5 mm, šóḿé 3 ķḿ/ĥ áñð ḿḿḿ"


def test_each_message_of_english_is_there_with_its_values(tmp_path) -> None:
    words = copy_pages(static_folder(), tmp_path) / "words"
    files = sorted((words / "en").rglob("*.ftl"))
    assert len(files) > 30
    for file in files:
        written = messages_of(words / PSEUDO / file.relative_to(words / "en"))
        assert messages_of(file).items() <= written.items(), file
