### The camera of a tablet, laptop or phone as the shirt: on the Shirt page and on the patient's screen.

camera-title = The camera
camera-private = The picture stays on this device: nothing of it is stored or sent. The program receives only how the joints are placed, about 30 times a second.
camera-mirror = Mirror picture of the camera, with the joints that were found
camera-start = Start the camera
camera-stop = Stop the camera
# A button on the patient's screen.
camera-start-screen = Use this screen’s camera
camera-rate =
    { $count ->
        [one] { $count } picture a second.
       *[other] { $count } pictures a second.
    }

## What the camera does, and what to change.

camera-off = Sit so that head, arms and hips are in the picture, and nobody else is.
camera-asking = The browser asks for the camera: permit it.
camera-preparing = The camera gets ready. The first time this takes up to a minute.
camera-good = The camera sees you.
camera-lost = The camera sees nobody, and the chair stops: sit before it.
camera-back = Move back a little: head, shoulders and elbows must be in the picture.
camera-light = More light: the camera hardly sees you.
camera-slow = This device reads only { $count } pictures a second, and movements are lost: close other programs, or use another device.

## Why there is no camera.

camera-insecure = Browsers give the camera only to pages over https: open this page that way, or on this machine itself.
camera-none = There is no camera here: connect one, or open this page on a tablet or phone.
camera-denied = The browser does not permit the camera: permit it for this page in the browser’s settings.
camera-busy = Another program uses the camera: close it, and start the camera again.
camera-failed = The camera’s pictures cannot be read: load this page again, or use a current Chrome, Edge, Firefox or Safari.
camera-taken = Another page is the camera: stop it there first.
camera-unwanted = The camera is not the shirt in use: choose it on the Shirt page.
