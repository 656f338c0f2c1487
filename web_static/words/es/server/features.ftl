### Refusals of the server: comments on trials, consents, the two-minute test.

# $number names the comment, as in the address of the page.
comments-missing = No hay ningún comentario { $number }: elija uno de los comentarios del ensayo.
comments-most = Un ensayo puede tener { $count } comentarios como máximo: corrija uno de los suyos.
comments-not-author = Un comentario solo puede cambiarlo quien lo escribió: escriba uno propio.
comments-withdrawn-already = Este comentario se retiró: escriba uno nuevo.
comments-trial-running = Este ensayo todavía está en marcha: véalo cuando haya terminado.
consents-future = Un consentimiento se da hoy o se dio antes: elija una fecha que no sea futura.
tests-missing = No hay ninguna prueba de dos minutos { $number }: elija una de la lista.
tests-still-running = La prueba de dos minutos todavía está en marcha: termínela primero y pregunte después por su exigencia.
tests-stop-in-force = Sigue activa una parada: anúlela primero y empiece después la prueba de dos minutos.
