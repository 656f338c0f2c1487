// Collects what live regions say: the text that is added to one, with how urgently.
() => {
  const LIVE = { status: "polite", alert: "assertive", log: "polite", timer: "off", output: "polite" };
  const urgency = (node) => {
    for (let one = node.nodeType === 1 ? node : node.parentElement; one; one = one.parentElement) {
      const live = one.getAttribute("aria-live") ?? LIVE[one.getAttribute("role") ?? one.localName];
      if (live) return live;
    }
    return "off";
  };
  window.said = [];
  const collect = (node) => {
    const words = node.textContent.trim().replaceAll(/\s+/g, " ");
    const live = urgency(node);
    const element = node.nodeType === 1 ? node : node.parentElement;
    const isShown = element?.checkVisibility() && !element.closest("[inert]");
    if (words && live !== "off" && isShown) window.said.push([live, words]);
  };
  new MutationObserver((changes) => {
    for (const { type, target, addedNodes } of changes) {
      if (type === "characterData") collect(target);
      else for (const node of addedNodes) collect(node);
    }
  }).observe(document.body, { childList: true, subtree: true, characterData: true });
}
