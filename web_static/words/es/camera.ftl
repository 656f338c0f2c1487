### The camera of a tablet, laptop or phone as the shirt: on the Shirt page and on the patient's screen.

camera-title = La cámara
camera-private = La imagen se queda en este dispositivo: nada de ella se guarda ni se envía. El programa recibe solo la posición de las articulaciones, unas 30 veces por segundo.
camera-mirror = Imagen de espejo de la cámara con las articulaciones reconocidas
camera-start = Iniciar la cámara
camera-stop = Detener la cámara
# A button on the patient's screen.
camera-start-screen = Usar la cámara de esta pantalla
camera-rate =
    { $count ->
        [one] { $count } imagen por segundo.
       *[other] { $count } imágenes por segundo.
    }

## What the camera does, and what to change.

camera-off = Siéntese de modo que la cabeza, los brazos y las caderas estén en la imagen, y nadie más.
camera-asking = El navegador pregunta por la cámara: permítala.
camera-preparing = La cámara se prepara. La primera vez tarda hasta un minuto.
camera-good = La cámara le ve.
camera-lost = La cámara no ve a nadie y la silla se detiene: siéntese delante de ella.
camera-back = Retroceda un poco: la cabeza, los hombros y los codos deben estar en la imagen.
camera-light = Más luz: la cámara apenas le ve.
camera-slow = Este dispositivo lee solo { $count } imágenes por segundo y se pierden movimientos: cierre otros programas o use otro dispositivo.

## Why there is no camera.

camera-insecure = Los navegadores dan la cámara solo a páginas por https: abra así esta página o ábrala en este mismo equipo.
camera-none = Aquí no hay cámara: conecte una o abra esta página en una tableta o un teléfono.
camera-denied = El navegador no permite la cámara: permítala para esta página en los ajustes del navegador.
camera-busy = Otro programa usa la cámara: ciérrelo e inicie la cámara de nuevo.
camera-failed = Las imágenes de la cámara no se pueden leer: cargue de nuevo esta página o use un Chrome, Edge, Firefox o Safari actual.
camera-taken = Otra página es la cámara: deténgala primero allí.
camera-unwanted = La cámara no es la camiseta en uso: elíjala en la página Camiseta.
