### Texts of the patients page.

patients-title = ¿Quién ha venido?
patients-lead = Aquí los pacientes se identifican con un código y un seudónimo; no hace falta el nombre.
patients-search = Buscar por código o seudónimo
patients-new = Paciente nuevo
patients-new-title = Paciente nuevo
patients-code = Código
patients-code-hint = Letras, cifras, punto, guion; por ejemplo, P-015.
patients-pseudonym = Seudónimo
patients-pseudonym-hint = Una palabra que usted y el paciente reconozcan. No el nombre real.
patients-note = Nota
patients-note-hint = Puede quedar vacía.
patients-add = Añadir y empezar la sesión
patients-start = Empezar sesión
patients-go-on = Seguir
patients-end = Terminar sesión
patients-here = sesión abierta
patients-ends =
    Hay una sesión de { $code } abierta ({ $trials ->
        [one] { $trials } ensayo
       *[other] { $trials } ensayos
    }): { $name } la empezó a las { $time }. Solo puede haber una sesión abierta.
patients-ends-somebody =
    Hay una sesión de { $code } abierta ({ $trials ->
        [one] { $trials } ensayo
       *[other] { $trials } ensayos
    }): empezó a las { $time }. Solo puede haber una sesión abierta.
patients-ends-go = Terminarla y empezar { $next }
patients-sessions =
    { $count ->
        [one] { $count } sesión
       *[other] { $count } sesiones
    }
patients-trials =
    { $count ->
        [one] { $count } ensayo
       *[other] { $count } ensayos
    }
patients-never = ninguna sesión todavía
patients-last = última sesión: { $day }
patients-delete = Eliminar { $code }
patients-deleted = Se ha eliminado { $code }.
patients-empty = La lista está vacía. Añada el primer paciente: bastan un código y un seudónimo.
patients-none-found = Nadie coincide con “{ $words }”. Revise la ortografía o añada un paciente nuevo.
patients-alone = Todavía no trabaja nadie más en esta clínica.
patients-ended = La sesión ha terminado.
