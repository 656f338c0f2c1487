### Errors in files: a calibration profile, a set of controls, a table of prompts, a prior of other people. They name the
### fields as the file does, and the name of the file may stand before the sentence.

## Profile and controls.

calibration-full-too-low = gesto “{ $gesture }”: “{ tune-full }” ({ $full } %) debe ser como mínimo { $least } %, un 1 % más que “{ tune-from }”, súbalo
calibration-gesture-twice = el gesto “{ $gesture }” aparece dos veces
calibration-gesture-joint = el gesto “{ $gesture }” usa la articulación “{ $joint }”, que la calibración no tiene, use una de estas: { $joints }
# $control is u1+, u1-, u2+, u2- or stop.
calibration-binding = { $control } está asignado al gesto “{ $gesture }”, que no existe, use uno de estos: { $gestures }
calibration-profile-means = articulación “{ $joint }”: channels y mean deben tener la misma longitud
calibration-profile-map = articulación “{ $joint }”: map dice “{ $map }”, pero la articulación no tiene “{ $map }”: añádalo
calibration-profile-parts = articulación “{ $joint }”: cada parte de la calibración { $map } debe tener un número por canal
calibration-profile-pca = articulación “{ $joint }”: la calibración pca no usa ningún canal
calibration-profile-covariance = articulación “{ $joint }”: covariance debe tener { $count } x { $count } números
calibration-profile-symmetric = articulación “{ $joint }”: covariance debe ser simétrica
calibration-profile-variance = articulación “{ $joint }”: covariance contiene una varianza menor que 0
calibration-profile-range = low y high deben tener { $count } números, uno por cada canal de la disposición
calibration-profile-noise = noise debe tener { $count } números, uno por cada canal de la disposición
calibration-profile-channel = la articulación “{ $joint }” usa un canal que la disposición no tiene

## Table of prompts.

calibration-prompts-no-joint = { $file }: no hay ninguna columna “joint”, añádala con el nombre de la articulación que se movió
# $place is a file and its line.
calibration-prompts-joint = { $place }: en “{ $layout }” no hay ninguna articulación “{ $joint }”, use una de estas: { $names }
calibration-prompts-order = { $place }: el movimiento pedido termina en { $end } s, que no es posterior a su comienzo en { $start } s, corríjalo o quítelo
calibration-prompts-outside = { $place }: el movimiento pedido de { $start } a { $end } s queda fuera de la grabación, que va de { $first } a { $last } s, corríjalo o quítelo

## Prior.

calibration-prior-short = hay { $seconds } s de movimiento, y la escala de los canales necesita { $least } s: grabe más tiempo
calibration-prior-no-joint = no hay ninguna articulación con movimientos pedidos y un canal que se pueda usar: pida sus movimientos o revise la camiseta
calibration-prior-moments = los momentos no concuerdan entre sí: haga de nuevo la entrada con `bodydrive prior add`
calibration-prior-ring = los números del anillo no concuerdan entre sí: haga de nuevo la entrada con `bodydrive prior add`
# The next two stand as $where in the three below them.
calibration-prior-entry = la entrada de “{ $code }”
calibration-prior-release = la publicación
calibration-prior-unknown-joint = { $where } nombra la articulación “{ $joint }”, que “{ $layout }” no tiene
calibration-prior-size = { $where } no tiene un número por cada canal de la articulación “{ $joint }”: hágala de nuevo
calibration-prior-ring-size = { $where } tiene en el anillo “{ $ring }” otro número de sensores ({ $count }) que “{ $layout }”
calibration-prior-release-own = una publicación contiene sumas y ninguna entrada de personas: únala sin --own
calibration-prior-two-entries = dos de ellos tienen entradas distintas de la persona “{ $code }”: dé otro código a una de las dos
calibration-prior-none = no hay ningún prior que unir: indique al menos uno
calibration-prior-layouts = las disposiciones “{ $first }” y “{ $second }” no tienen los mismos canales, articulaciones o anillos: cada camiseta necesita un prior propio
calibration-prior-no-file = { $file }: no existe este prior, compruebe su nombre
calibration-prior-unreadable = { $file }: este prior no se puede leer ({ $problem }), compruébelo
