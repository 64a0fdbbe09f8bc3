// Arrow keys on a page of its own, where no element has the focus.  (In a notebook they go from cell to cell.)

/** @typedef {{ root: HTMLElement, keyPressed: (event: KeyboardEvent) => void, everyArrow?: boolean }} Keyed A player or an explorer. */

/** @type {Keyed[]} The players and explorers of the page. */
let widgets = [];
/** @type {Keyed | null} The last one that the reader clicked or focused. */
let lastUsed = null;

/** @param {Keyed} widget */
export function arrowKeys(widget) {
  document.addEventListener("keydown", arrowPressed); // it is added once
  widgets = [...widgets.filter(({ root }) => root.isConnected), widget]; // one that left the page takes no memory
  for (const kind of ["pointerdown", "focusin"]) {
    widget.root.addEventListener(kind, () => {
      lastUsed = widget;
    });
  }
}

/**
 * The key goes to the widget that was used last if it is in view, else to the one that shows most of itself.  Up and
 * down scroll the page unless the reader has used an explorer, which takes every arrow then.
 * @param {KeyboardEvent} event
 */
function arrowPressed(event) {
  if (event.target !== document.body || event.altKey || event.ctrlKey || event.metaKey) return;
  const visible = widgets.filter((widget) => heightInView(widget) > 0);
  const [most] = visible.toSorted((one, other) => heightInView(other) - heightInView(one));
  const used = visible.find((widget) => widget === lastUsed);
  const aside = !event.shiftKey && ["ArrowLeft", "ArrowRight"].includes(event.key);
  if (aside || (used?.everyArrow && event.key.startsWith("Arrow"))) (used ?? most)?.keyPressed(event);
}

/**
 * How much of the window's height a widget takes; nothing where it is folded away.
 * @param {Keyed} widget
 */
function heightInView({ root }) {
  const { top, bottom } = root.getBoundingClientRect();
  return root.checkVisibility() ? Math.min(bottom, innerHeight) - Math.max(top, 0) : 0;
}
