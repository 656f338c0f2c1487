/** Whether this browser can draw in 3D at all: viser's page needs WebGL 2. */

/** Make a drawing context and give it back at once: a browser has few of them. */
export function canDrawIn3d() {
  try {
    const context = document.createElement("canvas").getContext("webgl2");
    context?.getExtension("WEBGL_lose_context")?.loseContext();
    return context !== null;
  } catch {
    return false;
  }
}
