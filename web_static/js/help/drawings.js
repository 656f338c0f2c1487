/** One small drawing for each page, in lines: `quiet` lies behind, `main` is what the page is about. */
import { s } from "../widgets/dom.js";

/** @type {Record<string, {quiet: string, main: string}>} */
const LINES = {
  patients: {
    quiet: "M20 70h60M20 84h40M120 70h60M120 84h40",
    main: "M50 40a12 12 0 1 0 0-24 12 12 0 0 0 0 24ZM30 60c2-12 10-16 20-16s18 4 20 16M150 40a12 12 0 1 0 0-24 12 12 0 0 0 0 24ZM130 60c2-12 10-16 20-16s18 4 20 16",
  },
  shirt: {
    quiet: "M82 10 54 24l10 24 12-5v47h48V43l12 5 10-24-28-14c-4 8-10 11-18 11s-14-3-18-11Z",
    main: "M86 40h.1M100 36h.1M114 40h.1M88 54h.1M112 54h.1M90 70h.1M110 70h.1M70 32h.1M130 32h.1",
  },
  layouts: {
    quiet:
      "M52 10 24 24l10 24 12-5v47h48V43l12 5 10-24-28-14c-4 8-10 11-18 11s-14-3-18-11ZM140 34h40M140 54h40M140 74h40",
    main: "M56 40h.1M84 40h.1M70 58h.1M128 34h.1M128 54h.1M128 74h.1M118 58l-40 2M86 54l-8 6 8 6",
  },
  calibrate: {
    quiet: "M20 88h160M28 88v-6M60 88v-6M92 88v-6M124 88v-6M156 88v-6",
    main: "M100 72a28 28 0 1 0 0-56 28 28 0 0 0 0 56ZM100 16v28l18 12",
  },
  controls: {
    quiet: "M30 30h140M30 52h140M30 74h140",
    main: "M74 22v16M74 30h40M114 22v16M56 44v16M92 44v16M92 66v16M148 66v16M92 74h56",
  },
  drive: {
    quiet: "M20 14h160v72H20ZM84 14v34M130 86V56",
    main: "M40 72V60h66V34h40M40 80l-7-12h14ZM152 34a6 6 0 1 0-12 0 6 6 0 0 0 12 0Z",
  },
  "drive.tasks": {
    quiet: "M20 18h44v28H20ZM78 18h44v28H78ZM136 18h44v28h-44ZM20 58h44v28H20ZM136 58h44v28h-44Z",
    main: "M78 58h44v28H78ZM88 72l8 8 16-16",
  },
  "drive.chairs": {
    quiet: "M20 20h70v60H20ZM110 20h70v60h-70Z",
    main: "M46 34v22h20M42 56a9 9 0 1 0 0 18 9 9 0 0 0 0-18ZM136 34v22h20M132 56a9 9 0 1 0 0 18 9 9 0 0 0 0-18ZM160 60v14",
  },
  "drive.chair": {
    quiet: "M18 20h38v28H18ZM18 56h38v28H18ZM66 20h38v28H66ZM26 34h22M26 70h22M74 34h22",
    main: "M130 20v36h30l10 24M124 52a16 16 0 1 0 0 32 16 16 0 0 0 0-32ZM80 62v12M80 80h.1",
  },
  "drive.screen": {
    quiet: "M20 22h60v44H20ZM40 78h20M50 66v12",
    main: "M100 12h80v58h-80ZM128 86h24M140 70v16M118 60l16-34h12l16 34M86 44h8",
  },
  "drive.over": {
    quiet: "M20 80V26h76M120 30h60M120 48h60M120 66h40",
    main: "M20 80c2-30 6-44 20-50s36-2 56-4M96 26a5 5 0 1 0 0 .1",
  },
  review: {
    quiet: "M28 12v74h152",
    main: "M36 24c18 38 40 48 140 52M50 34h.1M74 58h.1M98 64h.1M122 72h.1M146 72h.1M170 78h.1",
  },
  settings: {
    quiet: "M26 24h60M26 48h60M26 72h60",
    main: "M120 16h40a8 8 0 0 1 0 16h-40a8 8 0 0 1 0-16ZM158 24h.1M120 40h40a8 8 0 0 1 0 16h-40a8 8 0 0 1 0-16ZM122 48h.1M120 64h40a8 8 0 0 1 0 16h-40a8 8 0 0 1 0-16ZM158 72h.1",
  },
  plans: { quiet: "M24 86V14h152v72h-60M88 14v30", main: "M24 86h52M150 20l14 14-46 46-18 4 4-18Z" },
  adapt: { quiet: "M30 84 150 24", main: "M30 84 168 44M150 34a70 70 0 0 1 8 14M158 48l-12 1M158 48l3-12" },
  interface_test: {
    quiet: "M30 50h140M100 8v84",
    main: "M148 38a12 12 0 1 0 0 24 12 12 0 0 0 0-24ZM100 50c14-10 22 8 34 0M100 46a4 4 0 1 0 0 8 4 4 0 0 0 0-8Z",
  },
  import_recording: {
    quiet: "M30 12h46l18 18v58H30ZM76 12v18h18M40 42h42M40 54h42M40 66h26",
    main: "M104 50h28M122 40l10 10-10 10M142 50h6l6-20 8 40 6-28 4 8h8",
  },
  people: {
    quiet:
      "M24 86c2-16 12-22 26-22M176 86c-2-16-12-22-26-22M50 54a10 10 0 1 0 0-20 10 10 0 0 0 0 20ZM150 54a10 10 0 1 0 0-20 10 10 0 0 0 0 20Z",
    main: "M100 46a14 14 0 1 0 0-28 14 14 0 0 0 0 28ZM70 86c3-20 14-28 30-28s27 8 30 28",
  },
  backup: {
    quiet: "M24 26h60v48H24ZM34 38h40M34 50h40M34 62h24",
    main: "M94 50h30M114 40l10 10-10 10M134 22h42v56h-42ZM144 64h22M144 34h.1",
  },
  computer: { quiet: "M30 14h140v56H30ZM76 86h48M100 70v16", main: "M44 54h22l8-26 14 38 12-24 8 12h48" },
  session: {
    quiet: "M50 12h76l24 24v52H50ZM126 12v24h24",
    main: "M64 34h40M64 48h70M64 62h52M64 80c8-8 12-8 16 0s10 2 16-4M124 74l6 7 12-13",
  },
  share: {
    quiet: "M20 14h76v72H20ZM34 30h48M34 44h48M34 58h30",
    main: "M96 50h34M120 40l10 10-10 10M140 46h40v34h-40ZM148 46v-8a12 12 0 0 1 24 0v8M160 60v8",
  },
  attention: {
    quiet: "M60 22h100M60 50h80M60 78h90",
    main: "M34 12v14M34 32h.1M26 50a8 8 0 1 0 16 0 8 8 0 0 0-16 0ZM26 78l6 6 12-12",
  },
  log: {
    quiet: "M60 20h116M60 42h116M60 64h80M60 86h100",
    main: "m24 18 6 6 12-12M24 40l6 6 12-12M24 62l6 6 12-12M24 84l6 6 12-12",
  },
};

/** The drawing of a page, which says nothing that its sentences do not say. @param {string} page */
export function drawing(page) {
  const { quiet, main } = LINES[page];
  return s(
    "svg",
    { viewBox: "0 0 200 100", "aria-hidden": "true" },
    s("path", { class: "quiet-lines", d: quiet }),
    s("path", { class: "main-lines", d: main }),
  );
}

/** Tell whether there is a drawing of a page. @param {string} page */
export function hasDrawing(page) {
  return page in LINES;
}
