### What is wrong with one field of a form, a file or a request, and what to do: the end of a sentence that begins with
### its place ("What was sent, points[3].x: ...").

# $where: a file or a form, such as "What was sent". $problem: one of the texts below.
invalid-in = { $where }: { $problem }
# $place: the name of a field, such as channels[3].name.
invalid-at = { $where }, { $place }: { $problem }
invalid-more =
    { $count ->
        [one] { $sentence } (contiene { $count } problema más)
       *[other] { $sentence } (contiene { $count } problemas más)
    }

invalid-missing = esto falta, añádalo
invalid-unknown-field = esto no se conoce aquí, quítelo
# $problem: what the reader of the file says, in English.
invalid-not-json = esto no es JSON, corríjalo ({ $problem })
# $field: the name of a field that says of which kind an object is; $kinds: names that it may have.
invalid-kind = { $field } debe ser uno de { $kinds }, elija uno de ellos
invalid-kind-missing = falta { $field }, añádalo
invalid-too-many = puede haber { $most } como máximo, pero hay { $count }, quite algunos
invalid-too-few = debe haber { $least } como mínimo, pero hay { $count }, añada algunos

## $value: what was given, in quotes.

invalid-greater-than = esto debe ser mayor que { $limit }, pero es { $value }: corríjalo
invalid-greater-than-equal = esto debe ser { $limit } como mínimo, pero es { $value }: corríjalo
invalid-less-than = esto debe ser menor que { $limit }, pero es { $value }: corríjalo
invalid-less-than-equal = esto debe ser { $limit } como máximo, pero es { $value }: corríjalo
invalid-finite-number = esto debe ser un número finito, pero es { $value }: corríjalo
invalid-number = esto debe ser un número, pero es { $value }: corríjalo
invalid-whole-number = esto debe ser un número entero, pero es { $value }: corríjalo
invalid-truth = esto debe ser true o false, pero es { $value }: corríjalo
invalid-text = esto debe ser un texto, pero es { $value }: corríjalo
invalid-text-longer =
    { $limit ->
        [one] esto debe tener al menos { $limit } carácter, pero es { $value }: corríjalo
       *[other] esto debe tener al menos { $limit } caracteres, pero es { $value }: corríjalo
    }
invalid-text-shorter =
    { $limit ->
        [one] esto debe tener { $limit } carácter como máximo, pero es { $value }: corríjalo
       *[other] esto debe tener { $limit } caracteres como máximo, pero es { $value }: corríjalo
    }
invalid-list = esto debe ser una lista, pero es { $value }: corríjalo
invalid-object = esto debe ser un objeto con campos, pero es { $value }: corríjalo
# $choices: the values that are allowed.
invalid-choice = esto debe ser uno de { $choices }, pero es { $value }: corríjalo
invalid-date = esto debe ser una fecha, pero es { $value }: corríjalo
invalid-nothing = esto debe estar vacío, pero es { $value }: corríjalo
# $problem: what the library that reads the value says, in English.
invalid-other = { $problem }, pero es { $value }: corríjalo
# $place: the number of the character in the text; $code: such as U+200B; $name: its name in Unicode, English.
invalid-invisible = el carácter { $place } es { $code } ({ $name }), que nadie ve: quítelo
