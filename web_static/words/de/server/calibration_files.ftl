### Errors in files: a calibration profile, a set of controls, a table of prompts, a prior of other people. They name the
### fields as the file does, and the name of the file may stand before the sentence.

## Profile and controls.

calibration-full-too-low = Geste „{ $gesture }“: „{ tune-full }“ ({ $full } %) muss mindestens { $least } % sein, 1 % mehr als „{ tune-from }“; erhöhen Sie den Wert
calibration-gesture-twice = die Geste „{ $gesture }“ kommt zweimal vor
calibration-gesture-joint = die Geste „{ $gesture }“ liest das Gelenk „{ $joint }“, das es in der Kalibrierung nicht gibt; verwenden Sie eines von diesen: { $joints }
# $control is u1+, u1-, u2+, u2- or stop.
calibration-binding = { $control } ist der Geste „{ $gesture }“ zugeordnet, die es nicht gibt; verwenden Sie eine von diesen: { $gestures }
calibration-profile-means = Gelenk „{ $joint }“: channels und mean müssen gleich lang sein
calibration-profile-map = Gelenk „{ $joint }“: map ist „{ $map }“, aber „{ $map }“ fehlt; ergänzen Sie es
calibration-profile-parts = Gelenk „{ $joint }“: die Abbildung „{ $map }“ muss in jedem Teil eine Zahl pro Kanal haben
calibration-profile-pca = Gelenk „{ $joint }“: die Abbildung „pca“ liest keinen Kanal
calibration-profile-covariance = Gelenk „{ $joint }“: covariance muss { $count } Zeilen mit je { $count } Zahlen haben
calibration-profile-symmetric = Gelenk „{ $joint }“: covariance muss symmetrisch sein
calibration-profile-variance = Gelenk „{ $joint }“: covariance enthält eine Varianz unter 0
calibration-profile-range = low und high müssen { $count } Zahlen haben, eine pro Kanal des Layouts
calibration-profile-noise = noise muss { $count } Zahlen haben, eine pro Kanal des Layouts
calibration-profile-channel = das Gelenk „{ $joint }“ liest einen Kanal, den es im Layout nicht gibt

## Table of prompts.

calibration-prompts-no-joint = { $file }: es gibt keine Spalte „joint“; ergänzen Sie sie, mit dem Namen des Gelenks, das sich bewegt hat
# $place is a file and its line.
calibration-prompts-joint = { $place }: in „{ $layout }“ gibt es kein Gelenk „{ $joint }“; verwenden Sie eines von diesen: { $names }
calibration-prompts-order = { $place }: die Vorgabe endet bei { $end } s, also nicht nach ihrem Beginn bei { $start } s; korrigieren oder entfernen Sie sie
calibration-prompts-outside = { $place }: die Vorgabe von { $start } bis { $end } s liegt außerhalb der Aufzeichnung, die von { $first } bis { $last } s reicht; korrigieren oder entfernen Sie sie

## Prior.

calibration-prior-short = es gibt nur { $seconds } s Bewegung, und der Maßstab der Kanäle braucht { $least } s; zeichnen Sie länger auf
calibration-prior-no-joint = es gibt kein Gelenk, das vorgegeben wurde und einen brauchbaren Kanal hat; geben Sie eines vor, oder prüfen Sie das Shirt
calibration-prior-moments = die Momente passen nicht zusammen; erstellen Sie den Eintrag mit `bodydrive prior add` noch einmal
calibration-prior-ring = die Zahlen des Rings passen nicht zusammen; erstellen Sie den Eintrag mit `bodydrive prior add` noch einmal
# The next two stand as $where in the three below them.
calibration-prior-entry = der Eintrag von „{ $code }“
calibration-prior-release = die Fassung zur Weitergabe
calibration-prior-unknown-joint = { $where } nennt das Gelenk „{ $joint }“, das es in „{ $layout }“ nicht gibt
calibration-prior-size = { $where } hat nicht für jeden Kanal des Gelenks „{ $joint }“ eine Zahl; erstellen Sie das noch einmal
calibration-prior-ring-size = { $where } hat im Ring „{ $ring }“ eine andere Zahl von Sensoren ({ $count }) als „{ $layout }“
calibration-prior-release-own = eine Fassung zur Weitergabe enthält Summen und keine Einträge von Personen; führen Sie sie ohne --own zusammen
calibration-prior-two-entries = zwei davon haben verschiedene Einträge für die Person „{ $code }“; geben Sie einer davon einen anderen Code
calibration-prior-none = es ist keine Starthilfe zum Zusammenführen angegeben; nennen Sie mindestens eine
calibration-prior-layouts = die Layouts „{ $first }“ und „{ $second }“ haben verschiedene Kanäle, Gelenke oder Ringe; jedes Shirt braucht eine eigene Starthilfe
calibration-prior-no-file = { $file }: diese Starthilfe gibt es nicht; prüfen Sie ihren Namen
calibration-prior-unreadable = { $file }: diese Starthilfe lässt sich nicht lesen ({ $problem }); prüfen Sie sie
