// A scene in a frame of another page: it says how high it is, and its picture fits the frame that it gets.

export function fitFrame() {
  const { body } = document;
  for (const link of document.querySelectorAll(".open a")) link.setAttribute("target", "_blank");
  const fit = () => {
    const board = document.querySelector(".sv-board");
    const picture = /** @type {SVGSVGElement | null} */ (board?.querySelector("svg.sv-picture") ?? null);
    body.style.removeProperty("--frame-room"); // first as high as the picture is by itself
    const height = Math.ceil(body.getBoundingClientRect().height);
    parent.postMessage({ satviz: "height", height }, "*");
    if (!board || !picture || height <= innerHeight) return;
    const room = innerHeight - (height - board.clientHeight);
    body.style.setProperty("--frame-room", `${Math.max(room, picture.viewBox.baseVal.height)}px`); // letters stay readable
  };
  new ResizeObserver(fit).observe(body);
  addEventListener("resize", fit);
}
