### Texts about 3D objects (GLB files) and about the 3D view of a drive.

## An object that is refused. Most messages are the second half of object-unusable, without a full stop.

# reason: what the operating system says of it, in its own language.
object-file-unreadable = { $file }: this file cannot be read ({ $reason }), check it
object-unusable = { $file }: this object cannot be used, { $problem }
object-not-scaled = { $file }: the size of this object cannot be changed for certain, export it in metres
object-improbable = { $file }: this object is { NUMBER($length, useGrouping: 1) } x { NUMBER($width, useGrouping: 1) } x { NUMBER($height, useGrouping: 1) } m large as it says, which is improbable: choose its size, or export it in metres.
object-no-glb = it is no GLB file: export the object as glTF binary (.glb)
object-version = it is glTF version { $version }: export it as version 2
object-cut-off = it is cut off or damaged: export it again
object-damaged = it is damaged: export it again
object-no-description = its description cannot be read: export it again
object-parts-missing = it refers to parts that are not in it: export it again
object-lists-end = its lists end beyond its data: export it again
object-no-tree = its parts do not form a tree: export it again
object-nested = its parts are nested more than { $most } deep: export it again
object-far = some of its points are infinite or too far away: export it again
object-size-unknown = its size cannot be read for certain: export it again without animation and compression
object-large = it is larger than { $most } MB: make the object simpler
object-memory = it needs too much memory: make the object simpler
object-faces = it has { NUMBER($count, useGrouping: 1) } faces and at most { NUMBER($most, useGrouping: 1) } are drawn: make the object simpler
object-points = it has { NUMBER($count, useGrouping: 1) } points and at most { NUMBER($most, useGrouping: 1) } are read: make the object simpler
object-nodes = it has more than { NUMBER($most, useGrouping: 1) } nodes: join them before exporting
object-long-list = it has lists of more than { NUMBER($most, useGrouping: 1) } numbers: make the object simpler
object-numbers = its lists have more than { NUMBER($most, useGrouping: 1) } numbers: make the object simpler
object-targets = it has more than { $most } morph targets: export it in one shape
object-without-faces = there is nothing with faces in it: export a solid object
# name: of an extension of glTF, not translated.
object-extension = it needs '{ $name }', which is not read here: export it without compression or extensions
object-instances = it needs '{ $name }', which is not read here: export it without instances
object-compressed = it is compressed: export it without compression
object-draco = it is compressed with Draco: export it without compression
object-other-files = it needs other files: export everything into one GLB file
# A buffer is a part of a GLB file.
object-picture-elsewhere = its pictures lie in another buffer: export it again
object-picture-size = a picture on it is { NUMBER($width, useGrouping: 1) } x { NUMBER($height, useGrouping: 1) } pixels large, and at most { NUMBER($most, useGrouping: 1) } pixels are read: make it smaller
object-picture-pixels = a picture on it has more than { NUMBER($most, useGrouping: 1) } pixels: make it smaller
object-pictures-in-all = its pictures have more than { NUMBER($most, useGrouping: 1) } pixels in all: use fewer of them
object-picture-damaged = a picture on it is damaged: export it again
object-picture-unreadable = a picture on it is neither PNG nor JPEG, or damaged: export it again

## The 3D view

# The heading of a small panel beside the view, and of its two diagrams; m: metres.
object-plots = Plots
object-plot-driven = Driven over path, m
object-plot-error = Off the path in 30 s, m
object-port-closed = This port is for the program itself: open its own pages.
# viser: the library that draws the view.
object-viser-port = viser opened a port that everybody may read: install viser 1.1.1
object-viser-page = { $file }: this is not the page of viser 1.1.1, install that version
