### Texts of the pictures to drive by: why there is none, and the drawn plan.

picture-webgl = This screen cannot draw the 3D view: its browser offers no WebGL 2. Switch on graphics acceleration in the browser, or use the drawn plan from above.
picture-context = This screen cannot draw the 3D view at the moment: the browser has switched off the graphics of this page. Wait until they are back, or use the drawn plan from above.
picture-stale = The picture is not live: it is older than a second. Wait, or use the drawn plan from above.
picture-late = The 3D view has not come yet. Wait a little longer, or use the drawn plan from above.
picture-coming = The 3D view is on its way. Wait a moment.
picture-none = No picture to drive by
picture-plan-start = Drive in the drawn plan
picture-plan-show = Show the drawn plan
picture-continue = Continue needs a picture.
picture-back = Back to Drive
picture-choose = This screen cannot draw the 3D view: its browser offers no WebGL 2. Trials are driven in the drawn plan from above instead, and a replay shows it too.
drawn-label = Drawn plan of { $plan } with the path “{ $path }” and the chair
drawn-group = Drawn plan
drawn-heading = Heading up
drawn-nearer = Nearer
drawn-farther = Farther
