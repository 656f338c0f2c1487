### Refusals of the server: comments on trials, consents, the two-minute test, layouts; and which sensors move together.

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
# $number names the layout, as in the address of the page.
layouts-missing = No hay ninguna disposición { $number }: elija una de la lista.
layouts-most = Una clínica puede tener { $count } disposiciones como máximo: elimine una que no haga falta.
layouts-name-taken = Ya hay una disposición “{ $name }”: dé otro nombre a esta.
layouts-saved-meanwhile = “{ $name }” se ha guardado entretanto en otra pantalla: ábrala de nuevo y haga allí el cambio.
layouts-in-use = La camiseta en uso tiene la disposición “{ $name }”: use primero otra disposición y elimine esta después.
# $count: 2 or more.
layouts-proposal-groups = Hay { $count } grupos de sensores que se mueven juntos.
layouts-proposal-one = Todos los sensores que se movieron lo hicieron juntos: forman una sola articulación.
layouts-proposal-unclear = Los grupos no están claros: mueva una articulación tras otra, cada una varias veces, y pida después otra propuesta.
layouts-proposal-still = Se movieron menos de dos sensores: mueva todas las articulaciones y pida después otra propuesta.
layouts-proposal-short = Con menos de { $least } segundos de señales no se ve qué sensores se mueven juntos: use un archivo más largo o deje que la camiseta envíe durante más tiempo, y pida después otra propuesta.
