### Texte zu den Bildern, nach denen gefahren wird: warum es keines gibt, und die Planansicht.

picture-webgl = Dieser Bildschirm kann die 3D-Ansicht nicht zeichnen: Sein Browser bietet kein WebGL 2. Schalten Sie im Browser die Grafikbeschleunigung ein, oder nutzen Sie die Planansicht von oben.
picture-context = Dieser Bildschirm kann die 3D-Ansicht zurzeit nicht zeichnen: Der Browser hat die Grafik dieser Seite abgeschaltet. Warten Sie, bis sie wieder da ist, oder nutzen Sie die Planansicht von oben.
picture-stale = Das Bild ist nicht live: Es ist älter als eine Sekunde. Warten Sie, oder nutzen Sie die Planansicht von oben.
picture-late = Die 3D-Ansicht ist noch nicht da. Warten Sie noch etwas, oder nutzen Sie die Planansicht von oben.
picture-coming = Die 3D-Ansicht wird geladen. Warten Sie einen Moment.
picture-none = Kein Bild zum Fahren
picture-plan-start = In der Planansicht fahren
picture-plan-show = Planansicht zeigen
picture-continue = „Fortsetzen“ braucht ein Bild.
picture-back = Zurück zu „Fahren“
picture-choose = Dieser Bildschirm kann die 3D-Ansicht nicht zeichnen: Sein Browser bietet kein WebGL 2. Durchgänge werden stattdessen in der Planansicht von oben gefahren. Auch eine Wiedergabe nutzt sie.
drawn-label = Planansicht von { $plan } mit der Strecke „{ $path }“ und dem Rollstuhl
drawn-group = Planansicht
drawn-heading = Mitdrehen
drawn-nearer = Näher
drawn-farther = Weiter weg
