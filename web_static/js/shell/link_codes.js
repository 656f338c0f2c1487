/** The codes in links that open this page. Each is taken out of the address, where the next person could read it. */

export const DEMO_LINK = /^#demo=(.+)$/;
export const INVITATION_LINK = /^#invite=(.+)$/;

/** The code of the link that was opened; empty when it was another one. @param {RegExp} link */
export function takeCode(link) {
  const found = link.exec(location.hash);
  if (!found) return "";
  history.replaceState(null, "", location.pathname);
  return decodeURIComponent(found[1]);
}
