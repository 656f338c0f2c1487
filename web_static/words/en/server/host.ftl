### Texts about the computer that runs the program: what `bodydrive check` and the page "This computer" find, the
### clinic's certificates, and the installation of a service.

## What was measured. The control loop computes once each period, a tick, and should never be late.

host-lateness-good = Of { $ticks } ticks of the control loop, { $late } came more than { $limit } ms late; 99 of 100 came within { $most } ms, the latest after { $latest } ms.
host-lateness-attention = Of { $ticks } ticks of the control loop, { $late } came more than { $limit } ms late; 99 of 100 came within { $most } ms, the latest after { $latest } ms. Close other programs while driving.
host-lateness-bad = Of { $ticks } ticks of the control loop, { $late } came more than { $limit } ms late; 99 of 100 came within { $most } ms, the latest after { $latest } ms. This machine is too busy or too slow to drive a chair.
host-disk-good = { $free } GB of the disk are free.
host-disk-attention = { $free } GB of the disk are free. Make room soon.
host-disk-bad = { $free } GB of the disk are free. Nothing can be recorded: make room.
# $time is a day with a time of day.
host-clock = The clock shows { $time } UTC.
host-clock-early = The clock shows { $time } UTC, but the program was installed later: set the clock.
host-clock-kept = The clock shows { $time } UTC, and a time server keeps it right.
host-clock-not-kept = The clock shows { $time } UTC, and no time server keeps it right: compare it with a clock now and then.
host-port-own = Port { $port } is the one of this clinic.
host-port-of-system = Port { $port } is for the system: this account may not use it.
host-port-in-use = Port { $port } is in use, perhaps by the clinic itself.
host-port-free = Port { $port } is free.
host-compiled = The control loop's calculations run compiled.
host-not-compiled = The control loop's calculations run as plain Python: the same results, but slower.
# $name says whose screen it is, such as: The page of Ada
host-screen-silent = { $name } did not answer: it is out of view, locked or asleep.
host-screen-good = { $name } draws { $rate } pictures a second.
host-screen-slow = { $name } draws { $rate } pictures a second. Close other programs there, or choose the drawn plan.
host-summary-good = This computer is good enough for driving.
host-summary-attention = This computer is good enough for driving, and something could be better.
host-summary-bad = This computer is not good enough for driving as it is.

## Certificates: files and the days on which they begin or end

host-authority-made = A certificate authority was made for this clinic: each tablet installs it once, as the page below explains.
host-authority-replaced = The clinic's certificate authority was replaced: each tablet needs the new one, as the page below explains, and the old one can be removed there.
host-authority-damaged = The clinic's certificate authority in { $file } is damaged: put this file back from a backup, or delete it, and install the new authority on each tablet.
host-authority-ended = The clinic's certificate authority in { $file } ended on { $day }: delete this file, start again, and install the new authority on each tablet (if today is not { $today }, set this machine's clock instead).
host-authority-ends-soon = The clinic's certificate authority ends on { $day }: before that, delete { $file } and set up each tablet again.
host-authority-early-clock = This machine's clock shows { $today }, but the clinic's certificate authority was made later, on { $day }: set the clock, then start again.
# $names are names and addresses of the machine, with commas between them
host-authority-outside = The clinic's authority may not vouch for { $names }, which this machine did not have when the authority was made: open the pages by another address, or delete { $file } and set up each tablet again.
host-certificate-not-renewed = The machine's certificate could not be renewed ({ $why }): make room on the disk; it ends on { $day }.
host-certificate-ends-soon = The certificate { $file } ends on { $day }: replace it by a new one.
host-certificate-unreadable = { $file } cannot be read ({ $why }): name the files of your certificate.
host-certificate-no-pair = { $certificate } and { $key } are no certificate and its key: both must be PEM files, the key without a passphrase, and belong together.
host-certificate-ended = The certificate { $file } ended on { $day }, and this machine's clock shows { $today }: replace the file by a new certificate, or set the clock.
host-certificate-early-clock = The certificate { $file } begins on { $day }, and this machine's clock shows { $today }: set the clock.
# The name of the certificate in the settings of a device.
host-authority-title = bodydrive on { $machine }, made { $day }
# Stands for $machine when the machine has no name.
host-nameless-machine = this machine
# The settings of an iPad show these two, of the file that lets it trust the clinic's machine.
host-profile-title = bodydrive on { $machine }
host-profile-explanation = Lets this device trust the machine of your clinic that runs bodydrive, and nothing else: the certificate is limited to this machine and to private networks.

## The service that starts the clinic with the machine

# What systemd says of the service.
host-service-description = bodydrive: the clinic in { $folder }
host-service-no-systemd = This machine has no systemd: let it start the command of --print by its own means.
host-service-unwritable = { $file } cannot be written ({ $why }): with --system, run this with sudo.
host-service-refused = { $file } is written, but systemd did not take it ({ $why }): see to it, then try again.
# Stands in brackets when systemd gives no reason.
host-service-exit-code = exit code { $code }
host-service-installed = { $file } is installed and started; '{ $command }' shows its state.
host-service-starts-at-sign-in = It starts when you sign in; 'loginctl enable-linger' lets it start with the machine.
