### Texts about files of signals (CSV, Parquet and other kinds): what is wrong with one, and what was mended. Most begin with the name
### of a file, or with a place in it (signals-line, signals-row), and have no full stop.

## Places, and lists of names

signals-line = { $file }, Zeile { $line }
signals-row = { $file }, Zeile { $row }
# layout: a field of the file, not translated.
signals-layout-place = { $file }, layout
# The end of a list of names that is too long.
signals-names-more = { $names } und noch { $count }

## Files and columns

signals-file-missing = { $file }: diese Datei gibt es nicht; prüfen Sie ihren Namen
# reason: what the operating system says of it, in its own language.
signals-file-unreadable = { $file }: diese Datei lässt sich nicht lesen ({ $reason }); prüfen Sie sie
signals-folder = { $file }: das ist ein Ordner; nennen Sie eine Datei darin
signals-device = { $file }: das ist ein Gerät oder eine Pipe; nennen Sie eine gewöhnliche Datei
signals-no-rows = { $file }: unter der Kopfzeile steht keine Zeile; zeichnen Sie noch einmal auf, oder nennen Sie eine andere Datei
signals-no-csv = { $file }: das ist keine CSV-Datei, sondern eine binäre; speichern Sie sie als CSV oder als Parquet
signals-no-parquet = { $file }: das ist keine Parquet-Datei; speichern Sie sie als Parquet, oder geben Sie ihr den Namen einer CSV-Datei
signals-parquet-damaged = { $file }: diese Parquet-Datei wurde abgeschnitten oder geändert und ist nicht lesbar; speichern Sie sie neu
# kind: the name of a format, such as C3D; library, extra: names of parts of programs. None is translated.
signals-library-missing = { $file }: für Dateien im Format { $kind } wird die Bibliothek { $library } gebraucht; installieren Sie sie mit pip install 'bodydrive[{ $extra }]', oder speichern Sie die Datei als CSV
signals-foreign-damaged = { $file }: diese Datei im Format { $kind } ist beschädigt oder hat eine unbekannte Form; speichern Sie sie neu oder als CSV
signals-foreign-empty = { $file }: diese Datei im Format { $kind } enthält keine Signale; nennen Sie eine andere
signals-variables-left-out = Variablen anderer Länge wurden weggelassen: { $names }.
signals-streams-left-out = Datenströme ohne Zahlen wurden weggelassen: { $names }.
# sheet: the name of a sheet of a workbook; names: those of others.
signals-sheet-read = Das Blatt { $sheet } wurde gelesen; diese anderen wurden weggelassen: { $names }.
# count: 2 or more, parts of a recording between which nothing was recorded.
signals-blocks-left-out = Die Datei hat { $count } Blöcke; der erste wurde gelesen.
# part: the name of a stream or of a sheet.
signals-part-missing = { $file }: es gibt keinen Teil „{ $part }“ (vorhanden: { $names }); nennen Sie einen von diesen
signals-matlab-objects = { $file }: ihre Tabellen haben eine Form, die nur MATLAB liest; speichern Sie sie mit writetable als CSV
signals-topics-left-out = Die Orte sind die des Topics { $topic }; diese anderen wurden weggelassen: { $names }.
signals-places-several = { $file }: mehrere Spalten können der Ort sein ({ $names }); nennen Sie die richtigen x und y
signals-kitti-times = { $file }: Posen in der Form von KITTI haben keine Zeiten; legen Sie times.txt mit { $count } Zeiten daneben, oder geben Sie die Abtastrate an
signals-numbers = { $file }: das enthält mehr als { NUMBER($most, useGrouping: 1) } Zahlen; teilen Sie es in kürzere Aufzeichnungen
signals-empty = { $file }: diese Datei ist leer; nennen Sie eine andere
signals-line-ends = { $file }: die Zeilen enden nur mit Wagenrücklauf (CR); speichern Sie die Datei mit anderen Zeilenenden
signals-column-missing = { $file }: es gibt keine Spalte „{ $column }“ (vorhanden: { $names }); ergänzen Sie sie
signals-columns-missing = { $place }: von diesen Spalten ist keine vorhanden: { $names }; vorhanden: { $there }; ergänzen Sie die Spalten, oder nennen Sie eine andere Datei
signals-columns-twice = { $place }: die Spalte „{ $column }“ kommt zweimal vor; benennen Sie eine davon um
signals-column-unnamed = { $place }: Spalte { $number } hat keinen Namen; geben Sie ihr einen
# kind: the name of a type of data, not translated.
signals-column-type = { $file }: die Spalte „{ $column }“ enthält { $kind } und keine Zahlen; lassen Sie sie weg, oder wandeln Sie sie um
signals-no-number = { $place }: in der Spalte „{ $column }“ steht dort keine Zahl; ergänzen Sie sie
signals-cells =
    { $count ->
        [one] { $place }: hier steht { $count } Zelle, in der Kopfzeile sind es { $expected }; korrigieren oder entfernen Sie diese Zeile
       *[other] { $place }: hier stehen { $count } Zellen, in der Kopfzeile sind es { $expected }; korrigieren oder entfernen Sie diese Zeile
    }
