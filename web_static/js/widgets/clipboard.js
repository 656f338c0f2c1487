/**
 * Copy a text, and say so.
 * @param {import("../main.js").App} app @param {string} text
 * @param {string} copied what to say then @param {string} failed what to say when the browser refuses
 */
export async function copyText(app, text, copied, failed) {
  try {
    await navigator.clipboard.writeText(text);
    app.toasts.show(copied);
  } catch {
    app.toasts.show(failed); // browsers give the clipboard to encrypted pages only
  }
}
