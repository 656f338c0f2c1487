"""A key of a text stands in one file of the catalogue only: a file that is read later would give its words to both."""

import re
from collections import defaultdict

from folders import ROOT

SCRIPTS = ROOT / "web_static" / "js"
FILES = re.findall(r'from "\./(texts/en/.+?)"', (SCRIPTS / "texts.js").read_text())
KEY = re.compile(r'^  "([^"]+)":', re.MULTILINE)


def test_no_key_stands_in_two_files():
    places = defaultdict(list)
    for file in FILES:
        for key in KEY.findall((SCRIPTS / file).read_text()):
            places[key].append(file)
    assert len(places) > 1000
    assert {key: files for key, files in places.items() if len(files) > 1} == {}