signals-not-a-number = { $place }, Spalte „{ $column }“: „{ $cell }“ ist keine Zahl; schreiben Sie eine, oder lassen Sie die Zelle leer
signals-no-numbers = { $file }: in dieser Datei steht keine Tabelle mit Zahlen; nennen Sie eine andere
signals-line-cut = Die letzte Zeile ist abgeschnitten und wurde weggelassen ({ $place }).
signals-table-further = Bei { $place } beginnt eine weitere Tabelle; sie wurde weggelassen.
signals-columns-left-out = Spalten ohne Zahlen, die sich ändern, wurden weggelassen: { $names }.
# separator: what stands between two columns; decimal: the sign of a decimal number.
signals-dialect =
    { $separator ->
        [semicolons] { $decimal ->
            [comma] Gelesen mit Semikolons zwischen den Spalten und mit Dezimalkomma.
           *[point] Gelesen mit Semikolons zwischen den Spalten und mit Dezimalpunkt.
        }
        [tabs] { $decimal ->
            [comma] Gelesen mit Tabulatoren zwischen den Spalten und mit Dezimalkomma.
           *[point] Gelesen mit Tabulatoren zwischen den Spalten und mit Dezimalpunkt.
        }
        [bars] { $decimal ->
            [comma] Gelesen mit senkrechten Strichen zwischen den Spalten und mit Dezimalkomma.
           *[point] Gelesen mit senkrechten Strichen zwischen den Spalten und mit Dezimalpunkt.
        }
        [blanks] { $decimal ->
            [comma] Gelesen mit Leerzeichen zwischen den Spalten und mit Dezimalkomma.
           *[point] Gelesen mit Leerzeichen zwischen den Spalten und mit Dezimalpunkt.
        }
       *[commas] { $decimal ->
            [comma] Gelesen mit Kommas zwischen den Spalten und mit Dezimalkomma.
           *[point] Gelesen mit Kommas zwischen den Spalten und mit Dezimalpunkt.
        }
    }

## Channels. column: the name of the column of times, often “t”.

signals-no-channel = { $file }: neben „{ $column }“ gibt es keinen Kanal; ergänzen Sie eine Spalte für jeden Kanal
signals-channels = { $file }: { $count } Kanäle sind mehr, als ein Shirt haben kann; behalten Sie höchstens { $most }
signals-channel-named-t = { $file }: das Layout „{ $layout }“ hat einen Kanal „{ $column }“, aber so heißt die Zeit; benennen Sie den Kanal um
# names: one name or several.
signals-channel-missing = { $file }: in dieser Aufzeichnung fehlen Kanäle des Layouts „{ $layout }“ ({ $names }); ergänzen Sie, was fehlt, oder verwenden Sie das Layout des Shirts, das aufgezeichnet wurde
signals-channels-count = { $file }: für die { $expected } Kanäle des Layouts „{ $layout }“ wurden { $count } Spalten genannt; nennen Sie für jeden Kanal eine, in ihrer Reihenfolge
# pairs: such as “A = Strain A [mV]”.
signals-channels-taken = Diese Kanäle haben Spalten mit anderen Namen: { $pairs }.
signals-samples-few =
    { $count ->
        [one] { $file }: { $count } Abtastwert ist zu wenig für ein Signal; zeichnen Sie mindestens einige Sekunden auf
       *[other] { $file }: { $count } Abtastwerte sind zu wenige für ein Signal; zeichnen Sie mindestens einige Sekunden auf
    }
signals-frames-few =
    { $count ->
        [one] { $file }: { $count } Datenpaket ist zu wenig für ein Signal; nennen Sie eine längere Aufzeichnung.
       *[other] { $file }: { $count } Datenpakete sind zu wenige für ein Signal; nennen Sie eine längere Aufzeichnung.
    }
