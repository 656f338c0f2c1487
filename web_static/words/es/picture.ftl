### Texts of the pictures to drive by: why there is none, and the drawn plan.

picture-webgl = Esta pantalla no puede dibujar la vista 3D: su navegador no ofrece WebGL 2. Active la aceleración gráfica en el navegador, o use el plano dibujado desde arriba.
picture-context = Esta pantalla no puede dibujar la vista 3D en este momento: el navegador ha desactivado los gráficos de esta página. Espere a que vuelvan, o use el plano dibujado desde arriba.
picture-stale = La imagen no está en directo: tiene más de un segundo. Espere, o use el plano dibujado desde arriba.
picture-late = La vista 3D todavía no ha llegado. Espere un poco más, o use el plano dibujado desde arriba.
picture-coming = La vista 3D está en camino. Espere un momento.
picture-none = No hay imagen para conducir
picture-plan-start = Conducir con el plano dibujado
picture-plan-show = Mostrar plano dibujado
picture-continue = Continuar necesita una imagen.
picture-back = Volver a Conducir
picture-choose = Esta pantalla no puede dibujar la vista 3D: su navegador no ofrece WebGL 2. En su lugar, los ensayos se conducen con el plano dibujado desde arriba, y la reproducción también lo muestra.
drawn-label = Plano dibujado de { $plan } con el recorrido “{ $path }” y la silla
drawn-group = Plano dibujado
drawn-heading = Rumbo arriba
drawn-nearer = Acercar
drawn-farther = Alejar
