### Texts of uploads: names that are taken, objects of an improbable size, and files that were replaced.

same-name-keep-both = Conservar ambos, como { $name }
same-name-replace = Sustituirlo
same-name-kept = Lo sustituido se puede recuperar durante { $days } días.
object-scale-size = { $size } m
object-scale-as-it-says = { $size } m, como indica el archivo
replaced-title = Sustituidos en los últimos { $days } días
replaced-when = Sustituido el { $day }; se borra definitivamente el { $until }.
replaced-put-back = Recuperar
replaced-put-back-label = Recuperar { $name }
replaced-back = Se ha recuperado { $name }.
