### Faults: why motion was refused or ended, and what a person does next. The first texts of each are for the
### clinician, those with -patient for the patient, who reads no technical details.

# The next step of a fault after which Continue goes on with the trial or the drive.
remedy-continue = { $remedy } Después toque Continuar.

fault-none = Todo está bien.
fault-none-remedy = Siga adelante.
fault-none-patient = La silla se detuvo.

fault-stop-tablet = Se pulsó STOP en la pantalla.
fault-stop-tablet-remedy = Compruebe el entorno.
fault-stop-tablet-patient = Se pulsó STOP en la página de un profesional.

fault-stop-gesture = El paciente hizo el gesto de parada.
fault-stop-gesture-remedy = Pregunte al paciente.
fault-stop-gesture-patient = Usted detuvo la silla.

fault-stop-key = Se pulsó STOP en el teclado.
fault-stop-key-remedy = Compruebe el entorno.
fault-stop-key-patient = Se pulsó STOP en la página de un profesional.

fault-not-neutral = El cuerpo no quedó en reposo en 5 segundos.
fault-not-neutral-remedy = Pida al paciente que se quede en reposo, o suba en Controles “Cuenta desde” del movimiento activo.
fault-not-neutral-patient = Su cuerpo todavía no estaba en reposo: deje los brazos relajados.

fault-shirt-silent = La camiseta dejó de enviar señales, o sus señales llegan demasiado tarde.
fault-shirt-silent-remedy = Compruebe su batería y su cable, y mire la página Camiseta.
fault-shirt-silent-patient = La camiseta dejó de enviar señales.

fault-shirt-lossy = Se perdió más de una décima parte de las señales de la camiseta.
fault-shirt-lossy-remedy = Acerque el transmisor de la camiseta.
fault-shirt-lossy-patient = Se perdieron señales de la camiseta.

fault-channels-bad = Sensores de dos movimientos dieron valores imposibles.
fault-channels-bad-remedy = Vea los indicadores en la página Camiseta; repita la calibración sin los sensores averiados.
fault-channels-bad-patient = Hay que revisar algunos sensores de la camiseta.

fault-web-silent = El programa no envió nada al proceso de control.
fault-web-silent-remedy = Espere a que vuelva la página y empiece de nuevo.
fault-web-silent-patient = El programa se interrumpió.

fault-screen-lost = La pantalla que inició la conducción no envió nada durante 0,3 s: no tenía conexión o estaba sobrecargada, o se cerró su página.
fault-screen-lost-remedy = Compruebe que esa pantalla tiene conexión y muestra la página.
fault-screen-lost-patient = La pantalla de su profesional no tenía conexión.

fault-screen-hidden = La página que inició la conducción quedó oculta o se abandonó.
fault-screen-hidden-remedy = Póngala en primer plano y déjela ahí.
fault-screen-hidden-patient = La página de su profesional no estaba a la vista.

fault-screen-slow = La página que inició la conducción no respondió durante demasiado tiempo, y en ella no se podía pulsar STOP.
fault-screen-slow-remedy = Cierre otras páginas y programas en esa pantalla, o use una ventana más pequeña.
fault-screen-slow-patient = La pantalla de su profesional iba demasiado lenta.

fault-bad-number = Un comando no era un número.
fault-bad-number-remedy = No conduzca; repita la calibración y comunique este fallo.
fault-bad-number-patient = El programa cometió un error.

fault-loop-late = El bucle de control se quedó parado demasiado tiempo.
fault-loop-late-remedy = Cierre otros programas en este equipo.
fault-loop-late-patient = El programa iba demasiado lento.

fault-recording-lost = La grabación no se pudo escribir.
fault-recording-lost-remedy = Libere espacio en el disco y empiece después un ensayo nuevo.
fault-recording-lost-patient = La conducción no se pudo grabar.

fault-control-lost = El proceso de control terminó, y la silla está detenida.
fault-control-lost-remedy = Se está iniciando uno nuevo, con la silla deshabilitada; después empiece de nuevo.
fault-control-lost-patient = Una parte del programa se cerró.

fault-stop-chair = Se pulsó el interruptor de parada de la propia silla, se movió su propio joystick, o la silla comunica un fallo.
fault-stop-chair-remedy = Compruebe el entorno y suelte el interruptor y el joystick.
fault-stop-chair-patient = La silla se detuvo con su propio interruptor o joystick, o tiene un fallo.

fault-chair-silent = La silla ya no responde; se detiene sola.
fault-chair-silent-remedy = Compruebe la alimentación de la silla y la red.
fault-chair-silent-patient = No había conexión con la silla.

fault-chair-disarmed = La silla se deshabilitó sola: le llegaron a tiempo demasiado pocos comandos.
fault-chair-disarmed-remedy = Lleve la silla adonde la red llegue mejor.
fault-chair-disarmed-patient = No había conexión con la silla.

fault-chair-not-ready = La silla no estuvo lista en 5 segundos.
fault-chair-not-ready-remedy = Vea en la página Silla real qué indica la silla.
fault-chair-not-ready-patient = La silla no estuvo lista a tiempo.

fault-shirt-rate = La camiseta envía por segundo más o menos muestras que las fijadas para ella.
fault-shirt-rate-remedy = Fije en la página Camiseta el valor real de “{ shirtdev-rate }” y calibre de nuevo.
fault-shirt-rate-patient = Hay que configurar de nuevo la camiseta.

fault-no-movement = Las señales cambiaron como no lo hace ningún cuerpo: a saltos, con la regularidad de una máquina o igual en todas las articulaciones.
fault-no-movement-remedy = Compruebe que los conectores de la camiseta están firmes y que su cable cuelga libre, y deje al paciente en reposo.
fault-no-movement-patient = Las señales no procedían de su movimiento: deje los brazos relajados.

fault-brake-bad = Un sensor del movimiento que frena o detiene dio valores imposibles.
fault-brake-bad-remedy = Vea los indicadores en la página Camiseta; repita la calibración sin los sensores averiados.
fault-brake-bad-patient = Hay que revisar algunos sensores de la camiseta.

fault-picture-lost = Una pantalla perdió la imagen con la que conduce el paciente.
fault-picture-lost-remedy = Espere a que vuelva la imagen, o elija el plano dibujado.
fault-picture-lost-patient = Se perdió la imagen.

## Who acts next, for the patient, while the chair stands.

fault-waits-clinician = Esperamos a que su profesional lo compruebe y siga.
fault-waits-program = Esperamos al programa: vuelve a empezar solo.
fault-waits-shirt = Esperamos a la camiseta: su profesional se ocupa de ella.
fault-waits-begin = Esperamos a que su profesional empiece.
fault-waits-moment = Esperamos al programa: necesita un momento.
fault-waits-movements = Conduce usted: la silla espera sus movimientos.
fault-waits-rest = Deje los brazos relajados: la silla espera a que su cuerpo esté en reposo.