signals-run-without-layout = { $file }: in der Aufzeichnung steht nicht, von welchem Shirt sie stammt.
signals-layout-missing = { $file }: dieses Layout gibt es nicht; prüfen Sie seinen Namen
signals-layout-unreadable = { $file }: dieses Layout lässt sich nicht lesen ({ $reason }); prüfen Sie es

## Times. column: the name of their column, often “t”.

# names: the columns that there are.
signals-time-missing = { $file }: es gibt keine Spalte „t“ und auch keine andere mit Zeiten (vorhanden: { $names }); ergänzen Sie eine in Sekunden
# units: a list of texts signals-time-unit; unit: the first of them.
signals-time-units = { $file }: „{ $column }“ steigt von Zeile zu Zeile um { $step }, das können verschiedene Einheiten sein ({ $units }); schreiben Sie die Einheit in den Namen, zum Beispiel „{ $column } ({ $unit })“
signals-time-unit =
    { $unit ->
        [ms] Millisekunden ({ $rate } Hz)
        [us] Mikrosekunden ({ $rate } Hz)
        [ns] Nanosekunden ({ $rate } Hz)
       *[s] Sekunden ({ $rate } Hz)
    }
signals-time-read =
    { $unit ->
        [ms] Die Zeiten sind die der Spalte „{ $column }“, in Millisekunden.
        [us] Die Zeiten sind die der Spalte „{ $column }“, in Mikrosekunden.
        [ns] Die Zeiten sind die der Spalte „{ $column }“, in Nanosekunden.
        [min] Die Zeiten sind die der Spalte „{ $column }“, in Minuten.
        [h] Die Zeiten sind die der Spalte „{ $column }“, in Stunden.
        [d] Die Zeiten sind die der Spalte „{ $column }“, in Tagen.
       *[s] Die Zeiten sind die der Spalte „{ $column }“, in Sekunden.
    }
signals-time-wraps =
    { $count ->
        [one] Die Uhr von „{ $column }“ begann { $count }-mal wieder bei 0; ihre Zeiten laufen dort weiter.
       *[other] Die Uhr von „{ $column }“ begann { $count }-mal wieder bei 0; ihre Zeiten laufen dort weiter.
    }
# A person has said that no column of the file is right as the time.
signals-rate-needed = { $file }: ohne eine Spalte mit Zeiten ist die Abtastrate unbekannt; geben Sie sie in Hz an
# rate: given by a person.
signals-rate-set = Die Abtastwerte gelten als gleichmäßig, mit { $rate } Hz.
signals-rate-beyond = { $file }: ihre Abtastrate ist { $rate } Hz; nehmen Sie mit { $slowest } bis { $fastest } Hz auf
# found: the sample rate by the column.
signals-rate-wrong = { $file }: als Abtastrate ist { $rate } Hz angegeben, nach der Spalte „{ $column }“ sind es { $found } Hz; geben Sie diese an, oder nennen Sie die Einheit der Spalte
signals-time-large = { $file }: { $column } geht von { $first } bis { $last }; geben Sie die Zeit in Sekunden an
signals-time-constant = { $file }: { $column } ist in jeder Zeile { $time }; geben Sie die Zeit jedes Abtastwerts in Sekunden an
signals-time-backwards = { $place }: die Zeit läuft dort rückwärts ({ $column } = { $after } nach { $before }); sortieren Sie die Zeilen, oder entfernen Sie den Teil, der zweimal aufgezeichnet wurde
signals-time-jumps = { $place }: { $column } springt dort um { $seconds } s ({ $hours } Stunden); behalten Sie den Teil davor oder danach, oder korrigieren Sie die Spalte { $column }
signals-rate-changes = { $place }: die Abtastrate ändert sich dort ({ $column } = { $time } s); teilen Sie die Datei in Teile mit je einer Abtastrate
signals-uneven = { $file }: { $column } steigt von Zeile zu Zeile um { $least } bis { $most } s, ohne gleichmäßige Abtastrate; exportieren Sie zu jedem Abtastwert die Zeit des Geräts selbst, oder rechnen Sie die Datei auf eine gleichmäßige Abtastrate um
# Several samples have one time, that of their arrival, or their times come in groups.
signals-shared-uneven =
    { $shared ->
        [one] { $file }: { NUMBER($shared, useGrouping: 1) } von { NUMBER($count, useGrouping: 1) } Abtastwerten hat die Zeit des vorigen, und zu jeder Zeit sind es verschieden viele, so dass die Abtastrate unbekannt ist; exportieren Sie zu jedem Abtastwert die Zeit des Geräts selbst, in Sekunden
       *[other] { $file }: { NUMBER($shared, useGrouping: 1) } von { NUMBER($count, useGrouping: 1) } Abtastwerten haben die Zeit des vorigen, und zu jeder Zeit sind es verschieden viele, so dass die Abtastrate unbekannt ist; exportieren Sie zu jedem Abtastwert die Zeit des Geräts selbst, in Sekunden
    }
