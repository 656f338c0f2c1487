### Texts of the page that says which patients to look at.

rail-attention = A quién atender
attention-lead = Primero aparecen los pacientes que necesitan atención, cada uno con el motivo. Toque un motivo para verlo.
attention-none = Ningún paciente necesita atención ahora.
attention-nobody = No hay ningún paciente que usted pueda ver.
attention-others = Nada que atender
attention-pending =
    { $count ->
        [one] Todavía se está calculando si { $count } paciente ha empeorado.
       *[other] Todavía se está calculando si alguno de { $count } pacientes ha empeorado.
    }
attention-deterioration =
    { $count ->
        [one] { $count } medida peor, más allá de la variabilidad
       *[other] { $count } medidas peores, más allá de la variabilidad
    }
attention-drive =
    { $count ->
        [one] Un fallo detuvo { $count } conducción de una silla real
       *[other] Un fallo detuvo { $count } conducciones de una silla real
    }
attention-halted =
    { $count ->
        [one] Un fallo detuvo { $count } ensayo
       *[other] Un fallo detuvo { $count } ensayos
    }
attention-comment =
    { $count ->
        [one] { $count } comentario sin leer
       *[other] { $count } comentarios sin leer
    }
attention-unsigned =
    { $count ->
        [one] { $count } sesión sin firmar
       *[other] { $count } sesiones sin firmar
    }
attention-absent =
    { $count ->
        [one] Sin sesiones desde hace { $count } día
       *[other] Sin sesiones desde hace { $count } días
    }
attention-open = A quién atender
