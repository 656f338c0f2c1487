/**
 * Loads the program of a page when the browser has drawn the page's first picture: loading it before would delay that
 * picture, and a person would look at an empty page.
 */
const LONGEST_WAIT = 400; // ms: a page in the background draws no picture

const program = /** @type {HTMLTemplateElement} */ (document.querySelector("#program"));
const load = () => document.head.append(program.content); // empty the second time
const watch = new PerformanceObserver((drawn) => {
  if (drawn.getEntriesByName("first-contentful-paint").length) load();
});
watch.observe({ type: "paint", buffered: true });
setTimeout(load, LONGEST_WAIT);
