import pytest
from pydantic import Field, ValidationError

from app.quantities import Document, Metres
from app.sentences import one_sentence


class Part(Document):
    size: Metres


class Whole(Document):
    name: str = Field(min_length=1)
    parts: tuple[Part, ...]


@pytest.mark.parametrize(
    ("document", "words"),
    [
        ('{"name": "x"}', "a form, parts: this is missing, add it"),
        (
            '{"name": "x", "parts": [{"size": 1.0}, {"size": "3"}]}',
            "a form, parts[1].size: this must be a number",
        ),
        ('{"name": "x", "parts": [], "hue": 1}', "a form, hue: this is not known here, leave it out"),
        ('{"name": "x", ', "a form: this is not JSON, correct it"),
        ('{"name": "", "parts": [{}, {}]}', "(2 more problems"),
        ('{"name": "' + "x" * 100 + '", "parts": "' + "y" * 100 + '"}', "y..."),
    ],
)
def test_a_validation_error_is_one_sentence_with_its_place(document, words):
    with pytest.raises(ValidationError) as refusal:
        Whole.model_validate_json(document)
    sentence = str(one_sentence(refusal.value, "a form"))
    assert words in sentence
    assert "\n" not in sentence
    assert len(sentence) < 200
