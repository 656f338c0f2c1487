### Texts of the settings: what the owner allows here, and the chairs that are paired.

prior-title = Help for new patients
prior-lead = From each calibration in use of a patient who consents, the program learns how people move in this shirt. A new patient can then drive the virtual chair after ten seconds of movement.
prior-on = Learn from calibrations in use
prior-few =
    { $count ->
        [one] Movements of one patient in the shirt in use are known; { $needed } patients are needed.
       *[other] Movements of { $count } patients in the shirt in use are known; { $needed } patients are needed.
    }
prior-enough =
    { $count ->
        [one] Movements of { $count } patient in the shirt in use are known.
       *[other] Movements of { $count } patients in the shirt in use are known.
    }
prior-off = Off: nothing is learnt, and new patients are calibrated first.
settings-title = Settings
settings-lead = These settings apply to the whole clinic.
settings-read-only = Only an owner can change these settings.
limits-title = The clinic's limits
limits-lead = Nobody drives faster than these limits. A set with higher numbers keeps its numbers, but the chair stays within these.
limits-saving = saving…
limits-saved = saved
log-lead = The log says who signed in, looked at something, changed something, drove or stopped, and when. Rows are added, but never changed or removed.
log-checking = The log is being checked…
log-check = Check again
tablets-title = Tablets
tablets-lead = Another tablet or computer opens these pages over the clinic's network, encrypted.
tablets-scan = Scan this with the tablet, or type the address. The page there explains the rest.
tablets-qr = QR code of { $url }
chairs-title = Chairs
chairs-lead = A paired chair shares a secret key with this program, and obeys nobody else.
chairs-none = No chair is paired yet. Without one, people drive the virtual chair.
chairs-address = at { $host }, port { $port }
chairs-facts = up to { $forward } m/s forward, { $reverse } m/s in reverse · paired { $when }
chairs-key = key { $key }
chairs-pair = Pair a chair
chairs-unpair = Unpair
chairs-unpair-label = Unpair { $name }
chairs-unpair-title = Unpair “{ $name }”?
chairs-unpair-lead = Its key is deleted here, so this program can no longer drive it. To drive it again, pair it anew.
chairs-unpaired = “{ $name }” is not paired any more.
pair-title = Pair a chair
pair-lead = The chair's own computer runs the receiver. It needs a key, which is made now.
pair-name = Name
pair-name-hint = What people here call this chair.
pair-host = Address
pair-host-hint = The chair's computer on this network, for example 192.168.1.40.
pair-port = Port
pair-port-hint = Its receiver listens there; { $port } unless another one was set there.
pair-speeds = What this chair may do
pair-speeds-hint = The smallest limit of the set, the clinic and the chair applies.
pair-go = Make the key
paired-title = The key of “{ $name }”, shown this once
paired-lead = It is not shown again, here or anywhere, because who has it can drive this chair. If it gets lost, unpair the chair and pair it anew.
paired-qr = QR code of the key of { $name }
paired-step-scan = On the chair's computer, make a file that only you can read. Put the line of this code into it, then press Enter and Ctrl-D:
paired-step-start = Start the receiver with it:
paired-outputs = Which output your chair needs in place of ros2
paired-step-look = Look at the Drive page: the chair answers there within a second.
paired-line = Key line, to type or copy
paired-copy = Copy the key line
paired-copied = The key line was copied. Clear the clipboard when it is on the chair.
paired-copy-failed = This browser does not let the page copy: mark the line and copy it yourself.
paired-done = The key is on the chair
