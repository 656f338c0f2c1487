### Texts about files of signals (CSV or Parquet): what is wrong with one, and what was mended. Most begin with the name
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
signals-no-csv = { $file }: das ist keine CSV-Datei, sondern eine binäre oder eine, die nicht in UTF-8 ist; speichern Sie sie als CSV in UTF-8 oder als Parquet
signals-csv-unreadable = { $file }: diese CSV-Datei lässt sich nicht lesen ({ $reason }); speichern Sie sie neu
signals-no-parquet = { $file }: das ist keine Parquet-Datei; speichern Sie sie als Parquet, oder geben Sie ihr den Namen einer CSV-Datei
signals-parquet-damaged = { $file }: diese Parquet-Datei wurde abgeschnitten oder geändert und ist nicht lesbar; speichern Sie sie neu
signals-numbers = { $file }: das enthält mehr als { NUMBER($most, useGrouping: 1) } Zahlen; teilen Sie es in kürzere Aufzeichnungen
signals-empty = { $file }: diese Datei ist leer (oder beginnt mit einer leeren Zeile); nennen Sie eine andere
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
       *[commas] { $decimal ->
            [comma] Gelesen mit Kommas zwischen den Spalten und mit Dezimalkomma.
           *[point] Gelesen mit Kommas zwischen den Spalten und mit Dezimalpunkt.
        }
    }

## Channels. “t” is the name of the column of times.

signals-no-channel = { $file }: neben „t“ gibt es keinen Kanal; ergänzen Sie eine Spalte für jeden Kanal
signals-channels = { $file }: { $count } Kanäle sind mehr, als ein Shirt haben kann; behalten Sie höchstens { $most }
signals-channel-named-t = { $file }: das Layout „{ $layout }“ hat einen Kanal „t“, aber so heißt die Zeit; benennen Sie den Kanal um
# names: one name or several.
signals-channel-missing = { $file }: in dieser Aufzeichnung fehlen Kanäle des Layouts „{ $layout }“ ({ $names }); ergänzen Sie, was fehlt, oder verwenden Sie das Layout des Shirts, das aufgezeichnet wurde
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

## Times, in the column t

signals-time-large = { $file }: t geht von { $first } bis { $last }; geben Sie die Zeit in Sekunden an
signals-time-constant = { $file }: t ist in jeder Zeile { $time }; geben Sie die Zeit jedes Abtastwerts in Sekunden an
signals-time-backwards = { $place }: die Zeit läuft dort rückwärts (t = { $after } nach { $before }); sortieren Sie die Zeilen, oder entfernen Sie den Teil, der zweimal aufgezeichnet wurde
signals-time-jumps = { $place }: t springt dort um { $seconds } s ({ $hours } Stunden); behalten Sie den Teil davor oder danach, oder korrigieren Sie die Spalte t
signals-rate-changes = { $place }: die Abtastrate ändert sich dort (t = { $time } s); teilen Sie die Datei in Teile mit je einer Abtastrate
signals-uneven = { $file }: t steigt von Zeile zu Zeile um { $least } bis { $most } s, ohne gleichmäßige Abtastrate; exportieren Sie zu jedem Abtastwert die Zeit des Geräts selbst, oder rechnen Sie die Datei auf eine gleichmäßige Abtastrate um
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
signals-steps-spread = Die Schritte von t sind verschieden, die Abtastwerte aber gleichmäßig: Sie wurden gleichmäßig verteilt, mit { $rate } Hz.
signals-gaps =
    { $count ->
        [one] Zwischen den Abtastwerten ist { NUMBER($count, useGrouping: 1) } Lücke, von { $longest } s, vor { $place }.
       *[other] Zwischen den Abtastwerten sind { NUMBER($count, useGrouping: 1) } Lücken, die längste von { $longest } s, vor { $place }.
    }

## Times in another unit than seconds. step: by how much t rises.

signals-unit-counter = { $file }: t muss in Sekunden sein, steigt aber von Zeile zu Zeile um { $step }, wahrscheinlich als Zähler der Abtastwerte; teilen Sie die Spalte t durch die Abtastrate in Hz
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
signals-unit-other = { $file }: t muss in Sekunden sein, steigt aber von Zeile zu Zeile um { $step }, wahrscheinlich sind es { $unit }; multiplizieren Sie die Spalte t mit { $factor }
signals-unit-one-of-two = { $file }: t muss in Sekunden sein, steigt aber von Zeile zu Zeile um { $step }, wahrscheinlich sind es { $unit } oder { $or_unit }; multiplizieren Sie die Spalte t mit { $factor } oder { $or_factor }
signals-unit-or-slow = { $file }: t muss in Sekunden sein, steigt aber von Zeile zu Zeile um { $step }, wahrscheinlich in einer anderen Einheit, oder die Abtastung war zu langsam; schreiben Sie die Zeit in Sekunden, und zeichnen Sie mit { $slowest } bis { $fastest } Hz auf
signals-unit-or-fast = { $file }: t muss in Sekunden sein, steigt aber von Zeile zu Zeile um { $step }, wahrscheinlich in einer anderen Einheit, oder die Abtastung war zu schnell; schreiben Sie die Zeit in Sekunden, und zeichnen Sie mit { $slowest } bis { $fastest } Hz auf
# span, rate: of the recording if t is in seconds; span_of_minutes (s), rate_of_minutes (Hz): if it is in minutes.
signals-unit-minutes = { $file }: t muss in Sekunden sein, steigt aber von Zeile zu Zeile um { $step }, wahrscheinlich sind es Minuten ({ $span_of_minutes } s mit { $rate_of_minutes } Hz) und nicht { $span } s mit { $rate } Hz; multiplizieren Sie die Spalte t mit 60, oder zeichnen Sie mehr als { $brief } s auf
