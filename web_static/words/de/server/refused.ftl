### Why a request was refused, where no page has a text of its own for it.

refused-no-room = Die Festplatte ist voll, und hiervon wurde nichts gespeichert. Schaffen Sie Platz, und versuchen Sie es dann noch einmal.
refused-no-address = Unter dieser Adresse gibt es nichts. Prüfen Sie die Adresse.
refused-no-docs-page = Es gibt keine Seite dieses Namens. Die Liste aller Seiten steht unter /docs/.
refused-no-method = Das ist unter dieser Adresse nicht möglich. Prüfen Sie die Methode.
refused-broken = Im Programm ist ein Fehler aufgetreten. Versuchen Sie es noch einmal, und melden Sie den Fehler, wenn er wieder auftritt.
refused-unreadable = Was gesendet wurde, ist nicht lesbar. Korrigieren Sie es.
refused-not-json = Was gesendet wurde, ist kein JSON. Korrigieren Sie es.
refused-not-declared = Was gesendet wurde, ist nicht als JSON gekennzeichnet. Senden Sie es als application/json.
refused-no-file = Was als Datei gesendet wurde, ist keine. Wählen Sie eine Datei, und fügen Sie sie dann noch einmal hinzu.

# $language, $languages: as abbreviations: en, es.
language-not-offered = Die Sprache „{ $language }“ gibt es hier nicht. Zur Wahl stehen: { $languages }.

## Where something is wrong: the beginning of a sentence that names a field and the problem.

refused-in-body = Was gesendet wurde
refused-in-address = Die Adresse
refused-in-header = Ein Header
