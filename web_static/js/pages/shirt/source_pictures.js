/** A small picture of each source of movements, in lines: behind is a person, in front what senses that person. */
import { h } from "../../preact.js";

const PERSON = "M48 23a8 8 0 1 0 0-16 8 8 0 0 0 0 16ZM27 60c0-20 6-30 21-30s21 10 21 30";
const PERSON_ASIDE = "M30 23a8 8 0 1 0 0-16 8 8 0 0 0 0 16ZM9 60c0-20 6-30 21-30s21 10 21 30";

/** Each fills a box of 96 by 64. @type {Record<string, {behind: string, front: string}>} */
const PICTURES = {
  camera: { behind: PERSON_ASIDE, front: "M68 12h20v34H68ZM78 18h.1M62 22 48 15M62 34 54 40M74 58h8" },
  phones: {
    behind: PERSON,
    front: "M21 36h9v16h-9ZM66 36h9v16h-9ZM25 48h.1M70 48h.1M14 36a14 14 0 0 0 0 16M82 36a14 14 0 0 1 0 16",
  },
  slimevr: { behind: PERSON, front: "M43 38h10v9H43ZM24 46h9v9h-9ZM63 46h9v9h-9ZM48 42h.1M28 50h.1M67 50h.1" },
  bluetooth: {
    behind: PERSON,
    front: "M24 46h9v9h-9ZM63 46h9v9h-9ZM28 50h.1M67 50h.1M44 42l8 8-4 4V38l4 4-8 8",
  },
  serial: {
    behind: PERSON_ASIDE,
    front: "M16 44l6-4 6 4 6-4 6 4M51 52h12M63 44h22v16H63ZM69 44v-5M74 44v-5M79 44v-5M69 54h.1M79 54h.1",
  },
  brainflow: {
    behind: PERSON_ASIDE,
    front: "M24 8c10-6 22 2 36 12M30 34c10 2 20 0 30-2M60 14h28v30H60ZM66 22h.1M66 29h.1M66 36h.1M72 36l3-12 3 8 3-4h3",
  },
  udp: {
    behind: PERSON_ASIDE,
    front: "M16 44l6-4 6 4 6-4 6 4M56 26a14 14 0 0 1 0 16M61 20a24 24 0 0 1 0 28M70 22h18v24H70ZM76 30h6M76 38h6",
  },
  lsl: {
    behind: "M8 10h24v16H8ZM8 38h24v16H8ZM12 18h16M12 46h16",
    front: "M32 18c16 0 12 14 28 14M32 46c16 0 12-14 28-14M60 32h12M67 27l5 5-5 5M76 20h12v24H76Z",
  },
  simulator: {
    behind: "M12 6h72v44H12ZM36 60h24M48 50v10",
    front: "M48 23a6 6 0 1 0 0-12 6 6 0 0 0 0 12ZM34 44c0-11 4-16 14-16s14 5 14 16",
  },
  replay: { behind: "M20 4h38l18 18v38H20ZM58 4v18h18", front: "M30 28c4-8 8-8 12 0s8 8 12 0M42 38l14 8-14 8Z" },
};
/** A shirt, of a kind that has no picture of its own. */
const SHIRT = {
  behind: "",
  front: "M34 8 14 18l8 18 9-4v26h34V32l9 4 8-18-20-10c-2 5-7 8-14 8s-12-3-14-8Z",
};

/** It says nothing that the words beside it do not say. @param {{kind: string}} picture of a kind of shirt */
export function SourcePicture({ kind }) {
  const { behind, front } = PICTURES[kind] ?? SHIRT;
  return h(
    "svg",
    { class: "source-picture", viewBox: "0 0 96 64", "aria-hidden": "true" },
    behind && h("path", { class: "behind", d: behind }),
    h("path", { d: front }),
  );
}
