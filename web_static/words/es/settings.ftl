### Texts of the settings: what the owner allows here, and the chairs that are paired.

prior-title = Ayuda para pacientes nuevos
prior-lead = De cada calibración en uso de un paciente que da su consentimiento, el programa aprende cómo se mueven las personas con esta camiseta. Así, un paciente nuevo puede conducir la silla virtual tras diez segundos de movimiento.
prior-on = Aprender de las calibraciones en uso
prior-few =
    { $count ->
        [one] Se conocen los movimientos de un paciente con la camiseta en uso; se necesitan { $needed } pacientes.
       *[other] Se conocen los movimientos de { $count } pacientes con la camiseta en uso; se necesitan { $needed } pacientes.
    }
prior-enough =
    { $count ->
        [one] Se conocen los movimientos de { $count } paciente con la camiseta en uso.
       *[other] Se conocen los movimientos de { $count } pacientes con la camiseta en uso.
    }
prior-off = Desactivado: no se aprende nada y los pacientes nuevos se calibran primero.
settings-title = Ajustes
settings-lead = Estos ajustes se aplican a toda la clínica.
settings-read-only = Solo los administradores pueden cambiar estos ajustes.
limits-title = Los límites de la clínica
limits-lead = Nadie conduce más rápido. Una configuración con valores mayores los conserva, pero se conduce dentro de estos límites.
limits-saving = guardando…
limits-saved = guardado
log-lead = El registro indica quién entró, consultó algo, cambió algo, condujo o paró, y cuándo. Las filas se añaden, pero nunca se cambian ni se quitan.
log-checking = Comprobando el registro…
log-check = Comprobar
tablets-title = Tabletas
tablets-lead = Otra tableta u otro equipo abre estas páginas por la red de la clínica, con cifrado.
tablets-scan = Escanee este código con la tableta o escriba la dirección. La página que se abre explica el resto.
tablets-qr = Código QR de { $url }
chairs-title = Sillas
chairs-lead = Una silla vinculada comparte una clave secreta con este programa y no obedece a nadie más.
chairs-none = Todavía no hay ninguna silla vinculada. Sin ella, se conduce la silla virtual.
chairs-address = en { $host }, puerto { $port }
chairs-facts = hasta { $forward } m/s hacia adelante, { $reverse } m/s marcha atrás · vinculada: { $when }
chairs-key = clave { $key }
chairs-pair = Vincular silla
chairs-unpair = Desvincular
chairs-unpair-label = Desvincular { $name }
chairs-unpair-title = ¿Desvincular “{ $name }”?
chairs-unpair-lead = Aquí se elimina su clave, así que este programa ya no puede conducirla. Para volver a conducirla, vincúlela de nuevo.
chairs-unpaired = “{ $name }” ya no está vinculada.
pair-title = Vincular una silla
pair-lead = El receptor funciona en el equipo de la propia silla. Necesita una clave, que se crea ahora.
pair-name = Nombre
pair-name-hint = Cómo se llama aquí a esta silla.
pair-host = Dirección
pair-host-hint = El equipo de la silla en esta red, por ejemplo 192.168.1.40.
pair-port = Puerto
pair-port-hint = En él escucha el receptor; { $port }, salvo que allí se haya fijado otro.
pair-speeds = Qué puede hacer esta silla
pair-speeds-hint = Se aplica el menor de los límites de la configuración, la clínica y la silla.
pair-go = Crear la clave
paired-title = La clave de “{ $name }”, que se muestra solo esta vez
paired-lead = No se vuelve a mostrar en ningún sitio, porque quien la tiene puede conducir esta silla. Si se pierde, desvincule la silla y vincúlela de nuevo.
paired-qr = Código QR de la clave de { $name }
paired-step-scan = En el equipo de la silla, cree un archivo que solo usted pueda leer. Ponga en él la línea de este código y pulse Intro y Ctrl-D:
paired-step-start = Inicie el receptor con él:
paired-outputs = Qué salida necesita su silla en lugar de ros2
paired-step-look = Abra la página Conducir: la silla responde allí en menos de un segundo.
paired-line = Línea de la clave, para escribir o copiar
paired-copy = Copiar la línea
paired-copied = Se ha copiado la línea de la clave. Vacíe el portapapeles cuando la silla la tenga.
paired-copy-failed = Este navegador no permite copiar desde la página: seleccione la línea y cópiela usted.
paired-done = La silla tiene la clave
