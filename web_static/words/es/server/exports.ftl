### Texts of exports: refusals, and what stands in the exported files for those who read them.

exports-nothing = No hay nada que exportar: no se grabó nada.
exports-no-session = Este paciente no tiene la sesión { $session }: elija una que se haya abierto.
exports-recording-missing = Falta el archivo de esta grabación.
# Name of a data set of the Brain Imaging Data Structure (BIDS); $patient is a code.
exports-bids-name = Grabaciones de { $patient } con bodydrive
# File README of such a data set. tracksys-shirt, tracksys-wheelchair, LATENCY and BodydriveSource are names in its files.
exports-bids-readme =
    Señales de una camiseta con sensores de deformación, o de los sensores que la sustituyeron, y de la silla de ruedas que se condujo con ellas, grabadas con bodydrive.

    tracksys-shirt: los canales de la camiseta, una fila por cada muestra que llegó.
    tracksys-wheelchair: posición, orientación y comandos, una fila por cada ciclo del bucle de control.
    Cada archivo motion empieza por la columna LATENCY: segundos desde el comienzo de la grabación.
    El archivo JSON que acompaña a cada archivo indica de dónde vienen las señales y si son simuladas (BodydriveSource).
exports-method-test = Prueba de dos minutos: dianas en una cruz, que se alcanzan con un cursor mientras no se mueve ninguna silla
# How a measure was taken: the title of the floor plan, and the name of the path on it.
exports-method-trial = { $plan }, recorrido “{ $path }”
exports-note-trial = { $source }. Sesión { $session }, ensayo { $number }. Calibración, versión { $version }; huella de los controles { $hash }.
exports-note-test = { $source }. Sesión { $session }, prueba de dos minutos { $number }. Calibración, versión { $version }; huella de los controles { $hash }.
