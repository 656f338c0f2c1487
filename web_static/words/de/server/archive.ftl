### Texts about the archive of a patient: one file, by which a patient's records come from one clinic to another.
### Where a text begins with { $file }:, the pages leave these first words out.

archive-session-here = Eine Sitzung dieses Patienten ist offen. Beenden Sie sie, und erstellen Sie dann das Archiv.

archive-none = { $file }: Dies ist kein Archiv von bodydrive, oder es ist unvollständig. Wählen Sie eine andere Datei.
# $name: of a file within the archive.
archive-changed = { $file }: „{ $name }“ im Archiv wurde verändert oder abgeschnitten. Nichts wurde importiert. Kopieren Sie das Archiv noch einmal.
# $schema: a whole number.
archive-newer = { $file }: Dieses Archiv stammt von einer neueren Version von bodydrive (Schema { $schema }). Nichts wurde importiert. Aktualisieren Sie bodydrive in dieser Klinik.
# $why: one of the clauses below.
archive-wrong = { $file }: Dieses Archiv ist nicht lesbar ({ $why }). Nichts wurde importiert.
archive-code-taken = Der Code „{ $code }“ gehört in dieser Klinik zu einem anderen Patienten. Nichts wurde importiert. Geben Sie jenem Patienten einen anderen Code, und importieren Sie dann noch einmal.
archive-recordings-here = Aufzeichnungen dieses Archivs gehören in dieser Klinik zu einem anderen Patienten. Nichts wurde importiert. Suchen Sie ihn in der Liste der Patienten oder auf der Seite „{ rail-backup }“ unter „{ deleted-title }“.
archive-patient-here = { $code } ist schon in dieser Klinik. Nichts wurde importiert. Ersetzen Sie den Patienten, oder lassen Sie alles, wie es ist.
archive-session-open = Eine Sitzung von { $code } ist hier offen. Nichts wurde importiert. Beenden Sie die Sitzung, und importieren Sie dann noch einmal.
# $made: a date.
archive-incident = { $code } gehört zum Vorkommnis vom { $made } und darf nicht ersetzt werden. Zuerst muss eine verantwortliche Person die Sperre des Vorkommnisses aufheben.
# $until: a date.
archive-records-kept = Sitzungen von { $code } fanden in dieser Klinik statt. Die Dokumentation dazu muss bis { $until } aufbewahrt werden. Deshalb lässt sich der Patient nicht ersetzen, und nichts wurde importiert.

## Clauses that say why an archive cannot be read: each stands in archive-wrong as $why. “Its” is “of the archive”.
## $row: the number of a row. $table, $column, $field: names in the file, which stay as they are.

archive-memory = es braucht zu viel Arbeitsspeicher
# $problem: a sentence without a full stop.
archive-text-refused = ein Text darin wird abgelehnt: { $problem }
archive-recording-names = seine Aufzeichnungen haben falsche Namen
archive-recording-unnamed = eine Aufzeichnung darin wird in keiner Zeile genannt
archive-recording-channels = die Aufzeichnung „{ $recording }“ hat andere Kanäle als ihr Layout
archive-recording-gestures = die Aufzeichnung „{ $recording }“ hat andere Gesten, als sie nennt
# $problem: archive-field.
archive-recording-field = in der Aufzeichnung „{ $recording }“: { $problem }
archive-recording-unreadable = die Aufzeichnung „{ $recording }“ ist nicht lesbar
archive-comment-without-author = bei einem Kommentar darin fehlt, wer ihn geschrieben hat
archive-other-tables = seine Tabellen sind nicht die erwarteten
archive-other-columns = die Spalten seiner Tabelle „{ $table }“ sind nicht die erwarteten
archive-rows-most = es hat mehr als { NUMBER($most, useGrouping: 1) } Zeilen
archive-one-patient = es enthält nicht genau einen Patienten
archive-session-not-ended = eine Sitzung darin ist nicht beendet
archive-row-contradicts = Zeile { $row } seiner Tabelle „{ $table }“ widerspricht einer anderen
# $problem: archive-field.
archive-row-field = in Zeile { $row } seiner Tabelle „{ $table }“: { $problem }
# $problem: archive-date, another text without a full stop, or what a library says, in English.
archive-field = „{ $field }“ ist falsch: { $problem }
archive-date = dies ist kein Datum zwischen 1970 und 2200
archive-value-empty = Zeile { $row } seiner Tabelle „{ $table }“, Spalte „{ $column }“, ist leer
archive-value-type = Zeile { $row } seiner Tabelle „{ $table }“, Spalte „{ $column }“, hat einen anderen Datentyp
archive-value-long = Zeile { $row } seiner Tabelle „{ $table }“, Spalte „{ $column }“, ist zu lang
archive-value-place = Zeile { $row } seiner Tabelle „{ $table }“, Spalte „{ $column }“, ist nicht { $row }
archive-value-refers = Zeile { $row } seiner Tabelle „{ $table }“, Spalte „{ $column }“, verweist auf eine Zeile, die fehlt
archive-value-date = Zeile { $row } seiner Tabelle „{ $table }“, Spalte „{ $column }“, ist kein Datum
archive-map-from = Zeile { $row } seiner Tabelle „profile“ stammt von einer Version, die fehlt
archive-map-back = Zeile { $row } seiner Tabelle „profile“ nennt nicht die Version, die sie wiederherstellt
archive-controls-map = Zeile { $row } seiner Tabelle „parameters“, „profile_id“, verweist auf eine Zeile, die fehlt
archive-controls-current = in Zeile { $row } seiner Tabelle „parameters“ ist „current“ falsch: ein anderes Set der Steuerung ist das aktuelle
