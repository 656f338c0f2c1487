### Texts about what a clinic stores: patients, sessions, people, chairs, screens, floor plans, the disk, the database.

store-no-patient = No hay ningún paciente { $patient }: elija uno de la lista de pacientes.
store-no-session = No hay ninguna sesión { $session }: elija una de la lista del paciente.
store-no-trial = No hay ningún ensayo { $trial }: elija uno de la lista de ensayos.
store-no-drive = No hay ninguna conducción { $drive }: elija una de la lista de conducciones.
store-no-chair = No hay ninguna silla { $chair }: elija una de la lista, o vincúlela primero.
store-no-screen = No hay ninguna pantalla vinculada { $screen }: elija una de la lista.
store-no-person = No hay ninguna persona { $person }: elija una de la lista.
store-nobody-called = No hay ninguna persona con el nombre “{ $name }”: vea la lista de personas.
store-no-incident = No hay ningún incidente { $incident }: vea la lista.
store-no-deleted-patient = No hay ningún paciente eliminado { $patient }: vea la lista.
store-no-set = No hay ninguna configuración guardada “{ $title }”: elija una de la lista.
store-no-plan = No hay ningún plano propio “{ $name }”: elija uno de la lista.
store-no-deleted-plan = No hay ningún plano eliminado “{ $name }”: vea la lista.
store-no-replaced-file = No hay ningún archivo sustituido así, o sus 30 días han pasado: vea la lista.

store-code-taken = El código “{ $code }” ya es de { $pseudonym }: elija otro código.
store-code-deleted = El código “{ $code }” es de un paciente eliminado: elija otro código, o pida a un administrador que deshaga la eliminación en la página “{ rail-backup }”.
store-patient-here = { $pseudonym } tiene una sesión abierta: termínela primero y después elimine el paciente.
# $time: a time of day.
store-session-open =
    { $trials ->
        [one] Hay una sesión de { $code } abierta: empezó a las { $time }, { $trials } ensayo. Termínela primero, o confirme que la sesión nueva la termina.
       *[other] Hay una sesión de { $code } abierta: empezó a las { $time }, { $trials } ensayos. Termínela primero, o confirme que la sesión nueva la termina.
    }
# $person: the name of the person who began the session. $time: a time of day.
store-session-open-by =
    { $trials ->
        [one] Hay una sesión de { $code } abierta: { $person } la empezó a las { $time }, { $trials } ensayo. Termínela primero, o confirme que la sesión nueva la termina.
       *[other] Hay una sesión de { $code } abierta: { $person } la empezó a las { $time }, { $trials } ensayos. Termínela primero, o confirme que la sesión nueva la termina.
    }
store-trial-running = Este ensayo todavía está en marcha: termínelo primero.

store-no-consent =
    { $consent ->
        [recording] { $code } no ha dado su consentimiento para la grabación: pídalo y anote la fecha en “{ record-link }”. La práctica con la camiseta simulada no necesita consentimiento.
        [clinic_prior] { $code } no ha dado su consentimiento para el uso para otros pacientes de la clínica: pídalo y anote la fecha en “{ record-link }”.
       *[sharing] { $code } no ha dado su consentimiento para compartir fuera de la clínica: pídalo y anote la fecha en “{ record-link }”.
    }

store-person-name-taken = Ya hay una persona con el nombre “{ $name }”: elija otro nombre para entrar.
store-last-owner = No queda ningún otro administrador que pueda entrar, así que { $name } conserva esa función: haga antes administrador a otra persona.
store-patients-of-reviewers = Solo se eligen pacientes para los revisores: los administradores y los profesionales trabajan con todos.
# $name: of a person. The link is an invitation to choose a password.
store-invited-disabled = El acceso de { $name } está desactivado: actívelo primero y después cree un enlace.
store-sign-in-ended = Este acceso ha terminado: entre de nuevo.

store-chair-name-taken = Ya hay una silla con el nombre “{ $name }”: elija otro nombre, o desvincule esa silla primero.
# A key: the secret that a chair shares with this computer.
store-keys-used-up = Ya se han usado todos los números de clave: empiece con una carpeta nueva para la clínica.

# The code pairs a screen of the patient.
store-code-over = La sesión de este código ha terminado: pida un código nuevo.
store-screens-most = Ya hay { $most } pantallas vinculadas: desvincule primero una en la página del profesional.

store-steps-mixed = Algunos pasos se grabaron con una camiseta que no lleva nadie y otros con una camiseta puesta: empiece de nuevo la calibración con una sola de las dos.
store-steps-mixed-sensors = Algunos pasos se grabaron con otros sensores que los demás: empiece de nuevo la calibración con un solo tipo de sensores.
store-step-interrupted = El programa se reinició durante este paso: repítalo.
store-not-calibrated = Todavía no hay nada calibrado: calibre primero y toque “{ result-accept }”.
store-set-of-other-version = Estos controles los guardó otra versión del programa, y esta no puede leerlos: calibre de nuevo, o inicie aquella versión.
# $title: the name of a saved set of controls.
store-set-of-other-joints = “{ $title }” se hizo para una camiseta con otras articulaciones y no se ajusta a esta calibración: asigne los movimientos de nuevo.
store-nothing-to-undo = No hay nada que deshacer: este es el primer ajuste.
store-nothing-to-redo = No hay nada que rehacer.
store-no-map-before = Esta versión procede directamente de una calibración: no hay ninguna versión anterior a la que volver.

