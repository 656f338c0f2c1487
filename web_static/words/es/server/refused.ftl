### Why a request was refused, where no page has a text of its own for it.

refused-no-room = El disco está lleno y de esto no se guardó nada: libere espacio e inténtelo de nuevo.
refused-no-address = En esta dirección no hay nada: compruébela.
refused-no-docs-page = No hay ninguna página con este nombre: la lista de todas está en /docs/.
refused-no-method = Esto no se puede hacer en esta dirección: compruebe el método.
refused-broken = Algo falló dentro del programa: inténtelo de nuevo y, si se repite, comuníquelo.
refused-unreadable = Lo enviado no se puede leer: corríjalo.
refused-not-json = Lo enviado no es JSON: corríjalo.
refused-not-declared = Lo enviado no está declarado como JSON: envíelo como application/json.
refused-no-file = Lo enviado como archivo no lo es: elija un archivo y añádalo otra vez.

# $language, $languages: as abbreviations: en, es.
language-not-offered = Aquí no hay ningún idioma “{ $language }”. Elija uno de estos: { $languages }.

## Where something is wrong: the beginning of a sentence that names a field and the problem.

refused-in-body = Lo enviado
refused-in-address = La dirección
refused-in-header = Un encabezado
