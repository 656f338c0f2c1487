### Why a request was refused, where no page has a text of its own for it.

refused-no-room = The disk is full, and nothing was kept of this: make room, then try again.
refused-no-address = There is nothing at this address: check it.
refused-no-docs-page = There is no page of this name: the list of all pages is at /docs/.
refused-no-method = This cannot be done at this address: check the method.
refused-broken = Something went wrong inside the program: try again, and report it if it happens again.
refused-unreadable = What was sent cannot be read: correct it.
refused-not-json = What was sent is not JSON: correct it.
refused-not-declared = What was sent is not declared as JSON: send it as application/json.
refused-no-file = What was sent as a file is none: choose a file, then add it again.

# $language, $languages: as abbreviations: en, es.
language-not-offered = There is no language “{ $language }” here. Choose one of these: { $languages }.

## Where something is wrong: the beginning of a sentence that names a field and the problem.

refused-in-body = What was sent
refused-in-address = The address
refused-in-header = A header
