// Whether the place shows all of its words, inside the header and beside whatever else is there.
(one) => {
  const box = one.getBoundingClientRect();
  const parts = [...one.children].map((part) => part.getBoundingClientRect());
  const head = one.closest("header").getBoundingClientRect();
  const others = [...one.closest("header").querySelectorAll(".lamp, .me, .tools, .stop, .brand, .practice")]
    .filter((other) => other.checkVisibility()).map((other) => other.getBoundingClientRect());
  const overlaps = (other) => parts.some((part) => part.left < other.right - 1 && other.left < part.right - 1
    && part.top < other.bottom - 1 && other.top < part.bottom - 1);
  return box.width > 0 && parts.every((part) => part.left >= 0 && part.right <= innerWidth + 0.5
    && part.top >= head.top - 0.5 && part.bottom <= head.bottom + 0.5)
    && !others.some((other) => other.width && overlaps(other));
}
