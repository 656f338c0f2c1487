### Texts that stand in the HTML of the pages, before a script runs. Each is one line without values.

entry-starting = Un momento…
entry-script = bodydrive necesita JavaScript: actívelo en este navegador y vuelva a cargar la página.
entry-script-page = Esta página necesita JavaScript: actívelo en este navegador y vuelva a cargarla.
entry-share-title = bodydrive: historial compartido
entry-tablet-title = bodydrive: conectar este dispositivo
entry-docs = Páginas
entry-docs-back = Volver a bodydrive
entry-docs-all = Todas las páginas
