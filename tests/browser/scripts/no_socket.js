// Where the address says so, no socket is ever opened.
if (location.search === "?cut") {
  window.WebSocket = class extends EventTarget {
    static OPEN = 1;
    readyState = 3;
    constructor() {
      super();
      setTimeout(() => this.dispatchEvent(new Event("close")), 50);
    }
    send() {}
    close() {}
  };
}
