### Texte zur Qualität der Steuerung: die Karte eines Durchgangs, der Verlauf über Durchgänge, die Warnungen.

quality-title = Qualität der Steuerung
quality-details = Details: Qualität der Steuerung
quality-none = Die Aufzeichnung dieses Durchgangs zeigt nicht, wie gut die Kalibrierung passte.
quality-lead = Wie gut die Kalibrierung zu den Bewegungen dieses Durchgangs passte.
quality-joint = Gelenk
quality-map-angle-deg = Winkel zur Kalibrierung
quality-evr = Klare Hauptbewegung
quality-null-space-share = Bewegung ohne Wirkung
quality-cross-talk = Mitbewegung
quality-activations = Gezählte Bewegungen
quality-activations-per-metre = Bewegungen pro Meter
quality-span-share = Genutzter Bereich
quality-rest-rate = Zittern in Ruhe
quality-means-map-angle-deg = zwischen der Hauptrichtung dieses Durchgangs und der der Kalibrierung
quality-means-evr = Anteil der Bewegung, der in einer Richtung liegt
quality-means-null-space-share = Anteil der Bewegung, der die Steuerung nie erreicht
quality-means-cross-talk = Anteil der Wirkung, der von anderen Bewegungen als der stärksten kommt
quality-means-activations-per-metre = gezählte Bewegungen pro gefahrenem Meter
quality-means-span-share = des kalibrierten Bereichs
quality-means-rest-rate = Anteil der vollen Bewegung pro Sekunde, dort, wo das Gelenk am ruhigsten war
quality-worst = Bei mehreren Gelenken zusammen gilt jeder Wert für das Gelenk, das am schlechtesten passt.
quality-guided = { $joints }: Die Standardkalibrierung wird hier nicht verwendet. Die Werte gelten trotzdem für sie. Sie zeigen, wie sich das Gelenk bewegt, nicht, wie es den Rollstuhl steuert.
quality-bad = Sensoren, die zeitweise unzuverlässig waren: { $sensors }.
quality-bad-one = { $name } ({ $share } der Zeit)
quality-still = Ein Gelenk ohne Werte hat sich weniger als 2 s bewegt.
quality-over = Qualität der Steuerung über die Durchgänge
quality-choose = Wert
quality-choose-joint = Gelenk
quality-all-joints = Alle Gelenke: das am schlechtesten passende
quality-trial = Durchgang
quality-empty = Kein Durchgang hier zeigt, wie gut die Kalibrierung passte.
quality-session = Sitzung { $number }
quality-map = Kalibrierung { $number }
quality-warnings =
    { $count ->
        [one] Ein Hinweis
       *[other] { $count } Hinweise
    }
quality-do = Das hilft:
quality-kind-sensor = Sensor: { $joints }
quality-kind-map = Kalibrierung: { $joints }
quality-kind-noise = Zittern oder Rauschen: { $joints }
quality-kind-span = kleinere Bewegung: { $joints }
quality-go-sensor = Zum Shirt
quality-go-map = Zur Kalibrierung
quality-go-noise = Zur Steuerung
quality-go-span = Zur Kalibrierung
