// Arrow keys on a page of its own, where nothing has the focus.  (In a notebook they go from cell to cell.)

const steppers = []; // the players of the page
let used = null; // the last one that a hand or a key went to

export function arrowKeys(player) {
  if (!steppers.length) document.addEventListener("keydown", arrowPressed);
  steppers.push(player);
  for (const kind of ["pointerdown", "focusin"]) player.root.addEventListener(kind, () => { used = player; });
}

// To the player that was used last if it is in view, else to the one of which most is.
function arrowPressed(event) {
  if (event.target !== document.body || event.shiftKey || !["ArrowLeft", "ArrowRight"].includes(event.key)) return;
  const seen = steppers.filter((player) => inView(player) > 0);
  const most = seen.toSorted((one, other) => inView(other) - inView(one))[0];
  (seen.includes(used) ? used : most)?.key(event);
}

// How much of the window's height a player takes; none where it is folded away.
function inView({ root }) {
  const { top, bottom } = root.getBoundingClientRect();
  return root.checkVisibility() ? Math.min(bottom, innerHeight) - Math.max(top, 0) : 0;
}
