### Texts about the check of the log, which says who did what when. Its rows form a chain. The head is a file beside the
### database that says how many rows the log has: rows that were removed from its end are noticed by it.

logs-whole = El registro está íntegro (filas: { $rows }): ninguna se ha modificado, movido, insertado ni quitado.
# $rows: how many, 1 or more. It follows on logs-whole.
logs-head-behind =
    { $rows ->
        [one] La fila más reciente todavía no está en su cabecera: el programa terminó justo entonces, o está escribiendo ahora.
       *[other] Las { $rows } filas más recientes todavía no están en su cabecera: el programa terminó justo entonces, o está escribiendo ahora.
    }
# $row: the number of a row, $day: its date. It follows on logs-whole or logs-head-behind.
logs-head-begun = Si se quitan las filas más recientes, se detecta a partir de la fila { $row }, del { $day }.
# Two of these sentences, one after the other.
logs-sentences = { $first } { $second }
logs-empty = El registro está vacío.
# $row: the number of a row.
logs-row-changed = El registro se alteró: la fila { $row } se modificó, se movió o se insertó, o se quitaron filas anteriores. Archive el estado de este equipo con “bodydrive incident FILE” y compare el registro con el de una copia de seguridad.
# $left, $rows: how many.
logs-newest-removed = El registro se alteró: se quitaron sus filas más recientes y quedan { $left } de { $rows }. Archive el estado de este equipo con “bodydrive incident FILE” y compare el registro con el de una copia de seguridad.
# $rows: how many.
logs-rows-exchanged =
    { $rows ->
        [one] El registro se alteró: su primera fila no es la que se escribió. Archive el estado de este equipo con “bodydrive incident FILE” y compare el registro con el de una copia de seguridad.
       *[other] El registro se alteró: sus primeras { $rows } filas no son las que se escribieron. Archive el estado de este equipo con “bodydrive incident FILE” y compare el registro con el de una copia de seguridad.
    }
logs-head-missing = Falta la cabecera del registro junto a la base de datos: puede que se hayan quitado filas del final del registro. Archive el estado de este equipo con “bodydrive incident FILE” y compare el registro con el de una copia de seguridad.
