### Texts that stand in the HTML of the pages, before a script runs. Each is one line without values.

entry-starting = One moment…
entry-script = bodydrive needs JavaScript: switch it on in this browser, then load the page again.
entry-script-page = This page needs JavaScript: switch it on in this browser, then load the page again.
entry-share-title = bodydrive: shared records
entry-tablet-title = bodydrive: connect this device
entry-docs = Pages
entry-docs-back = Back to bodydrive
entry-docs-all = All pages
