### Texts of the export of a patient's recordings and measures, and of the import of an archive.

export-title = Exportar a otros programas
export-lead = Grabaciones y medidas en un archivo zip. Identifica al paciente por el código e indica qué fue simulado.
export-form = Formato
export-form-csv = CSV: se abre en una hoja de cálculo
export-form-parquet = Parquet: para Python y R
export-form-xdf = XDF: para laboratorios de análisis del movimiento
export-form-bids = BIDS-motion: para repositorios de datos de investigación
export-form-fhir = FHIR: medidas para la historia clínica de un hospital
export-form-archive = Expediente: todo, para otra clínica con bodydrive
export-what = Sesiones
export-all = Todas las sesiones
export-session = Sesión { $number }
export-go = Exportar
export-go-label = Exportar { $code }
export-wait = Las grabaciones largas tardan un minuto o más. En el registro queda quién exportó qué.
export-progress = Avance de la exportación
export-begun = La exportación comienza.
export-state-going-on = Grabaciones preparadas: { $packed } de { $recordings }. Enviado: { $size }.
export-state-complete = La exportación está completa: { $size }.
export-state-broken-off = La exportación se interrumpió y el archivo no está completo: exporte otra vez.
export-csv-how = Las columnas se separan con comas y los números llevan punto decimal. Una hoja de cálculo que usa coma decimal pregunta cómo abrir el archivo: elija UTF-8 e inglés.
export-archive-how = Las grabaciones ocupan { $size }. Un administrador de la otra clínica importa el archivo en su página Pacientes.
export-archive-open = Este paciente tiene una sesión abierta: termínela primero y después cree el expediente.
export-consent = Una exportación necesita el consentimiento del paciente para compartir fuera de la clínica: pídalo y anótelo arriba.
import-go = Importar un expediente
import-under-way = Se está enviando y comprobando { $name }. Las grabaciones grandes tardan minutos; deje esta página abierta.
import-progress = Avance de este paso
import-send = Enviando: { $done } de { $total }
import-unpack = Comprobando y descomprimiendo: { $done } de { $total }
import-done =
    Se ha importado el paciente { $code }: { $sessions ->
        [one] { $sessions } sesión
       *[other] { $sessions } sesiones
    }, { $trials ->
        [one] { $trials } ensayo
       *[other] { $trials } ensayos
    }.
import-replace = Sustituir el paciente
import-kept = Todo lo que hay aquí de este paciente se sustituye por el contenido del expediente. Antes se crea un expediente del paciente tal como está ahora, que se conserva 30 días.
import-replaced =
    Se ha sustituido { $code }: { $sessions ->
        [one] { $sessions } sesión
       *[other] { $sessions } sesiones
    }, { $trials ->
        [one] { $trials } ensayo
       *[other] { $trials } ensayos
    }. El estado anterior del paciente se conserva 30 días en la carpeta de la clínica: replaced/{ $kept }.
import-known = { $code } ya se había importado de este expediente: no ha cambiado nada.
