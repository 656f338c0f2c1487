// The role of the notice of a page that has lost the program, without a cover over the page and with one.
() => import("/js/shell/notices.js").then(({ notices }) => {
  const live = Object.assign(new EventTarget(), { connected: false, receivedAt: 0, latest: null });
  const [route, root] = [{ page: "controls", rest: [] }, document.querySelector("main")];
  const app = Object.assign(new EventTarget(), { live, route, root, me: { signed_in: true }, halt: () => null });
  const notice = notices(app);
  const roles = [];
  for (const cover of [null, document.createElement("main")]) {
    if (cover) document.body.append(cover);
    live.dispatchEvent(new Event("connection"));
    roles.push(notice.getAttribute("role"));
    cover?.remove();
  }
  return roles;
})
