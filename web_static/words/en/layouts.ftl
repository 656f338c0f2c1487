### Texts of the page of layouts: which sensors a shirt has, where they are, their joints; the editor of one.

rail-layouts = Layouts
layouts-lead = A layout says which sensors a shirt has, where each of them is on the body, and to which joint it belongs.
layouts-card = Layout
# $name: of the layout; $count: of its sensors.
layouts-card-now =
    { $count ->
        [one] { $name }, { $count } sensor
       *[other] { $name }, { $count } sensors
    }
layouts-own = Your layouts
layouts-none = None yet: make a new one, or duplicate one of those below.
layouts-bundled = Layouts that come with the software
# $channels: how many sensors; $joints: how many joints.
layouts-counts = Sensors: { $channels } · Joints: { $joints }
layouts-channels =
    { $count ->
        [one] { $count } sensor
       *[other] { $count } sensors
    }
# Marks a layout that the shirt has.
layouts-use-same = In use
layouts-use-changed = In use as it was before the last change
layouts-use = Use
layouts-use-label = Use “{ $name }”
layouts-used = The shirt now has the layout “{ $name }”.
layouts-use-no-shirt = No shirt is in use: choose one on the Shirt page.
layouts-use-own = The shirt in use has a layout of its own, which stays as it is.
layouts-edit = Edit
layouts-edit-label = Edit “{ $name }”
layouts-duplicate = Duplicate
layouts-duplicate-label = Duplicate “{ $name }”
layouts-copy = Copy of { $name }
layouts-export = Export
layouts-export-label = Export “{ $name }”
layouts-delete-label = Delete “{ $name }”
layouts-deleted = “{ $name }” was deleted.
layouts-gone = There is no such layout: it was deleted, or the address is wrong.
layouts-new = New layout
layouts-new-source = Where its sensors come from
layouts-from-stream = The shirt in use
layouts-from-stream-hint = Its sensors, as they arrive now.
layouts-from-file = A file of signals
layouts-from-file-hint = Its columns; joints are proposed by what moves together.
layouts-from-count = A number of sensors
layouts-from-count-hint = For a shirt that sends, and whose sensors nobody has named yet.
layouts-from-import = A file with a layout
layouts-from-import-hint = A JSON file, as Export makes it.
layouts-no-file = No file of signals is here: on the Shirt page choose “Replay of a file”, and add one.
layouts-count = Sensors
layouts-import-file = File
layouts-import-wrong = { $file }: this is no layout; choose a JSON file with the sensors of a shirt.
layouts-name = Name of the layout
layouts-new-name-hint = Left empty, it gets a name by itself.
layouts-new-go = Make the layout
layouts-whole = Whole body
# The name of a joint until somebody names it; $number from 1.
layouts-group = Group { $number }

## The editor

layouts-edit-title = Layout: { $name }
layouts-lead-live = Move one sensor: it lights up in the list and on the body. Choose it, then tap its place.
# $arriving, $count: how many sensors.
layouts-lead-not-live = Nothing lights up here: { $arriving } sensors arrive now, and this layout has { $count }.
layouts-body = On the body
layouts-body-hint = Tap, drag, or use the arrow keys.
# The chosen sensor on the body, for a screen reader.
layouts-mark-label = Place of { $name }
layouts-list = Sensors, in the order in which they arrive
# A row of the list: joint and place of a sensor.
layouts-row = { $joint } · { $place }
layouts-moves = moves now
layouts-channel-name = Name of the sensor
layouts-channel-name-hint = Letters without accents, digits, and _ . -
layouts-joint = Joint
layouts-joint-hint = Sensors of one joint are calibrated together.
layouts-joints-here = In this layout
layouts-joints-more = Others
layouts-joint-other = Another one…
# The name of a joint until somebody names it.
layouts-joint-new = New joint
# $side: Front or Back; $part: of the body.
layouts-place = { $side }: { $part }
layouts-place-none = Not on the body yet
layouts-place-take = Remove from the body
layouts-side = Side of the body
layouts-part-head = head
layouts-part-chest = chest
layouts-part-belly = belly
layouts-part-upper-back = upper back
layouts-part-lower-back = lower back
layouts-part-right-shoulder = right shoulder
layouts-part-right-upper-arm = right upper arm
layouts-part-right-elbow = right elbow
layouts-part-right-forearm = right forearm
layouts-part-right-wrist = right wrist
layouts-part-right-hand = right hand
layouts-part-left-shoulder = left shoulder
layouts-part-left-upper-arm = left upper arm
layouts-part-left-elbow = left elbow
layouts-part-left-forearm = left forearm
layouts-part-left-wrist = left wrist
layouts-part-left-hand = left hand
layouts-ring = One of a ring round a limb
layouts-ring-hint = Sensors of one joint that lie round the limb. They show when a sleeve was put on twisted.
layouts-ring-name = Name of the ring
layouts-ring-place = Which one, counted round the limb
# $ring: its name; $count: how many sensors it has.
layouts-ring-places =
    { $count ->
        [one] The sensor of the ring “{ $ring }” is alone in it: it has the number 1, or none.
       *[other] The sensors of the ring “{ $ring }” are counted 1 to { $count }, each number once, or none of them has a number.
    }
layouts-joints = Joints
layouts-joint-row-label = Which joint is “{ $joint }”
layouts-joint-name-label = Name of “{ $joint }”
layouts-propose = Propose joints
layouts-propose-hint = Somebody moves every joint freely for { $seconds } seconds, one after the other; sensors that move together are put into one group.
layouts-propose-move = Move now: every joint, one after the other.
layouts-propose-not-live = Joints can be proposed while a shirt with as many sensors sends.
# $names: of sensors.
layouts-propose-still = Not moved: { $names }.
layouts-propose-use = Use these groups
layouts-unsaved = There are changes that were not saved.
layouts-calibrations = A calibration keeps the layout in which it was made: calibrate again to use other joints.
layouts-save = Save
layouts-saved = “{ $name }” was saved.
layouts-discard = Discard the changes
layouts-back = All layouts
