### What is wrong with one field of a form, a file or a request, and what to do: the end of a sentence that begins with
### its place ("What was sent, points[3].x: ...").

# $where: a file or a form, such as "What was sent". $problem: one of the texts below.
invalid-in = { $where }: { $problem }
# $place: the name of a field, such as channels[3].name.
invalid-at = { $where }, { $place }: { $problem }
invalid-more =
    { $count ->
        [one] { $sentence } (dazu { $count } weiteres Problem)
       *[other] { $sentence } (dazu { $count } weitere Probleme)
    }

invalid-missing = fehlt; ergänzen Sie es
invalid-unknown-field = ist hier nicht bekannt; lassen Sie es weg
# $problem: what the reader of the file says, in English.
invalid-not-json = ist kein JSON; korrigieren Sie es ({ $problem })
# $field: the name of a field that says of which kind an object is; $kinds: names that it may have.
invalid-kind = { $field } muss einer dieser Werte sein: { $kinds }; wählen Sie einen davon
invalid-kind-missing = { $field } fehlt; ergänzen Sie es
invalid-too-many = es dürfen höchstens { $most } sein, es sind aber { $count }; entfernen Sie einige
invalid-too-few = es müssen mindestens { $least } sein, es sind aber { $count }; ergänzen Sie einige

## $value: what was given, in quotes.

invalid-greater-than = muss größer als { $limit } sein, ist aber { $value }; korrigieren Sie es
invalid-greater-than-equal = muss mindestens { $limit } sein, ist aber { $value }; korrigieren Sie es
invalid-less-than = muss kleiner als { $limit } sein, ist aber { $value }; korrigieren Sie es
invalid-less-than-equal = darf höchstens { $limit } sein, ist aber { $value }; korrigieren Sie es
invalid-finite-number = muss eine endliche Zahl sein, ist aber { $value }; korrigieren Sie es
invalid-number = muss eine Zahl sein, ist aber { $value }; korrigieren Sie es
invalid-whole-number = muss eine ganze Zahl sein, ist aber { $value }; korrigieren Sie es
invalid-truth = muss true oder false sein, ist aber { $value }; korrigieren Sie es
invalid-text = muss ein Text sein, ist aber { $value }; korrigieren Sie es
invalid-text-longer = muss mindestens { $limit } Zeichen haben, ist aber { $value }; korrigieren Sie es
invalid-text-shorter = darf höchstens { $limit } Zeichen haben, ist aber { $value }; korrigieren Sie es
invalid-list = muss eine Liste sein, ist aber { $value }; korrigieren Sie es
invalid-object = muss ein Objekt mit Feldern sein, ist aber { $value }; korrigieren Sie es
# $choices: the values that are allowed.
invalid-choice = muss einer dieser Werte sein ({ $choices }), ist aber { $value }; korrigieren Sie es
invalid-date = muss ein Datum sein, ist aber { $value }; korrigieren Sie es
invalid-nothing = muss leer sein, ist aber { $value }; korrigieren Sie es
# $problem: what the library that reads the value says, in English.
invalid-other = { $problem }; angegeben ist { $value }, korrigieren Sie es
# $place: the number of the character in the text; $code: such as U+200B; $name: its name in Unicode, English.
invalid-invisible = Zeichen { $place } ist { $code } ({ $name }) und unsichtbar; lassen Sie es weg
