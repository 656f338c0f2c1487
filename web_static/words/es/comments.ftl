### Texts of comments on moments of a trial.

comments-title = Comentarios
comments-none = Nadie ha comentado este ensayo.
comments-lost = Los momentos no se pueden mostrar porque no hay reproducción.
comments-go = Ir a { $t } s, al comentario de { $person }
comments-at = { $t } s
comments-new = Nuevo
comments-write = Comentar este momento
comments-text = Comentario en { $t } s
comments-hint = Puede leerlo toda persona que tenga acceso a este paciente, también con un enlace compartido.
comments-add = Añadir comentario
comments-added = Comentario añadido.
comments-change = Corregir o retirar
comments-change-label = Corregir o retirar su comentario en { $t } s
comments-save = Guardar la corrección
comments-revised = Comentario corregido.
comments-withdraw = Retirar
comments-withdrawn = Comentario retirado.
comments-by = { $person }, { $moment }
comments-by-revised = { $person }, corregido: { $moment }
comments-history =
    { $count ->
        [one] { $count } texto anterior
       *[other] { $count } textos anteriores
    }
comments-unread =
    { $count ->
        [one] { $count } comentario sin leer
       *[other] { $count } comentarios sin leer
    }