# $made: a date.
store-incident-not-erased = { $code } forma parte del incidente del { $made } y no se puede borrar: antes, un administrador debe quitar la marca del incidente.
# $until: a date.
store-records-kept = El historial de { $code } debe conservarse hasta el { $until }: deshaga la eliminación y después elimine de nuevo con un motivo.
# $until: a date.
store-records-kept-reason = El historial de { $code } debe conservarse hasta el { $until }: indique un motivo para eliminarlo antes.
store-incident-lifted = La marca de este incidente ya se quitó.
store-clock-hours =
    { $hours ->
        [one] El reloj de este equipo avanzó { $hours } hora en la que no funcionó: alguien lo adelantó, o el equipo estuvo apagado. Por eso no se borra nada: los pacientes eliminados, los archivos sustituidos y las copias de seguridad antiguas se conservan ese tiempo de más. Compruebe la fecha y la hora.
       *[other] El reloj de este equipo avanzó { $hours } horas en las que no funcionó: alguien lo adelantó, o el equipo estuvo apagado. Por eso no se borra nada: los pacientes eliminados, los archivos sustituidos y las copias de seguridad antiguas se conservan ese tiempo de más. Compruebe la fecha y la hora.
    }
# $days: 2 or more.
store-clock-days = El reloj de este equipo avanzó { $days } días en los que no funcionó: alguien lo adelantó, o el equipo estuvo apagado. Por eso no se borra nada: los pacientes eliminados, los archivos sustituidos y las copias de seguridad antiguas se conservan ese tiempo de más. Compruebe la fecha y la hora.
store-erased-list-unreadable = La lista de pacientes borrados de { $file } no se puede leer: recupere una copia de esa lista, de la carpeta de las copias de seguridad o de una copia de seguridad.

store-disk-full = El disco de las grabaciones está lleno: ya no se puede grabar, conducir ni guardar nada. Todavía se puede terminar la sesión, y las personas pueden salir. Libere espacio en el equipo en el que funciona bodydrive.
store-disk-little = Solo quedan { $free } GB libres en el disco de las grabaciones, y con menos de { $needed } GB ya no se graba ni se conduce nada: libere espacio.
store-disk-no-session = No se abre ninguna sesión: solo quedan { $free } MB libres en el disco de las grabaciones. Libere espacio hasta { $needed } MB en el equipo en el que funciona bodydrive y ábrala de nuevo.
store-no-room-to-make =
    { $what ->
        [archive] No hay espacio para este expediente: debe haber { $needed } MB libres en el disco donde se crea, y hay { $free } MB. Libere espacio e inténtelo de nuevo; no se ha creado nada.
       *[export] No hay espacio para esta exportación: debe haber { $needed } MB libres en el disco donde se crea, y hay { $free } MB. Libere espacio e inténtelo de nuevo; no se ha creado nada.
    }

# $name: of a file or floor plan.
store-name-taken = Ya existe “{ $name }”: conserve ambos.
# $name: of a file or floor plan.
store-name-taken-replace = Ya existe “{ $name }”: conserve ambos, o sustitúyalo.
store-plan-name-bundled = El nombre “{ $name }” es de un plano que viene con el programa: elija otro.
store-plans-most = Ya hay { $most } planos propios: elimine primero algunos.
store-plan-bundled-kept = Un plano que viene con el programa queda como está: guarde el suyo como plano nuevo.
store-plan-bundled-not-deleted = Un plano que viene con el programa no se puede eliminar.
store-plan-saved-meanwhile = Mientras tanto, otra persona guardó este plano: guarde el suyo como plano nuevo.

store-database-held = Otro programa tiene abierta la base de datos: espere a que termine e inténtelo de nuevo.
store-database-damaged = La base de datos está dañada: recupere una copia de ella, o empiece con una carpeta nueva.
# The write-ahead log is a file of the database, not the log of who did what.
store-erased-but-read = El borrado está hecho, pero la base de datos se está leyendo, así que su registro de escritura anticipada todavía contiene bytes de lo borrado: desaparecen cuando termina el programa.
store-copy-unequal = La copia de la base de datos { $database } no es igual que ella: compruebe el disco e inténtelo de nuevo.
store-copy-no-room = No hay espacio para una copia de la base de datos, que hace falta antes que nada: libere { $needed } MB en el disco de { $folder } e inténtelo de nuevo. No se ha cambiado nada.
# $revision, $newest: numbers of schemas, such as 0002. $version: of this program.
store-schema-newer = La base de datos { $database } la abrió por última vez un bodydrive más reciente: su esquema es { $revision }, y este programa ({ $version }) conoce esquemas hasta { $newest }. No se ha cambiado nada: inicie de nuevo el programa más reciente.
# $revision, $newest: numbers of schemas, such as 0002. $problem: the error of the database, in English. $copy: the name of a file.
store-schema-failed = La base de datos { $database } no se pudo pasar del esquema { $revision } al { $newest } ({ $problem }). Está como estaba, con una copia en { $copy }: inicie el programa que la abrió por última vez y comunique este problema.
