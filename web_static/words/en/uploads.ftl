### Texts of uploads: names that are taken, objects of an improbable size, and files that were replaced.

same-name-keep-both = Keep both, the new one as { $name }
same-name-replace = Replace it
same-name-kept = What is replaced can be put back for { $days } days.
object-scale-size = { $size } m
object-scale-as-it-says = { $size } m, as it says
replaced-title = Replaced in the last { $days } days
replaced-when = Replaced on { $day }; removed for good on { $until }.
replaced-put-back = Put back
replaced-put-back-label = Put back { $name }
replaced-back = { $name } is back.