signals-shared-spread =
    { $shared ->
        [one] { NUMBER($shared, useGrouping: 1) } von { NUMBER($count, useGrouping: 1) } Abtastwerten hat die Zeit des vorigen: Alle wurden gleichmäßig verteilt, mit { $rate } Hz.
       *[other] { NUMBER($shared, useGrouping: 1) } von { NUMBER($count, useGrouping: 1) } Abtastwerten haben die Zeit des vorigen: Alle wurden gleichmäßig verteilt, mit { $rate } Hz.
    }
signals-bursts-uneven = { $file }: die Abtastwerte kommen in Schüben, mit der Zeit ihrer Ankunft, und jedes Mal sind es verschieden viele, so dass die Abtastrate unbekannt ist; exportieren Sie zu jedem Abtastwert die Zeit des Geräts selbst, in Sekunden
signals-bursts-spread = Die Abtastwerte kommen in Schüben, mit der Zeit ihrer Ankunft: Sie wurden gleichmäßig verteilt, mit { $rate } Hz.
signals-steps-spread = Die Schritte von { $column } sind verschieden, die Abtastwerte aber gleichmäßig: Sie wurden gleichmäßig verteilt, mit { $rate } Hz.
signals-gaps =
    { $count ->
        [one] Zwischen den Abtastwerten ist { NUMBER($count, useGrouping: 1) } Lücke, von { $longest } s, vor { $place }.
       *[other] Zwischen den Abtastwerten sind { NUMBER($count, useGrouping: 1) } Lücken, die längste von { $longest } s, vor { $place }.
    }

## Times in another unit than seconds. step: by how much t rises.

signals-unit-counter = { $file }: { $column } muss in Sekunden sein, steigt aber von Zeile zu Zeile um { $step }, wahrscheinlich als Zähler der Abtastwerte; teilen Sie die Spalte { $column } durch die Abtastrate in Hz
signals-unit =
    { $unit ->
        [milliseconds] Millisekunden ({ $rate } Hz)
        [microseconds] Mikrosekunden ({ $rate } Hz)
        [nanoseconds] Nanosekunden ({ $rate } Hz)
        [minutes] Minuten ({ $rate } Hz)
        [hours] Stunden ({ $rate } Hz)
       *[days] Tage ({ $rate } Hz)
    }
# unit: a text signals-unit.
signals-unit-other = { $file }: { $column } muss in Sekunden sein, steigt aber von Zeile zu Zeile um { $step }, wahrscheinlich sind es { $unit }; multiplizieren Sie die Spalte { $column } mit { $factor }
signals-unit-one-of-two = { $file }: { $column } muss in Sekunden sein, steigt aber von Zeile zu Zeile um { $step }, wahrscheinlich sind es { $unit } oder { $or_unit }; multiplizieren Sie die Spalte { $column } mit { $factor } oder { $or_factor }
signals-unit-or-slow = { $file }: { $column } muss in Sekunden sein, steigt aber von Zeile zu Zeile um { $step }, wahrscheinlich in einer anderen Einheit, oder die Abtastung war zu langsam; schreiben Sie die Zeit in Sekunden, und zeichnen Sie mit { $slowest } bis { $fastest } Hz auf
signals-unit-or-fast = { $file }: { $column } muss in Sekunden sein, steigt aber von Zeile zu Zeile um { $step }, wahrscheinlich in einer anderen Einheit, oder die Abtastung war zu schnell; schreiben Sie die Zeit in Sekunden, und zeichnen Sie mit { $slowest } bis { $fastest } Hz auf
# span, rate: of the recording if t is in seconds; span_of_minutes (s), rate_of_minutes (Hz): if it is in minutes.
signals-unit-minutes = { $file }: { $column } muss in Sekunden sein, steigt aber von Zeile zu Zeile um { $step }, wahrscheinlich sind es Minuten ({ $span_of_minutes } s mit { $rate_of_minutes } Hz) und nicht { $span } s mit { $rate } Hz; multiplizieren Sie die Spalte { $column } mit 60, oder zeichnen Sie mehr als { $brief } s auf
