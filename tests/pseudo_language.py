"""A language for tests, made of English: accents on letters, two fifths longer, brackets round each message.

"Settings" becomes "[Šéţţíñĝš ŵŵŵ]". A word without accents on a page comes from no message; a text of this length needs
the room that a text of another language may need. Values, units, references and choices stay as they are in English.

`python tests/pseudo_language.py FOLDER MODULE ...` runs a module of the program, a child of it, with these words.
"""

import runpy
import shutil
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, Final

from fluent.syntax import FluentParser, FluentSerializer, ast
from fluent.syntax.visitor import Transformer

PSEUDO: Final = "xx"  # letters that stand for no language
ENGLISH: Final = "en"
PLAIN: Final = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
ACCENTED: Final = "áƀçðéƒĝĥíĵķļḿñóþɋŕšţúṽŵẋýžÁƁÇÐÉƑĜĤÍĴĶĻḾÑÓÞɊŔŠŢÚṼŴẊÝŽ"
ACCENTS: Final = dict(zip(PLAIN, ACCENTED, strict=True))
UNITS: Final = frozenset(("m", "s", "kg", "Hz", "kB", "MB", "GB", "MHz", "GHz", "mm", "cm", "ms", "min", "V", "Mbit"))
LONGER: Final = 0.4  # of the length of a message
LONGEST_WORD: Final = 6
FILLING: Final = "ŵ"
OWN_NAME: Final = f"language-{PSEUDO}"


def accented(text: str) -> str:
    """Return a text with accents on all letters; units keep theirs."""
    words, word = [], ""
    for letter in f"{text} ":
        if letter in ACCENTS:
            word += letter
            continue
        words.append(word if word in UNITS else "".join(ACCENTS[each] for each in word))
        words.append(letter)
        word = ""
    return "".join(words)[:-1]


class _Accents(Transformer):
    """Puts accents on what people read, and on nothing else."""

    def visit_TextElement(self, node: ast.TextElement) -> ast.TextElement:  # noqa: N802  # the name that is called
        node.value = accented(node.value)
        return node


def pseudo_words(source: str) -> str:
    """Return a file of messages in this language."""
    resource = FluentParser().parse(source)
    for entry in resource.body:
        if isinstance(entry, ast.Message | ast.Term) and entry.value is not None:
            letters = _letters(entry.value)
            _Accents().visit(entry.value)
            if isinstance(entry, ast.Message) and _letters(entry.value) and _is_read(entry.value):
                _make_longer(entry.value, round(LONGER * letters))
    return FluentSerializer().serialize(resource)


def _letters(pattern: ast.Pattern) -> int:
    """Return how many characters a message has at most, without its values."""
    return sum(
        len(element.value)
        if isinstance(element, ast.TextElement)
        else max((_letters(variant.value) for variant in _variants(element)), default=0)
        for element in pattern.elements
    )


def _is_read(pattern: ast.Pattern) -> bool:
    """Return whether a message has words, and not only signs and units."""
    return any(
        any(letter in ACCENTED for letter in element.value)
        if isinstance(element, ast.TextElement)
        else any(_is_read(variant.value) for variant in _variants(element))
        for element in pattern.elements
    )


def _variants(element: ast.Placeable) -> list[ast.Variant]:
    return element.expression.variants if isinstance(element.expression, ast.SelectExpression) else []


def _make_longer(pattern: ast.Pattern, count: int) -> None:
    """Add letters in words of their own, and brackets."""
    full, rest = divmod(count, LONGEST_WORD)
    lengths = [LONGEST_WORD] * full + [rest] * bool(rest)
    end = "".join(f" {FILLING * length}" for length in lengths) + "]"
    first, last = pattern.elements[0], pattern.elements[-1]
    if isinstance(last, ast.TextElement):
        last.value += end
    else:
        pattern.elements.append(ast.TextElement(end))
    if isinstance(first, ast.TextElement):
        first.value = f"[{first.value}"
    else:
        pattern.elements.insert(0, ast.TextElement("["))


def write_words(words: Path) -> None:
    """Write the folder of this language, of the pages and of the server, beside that of English."""
    for file in sorted((words / ENGLISH).rglob("*.ftl")):
        written = words / PSEUDO / file.relative_to(words / ENGLISH)
        written.parent.mkdir(parents=True, exist_ok=True)
        source = file.read_text(encoding="utf-8")
        if f"\nlanguage-{ENGLISH} =" in f"\n{source}":
            source += f"\n{OWN_NAME} = Pseudo language\n"
        written.write_text(pseudo_words(source), encoding="utf-8")


def copy_pages(pages: Path, folder: Path) -> Path:
    """Copy the folder of the pages into a folder of a test, and add this language to it; return the copy."""
    copy = shutil.copytree(pages, folder / pages.name)
    write_words(copy / "words")
    return copy


Set = Callable[[Any, str, Any], object]
"""Sets an attribute, as `setattr` and `MonkeyPatch.setattr` do."""


def use_words(pages: Path, set_attribute: Set) -> None:
    """Let the program of this process take a copy of its pages, and offer this language beside its others."""
    from app import fluent_catalogue, settings, texts  # in a child: when it knows where they are

    bundled = settings._bundled_folder
    set_attribute(settings, "_bundled_folder", lambda name: pages if name == pages.name else bundled(name))
    set_attribute(fluent_catalogue, "LOCALES", fluent_catalogue.LOCALES | {PSEUDO: "en_GB"})
    offered = (*texts.LANGUAGES, PSEUDO)
    for module in list(_loaded("LANGUAGES")):
        set_attribute(module, "LANGUAGES", offered)


def _loaded(name: str) -> Iterator[Any]:
    """Yield the modules of the program that have a name."""
    modules = list(sys.modules.items())
    yield from (module for path, module in modules if path.split(".")[0] == "app" and name in vars(module))


def child_command(pages: Path, module: str, *arguments: str) -> list[str]:
    """Return the command line of a child that has these words."""
    return [sys.executable, str(Path(__file__).resolve()), str(pages), module, *arguments]


if __name__ == "__main__":
    folder, module_name = Path(sys.argv[1]), sys.argv[2]
    sys.argv[:] = sys.argv[2:]
    sys.path[0] = str(Path(__file__).resolve().parents[1])  # the folder of the program, as with `python -m`
    use_words(folder, setattr)
    from app import child_process

    child_process.command = lambda module, *arguments: child_command(folder, module, *arguments)
    runpy.run_module(module_name, run_name="__main__", alter_sys=True)
