### Texts about the computer that runs the program: what `bodydrive check` and the page "This computer" find, the
### clinic's certificates, and the installation of a service.

## What was measured. The control loop computes once each period, a tick, and should never be late.

host-lateness-good = Vueltas del bucle de control: { $ticks }, de ellas { $late } con más de { $limit } ms de retraso; 99 de cada 100 llegaron con { $most } ms de retraso como máximo, y la más tardía con { $latest } ms.
host-lateness-attention = Vueltas del bucle de control: { $ticks }, de ellas { $late } con más de { $limit } ms de retraso; 99 de cada 100 llegaron con { $most } ms de retraso como máximo, y la más tardía con { $latest } ms. Cierre otros programas mientras se conduce.
host-lateness-bad = Vueltas del bucle de control: { $ticks }, de ellas { $late } con más de { $limit } ms de retraso; 99 de cada 100 llegaron con { $most } ms de retraso como máximo, y la más tardía con { $latest } ms. Este equipo está demasiado ocupado o es demasiado lento para conducir una silla.
host-disk-good = Espacio libre en el disco: { $free } GB.
host-disk-attention = Espacio libre en el disco: { $free } GB. Libere espacio pronto.
host-disk-bad = Espacio libre en el disco: { $free } GB. No se puede grabar nada: libere espacio.
# $time is a day with a time of day.
host-clock = El reloj marca { $time } UTC.
host-clock-early = El reloj marca { $time } UTC, pero el programa se instaló más tarde: ponga el reloj en hora.
host-clock-kept = El reloj marca { $time } UTC, y un servidor de hora lo mantiene en hora.
host-clock-not-kept = El reloj marca { $time } UTC, y ningún servidor de hora lo mantiene en hora: compárelo con otro reloj de vez en cuando.
host-port-own = El puerto { $port } es el de esta clínica.
host-port-of-system = El puerto { $port } está reservado al sistema: esta cuenta no puede usarlo.
host-port-in-use = El puerto { $port } está en uso, quizá por la propia clínica.
host-port-free = El puerto { $port } está libre.
host-compiled = Los cálculos del bucle de control se ejecutan compilados.
host-not-compiled = Los cálculos del bucle de control se ejecutan como Python sin compilar: los resultados son los mismos, pero tardan más.
# $name says whose screen it is, such as: The page of Ada
host-screen-silent = { $name }: sin respuesta, porque no está a la vista, se ha bloqueado o está en suspensión.
host-screen-good = { $name }: { $rate } imágenes por segundo.
host-screen-slow = { $name }: { $rate } imágenes por segundo. Cierre allí otros programas, o elija el plano dibujado.
host-summary-good = Este equipo es adecuado para conducir.
host-summary-attention = Este equipo es adecuado para conducir, aunque algo se puede mejorar.
host-summary-bad = Este equipo, tal como está, no es adecuado para conducir.

## Certificates: files and the days on which they begin or end

host-authority-made = Se ha creado una autoridad de certificación para esta clínica: cada tableta la instala una sola vez, como explica la página de abajo.
host-authority-replaced = Se ha sustituido la autoridad de certificación de la clínica: cada tableta necesita la nueva, como explica la página de abajo, y allí se puede quitar la anterior.
host-authority-damaged = La autoridad de certificación de la clínica en { $file } está dañada: recupere este archivo de una copia de seguridad, o elimínelo e instale la autoridad nueva en cada tableta.
host-authority-ended = La autoridad de certificación de la clínica en { $file } caducó el { $day }: elimine este archivo, inicie de nuevo e instale la autoridad nueva en cada tableta (si hoy no es { $today }, ponga en hora el reloj de este equipo en lugar de eso).
host-authority-ends-soon = La autoridad de certificación de la clínica caduca el { $day }: antes de ese día, elimine { $file } y configure de nuevo cada tableta.
host-authority-early-clock = El reloj de este equipo marca { $today }, pero la autoridad de certificación de la clínica se creó más tarde, el { $day }: ponga el reloj en hora e inicie de nuevo.
# $names are names and addresses of the machine, with commas between them
host-authority-outside = La autoridad de certificación de la clínica no puede responder por { $names }, que este equipo todavía no tenía cuando se creó la autoridad: abra las páginas por otra dirección, o elimine { $file } y configure de nuevo cada tableta.
host-certificate-not-renewed = No se pudo renovar el certificado del equipo ({ $why }): libere espacio en el disco; caduca el { $day }.
host-certificate-ends-soon = El certificado { $file } caduca el { $day }: sustitúyalo por uno nuevo.
host-certificate-unreadable = { $file } no se puede leer ({ $why }): indique los archivos de su certificado.
host-certificate-no-pair = { $certificate } y { $key } no son un certificado y su clave: ambos deben ser archivos PEM, la clave sin frase de contraseña, y deben corresponderse.
host-certificate-ended = El certificado { $file } caducó el { $day }, y el reloj de este equipo marca { $today }: sustituya el archivo por un certificado nuevo, o ponga el reloj en hora.
host-certificate-early-clock = El certificado { $file } vale a partir del { $day }, y el reloj de este equipo marca { $today }: ponga el reloj en hora.
# The name of the certificate in the settings of a device.
host-authority-title = bodydrive en { $machine }, creado el { $day }
# Stands for $machine when the machine has no name.
host-nameless-machine = este equipo
# The settings of an iPad show these two, of the file that lets it trust the clinic's machine.
host-profile-title = bodydrive en { $machine }
host-profile-explanation = Permite que este dispositivo confíe en el equipo de su clínica en el que funciona bodydrive, y en nada más: el certificado se limita a ese equipo y a redes privadas.

## The service that starts the clinic with the machine

# What systemd says of the service.
host-service-description = bodydrive: la clínica de { $folder }
host-service-no-systemd = Este equipo no tiene systemd: haga que inicie por sus propios medios el comando que muestra --print.
host-service-unwritable = No se puede escribir { $file } ({ $why }): con --system, ejecute esto con sudo.
host-service-refused = { $file } está escrito, pero systemd no lo aceptó ({ $why }): resuélvalo e inténtelo de nuevo.
# Stands in brackets when systemd gives no reason.
host-service-exit-code = código de salida { $code }
host-service-installed = { $file } está instalado y en marcha; “{ $command }” muestra su estado.
host-service-starts-at-sign-in = Se inicia cuando usted entra en el sistema; con “loginctl enable-linger” se inicia con el equipo.
