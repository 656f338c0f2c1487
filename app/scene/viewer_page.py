"""viser's page with bodydrive's style and script in its head: it shows the canvas and the plots, and nothing else."""

import re
from pathlib import Path
from typing import Final

import viser

from app.texts import Text

# Only the canvas and the plots are visible, and nothing can be pressed or dragged. The rule hides every element without
# a canvas in it. A uPlot chart contains a canvas, so that the chart and its parents stay visible; the header and the
# grips of viser's panel are hidden. Without a scene the canvas is hidden: viser draws its cross of axes until then.
STYLE: Final = """
html, body { margin: 0; overflow: hidden; }
body, body div:has(> [data-dock-root]), body div:has(> div > [data-dock-root]) {
  background: linear-gradient(#d3e2ec, #eaf1f4 46%, #dfe6e4 54%, #d5dcd8) !important;
}
body :not(:has(canvas)):not(canvas):not(.uplot *) { display: none !important; }
html:not([data-scene]) canvas { visibility: hidden; }
* { pointer-events: none !important; touch-action: none; }
[data-floating-window] {
  left: auto !important; right: 12px !important; top: 12px !important; height: auto !important;
  width: clamp(200px, 30vw, 340px) !important; border-radius: 10px !important; overflow: hidden !important;
  background: #ffffffee !important; box-shadow: 0 1px 6px #16202a22 !important;
}
[data-floating-window] * { background: transparent !important; border: 0 !important; }
[data-floating-window] .u-title {
  font: 600 12px system-ui, sans-serif !important; color: #16202a; white-space: nowrap;
}
"""

# - viser's page reconnects to its server only while its document has the focus; a frame that was never touched has no
#   focus. hasFocus therefore always returns true.
# - Keys would move viser's camera and open its command palette. They are passed to the page around the frame instead.
# - viser starts a sorter for Gaussian splats that compiles code from text. The content security policy forbids that;
#   its error is ignored, since no splats are drawn.
# - data-scene marks the document while there is a scene: the node "/world" has arrived and is drawn. Before that, and
#   again after each reconnection, viser's page shows a cross of axes of its own, which the server cannot hide earlier.
# - bodydriveView.age() returns the age of the picture (s): the time since the last stamp, plus that stamp's lateness.
#   lag() returns the age of the drawn pose at its stamp (s): the time since its tick, plus the stamp's lateness.
#   draws() returns false while the canvas has no drawing context: the browser took it away or gave none.
SCRIPT: Final = """
Document.prototype.hasFocus = () => true;
window.addEventListener("unhandledrejection", (event) => {
  if (event.reason instanceof EvalError) event.preventDefault();
});
for (const kind of ["keydown", "keyup"]) {
  window.addEventListener(kind, (event) => {
    event.stopImmediatePropagation();
    if (window.parent !== window) {
      event.preventDefault();
      window.parent.document.dispatchEvent(new KeyboardEvent(kind, event));
    }
  }, true);
}
(() => {
  const DRAWN = 3;  // pictures after which a node that has arrived is drawn
  let pictures = 0;
  const look = () => {
    const nodes = window.__viserMutable && window.__viserMutable.nodePoseData;
    pictures = nodes && nodes["/world"] ? pictures + 1 : 0;
    document.documentElement.toggleAttribute("data-scene", pictures > DRAWN);
    requestAnimationFrame(look);
  };
  requestAnimationFrame(look);
})();
(() => {
  const WRAP = 100;  // s
  const STAMPS = 0.15;  // s; at least this often one comes when all is well
  const DRIFT = 2e-4;  // by which two clocks may part, so that an hour of it is not taken for lateness
  let stamp = null, seenAt = 0, least = 0, late = 0, tickAge = null, draws = true;
  const context = {webglcontextlost: false, webglcontextcreationerror: false, webglcontextrestored: true};
  for (const [kind, is] of Object.entries(context))
    window.addEventListener(kind, (event) => { if (event.target.isConnected) draws = is; }, true);
  setInterval(() => {
    const viewer = window.__viserMutable;
    if (!viewer) return;
    if (viewer.cameraControl) viewer.cameraControl.enabled = false;
    const node = viewer.nodePoseData && viewer.nodePoseData["/clock"];
    if (!node || !node.position || node.position[0] === stamp) return;
    const isFirst = stamp === null;
    stamp = node.position[0];
    tickAge = node.position[1];
    const now = performance.now() / 1000;
    least += DRIFT * (now - seenAt);
    seenAt = now;
    const offset = (((seenAt - stamp) % WRAP) + WRAP) % WRAP;
    late = isFirst ? 0 : ((offset - least + WRAP / 2) % WRAP + WRAP) % WRAP - WRAP / 2;
    if (isFirst || late < 0) { least = offset; late = 0; }
  }, 50);
  window.bodydriveView = {
    age: () => (stamp === null ? Infinity : performance.now() / 1000 - seenAt + late),
    tickAge: () => tickAge,
    draws: () => draws,
    lag: () => (stamp === null ? Infinity : Math.max(late + tickAge, performance.now() / 1000 - seenAt - STAMPS)),
  };
})();
"""


MARK: Final = """
body::after {
  content: "%s"; position: fixed; left: 10px; top: 10px; z-index: 9; padding: 3px 12px; border-radius: 99px;
  font: 700 15px system-ui, sans-serif; color: #fff; background: #8f5400; border: 2px solid #fff;
}
"""


def client_page(mark: str = "") -> bytes:
    """Return the page that shows a 3D view; `mark` is written on the picture, as "Replay" on one that is not live.

    Raises
    ------
    ValueError
        When viser's page has no title or no head, as no page of viser 1.1.1.
    """
    file = Path(viser.__file__).parent / "client" / "build" / "index.html"
    page = file.read_text(encoding="utf-8")
    page, titles = re.subn(r"<title>[^<]*</title>", "<title>bodydrive: view</title>", page, count=1)
    style = STYLE + MARK % mark if mark else STYLE
    head = f"<style>{style}</style><script>{SCRIPT}</script></head>"
    page, heads = re.subn(r"</head>", lambda _: head, page, count=1)
    if not (titles and heads):
        raise ValueError(Text("object-viser-page", file=str(file)))
    return page.encode()
