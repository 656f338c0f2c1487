### Qué llega a una camiseta, como lo dice por sí sola la página Camiseta, y qué hacer cuando no llega nada.

arrivals-good = Llegan señales.
arrivals-waiting = Esperando señales.
# Packets are those of a network (UDP). $place is an address with a port. machine: no other machine can reach that address.
arrivals-udp-nothing =
    { $reach ->
        [machine] A { $place } no llega nada en absoluto. Solo los programas de este equipo alcanzan esa dirección: para una camiseta que está en otro lugar, escuche en otra dirección de este equipo o en 0.0.0.0, que son todas.
       *[network] A { $place } no llega nada en absoluto: nada se envía allí, o un cortafuegos no lo deja pasar. Haga que la camiseta envíe a una dirección de este equipo y al puerto { $port }, y abra en su cortafuegos el puerto UDP { $port }.
    }
arrivals-slimevr-nothing =
    { $reach ->
        [machine] A { $place } no llega nada en absoluto. Solo los programas de este equipo alcanzan esa dirección. Escuche en 0.0.0.0, que son todas las redes de este equipo, para que los rastreadores lo encuentren.
       *[network] A { $place } no llega nada en absoluto: los rastreadores están en otra red, o un cortafuegos no deja pasar sus paquetes. Conéctelos a la red de este equipo y abra en su cortafuegos el puerto UDP { $port }.
    }
arrivals-slimevr-idle = Un rastreador responde, pero no llega de él ningún movimiento. Muévalo: algunos no envían nada mientras están del todo quietos. Si sigue así, apáguelo y enciéndalo, y compruebe si un cortafuegos retiene lo que este equipo le envía.
# $source is a kind of shirt, $parts a list of parts of the body.
arrivals-partial =
    { $source ->
        [slimevr] Llegan señales, pero ninguna de: { $parts }. Encienda el rastreador de ahí. Uno que solo envía lo que ha cambiado cuenta como mudo mientras está del todo quieto: use un firmware que también entonces envíe (OPTIMIZE_UPDATES desactivado).
       *[other] Llegan señales, pero ninguna de: { $parts }. Encienda el sensor de ahí.
    }
# $why is a message shirtdev-frame-... or arrivals-no-tracker; $sender is an address.
arrivals-foreign =
    { $count ->
        [one] Llegó { $count } paquete que no es una muestra de esta camiseta. Tiene { $size } bytes y viene de { $sender } ({ $why }).
       *[other] Llegaron { $count } paquetes que no son muestras de esta camiseta. El más reciente tiene { $size } bytes y viene de { $sender } ({ $why }).
    }
# Stands in brackets, behind what is left out.
arrivals-no-tracker = no procede de un rastreador: haga que nada más envíe a este puerto
# $why is a message shirtdev-frame-late, shirtdev-newest-not-stored or arrivals-repeated.
arrivals-none-counts = Llegan muestras, pero ninguna cuenta ({ $why }).
arrivals-repeated = todas se usaron ya antes: reinicie la camiseta
# $stranger and $sender are addresses.
arrivals-senders = Llegan muestras de { $stranger } y se descartan, porque la camiseta es el emisor en { $sender }.
arrivals-rate = Llegan { $measured } muestras por segundo, pero están ajustadas { $expected }. Elija { $measured } en “{ shirtdev-rate }”, o haga que el dispositivo envíe { $expected }.
arrivals-serial-foreign = Han llegado { $bytes } bytes a { $device }, pero lo que llega no es una muestra de esta camiseta ({ $why }).
# $lines is a list of serial lines.
arrivals-serial-gone =
    La camiseta en { $device } ya no está: vuelva a conectar su cable y sus señales regresarán solas.{ $lines ->
        [none] {""}
       *[other] {" "}Si después la línea tiene otro nombre, elija ese: este equipo tiene { $lines }.
    }
# $streams is a list of streams.
arrivals-lsl-silent =
    { $ended ->
        [yes] El programa que envía { $streams } ha terminado: póngalo otra vez en marcha en el mismo equipo y sus muestras regresarán solas.
       *[no] No llegan muestras de { $streams }: haga que empiece el programa que las envía y abra los puertos UDP y TCP del 16572 al 16604 entre ambos equipos.
    }
arrivals-camera-nothing = Ninguna página envía como cámara: iníciela aquí o en la pantalla del paciente, y mantenga esa página a la vista.
arrivals-camera-nobody = La cámara envía, pero no ve a nadie: siéntese de modo que la cabeza, los hombros y los brazos estén en la imagen.
arrivals-camera-idle = La cámara da siempre la misma imagen. Compruebe si está tapada o apagada y vuelva a iniciarla.
arrivals-camera-late = Las imágenes llegan con { $delay } s de retraso, y una tardía no cuenta: cierre otros programas en el dispositivo de la cámara o elija menos muestras por segundo.
arrivals-camera-slow = La cámara lee { $pictures } imágenes por segundo, muy pocas para { $expected } muestras: elija menos muestras por segundo o use otro dispositivo.
arrivals-page-foreign =
    { $count ->
        [one] Llegó { $count } mensaje que no es un valor nuevo: vuelva a cargar la página que lo envía.
       *[other] Llegaron { $count } mensajes que no son valores nuevos: vuelva a cargar la página que los envía.
    }
arrivals-phones-nothing = Ningún teléfono envía: vincule uno, toque Empezar en él y mantenga su página a la vista. Su página dice qué le falta.
arrivals-phones-late = Los mensajes de los teléfonos llegan con { $delay } s de retraso, y uno tardío no cuenta: acerque los teléfonos a la estación de la red inalámbrica.
# $why is what this computer's Bluetooth says.
arrivals-bluetooth-nothing =
    { $why ->
        [none] Ningún sensor está al alcance: enciéndalos, acérquelos a este equipo y cierre la aplicación de su fabricante, porque un sensor solo tiene una conexión.
       *[other] No llega nada por Bluetooth ({ $why }): compruebe que el adaptador de este equipo está conectado y encendido, apague y encienda los sensores y cierre la aplicación de su fabricante, porque un sensor solo tiene una conexión.
    }
arrivals-bluetooth-idle = Un sensor está conectado, pero no llega de él ningún movimiento: apáguelo y enciéndalo.
arrivals-bluetooth-foreign =
    { $count ->
        [one] Llegó { $count } mensaje que un sensor así no envía: use sensores de WitMotion con Bluetooth 5, como el WT901BLE.
       *[other] Llegaron { $count } mensajes que un sensor así no envía: use sensores de WitMotion con Bluetooth 5, como el WT901BLE.
    }
arrivals-bluetooth-repeated = Un sensor envía una y otra vez la misma medición, y cada una cuenta una sola vez: apáguelo y enciéndalo.
# $part is a part of the body.
arrivals-bluetooth-rate = { $part }: su sensor envía { $measured } veces por segundo, muy pocas para { $expected } muestras. Acérquelo a este equipo o elija menos muestras por segundo.
# $board is the name of a board, $expected the rate that BrainFlow knows of it.
arrivals-brainflow-rate = Llegan { $measured } muestras por segundo de la placa { $board }, pero su flujo tiene { $expected }: acerque la placa a su receptor o ajústela a { $expected } como indica su fabricante.
