### Texts that stand in the HTML of the pages, before a script runs. Each is one line without values.

entry-starting = Einen Moment …
entry-script = bodydrive braucht JavaScript: Schalten Sie es in diesem Browser ein, und laden Sie die Seite neu.
entry-script-page = Diese Seite braucht JavaScript: Schalten Sie es in diesem Browser ein, und laden Sie die Seite neu.
entry-share-title = bodydrive: geteilte Dokumentation
entry-tablet-title = bodydrive: dieses Gerät verbinden
entry-docs = Seiten
entry-docs-back = Zurück zu bodydrive
entry-docs-all = Alle Seiten
