// Arrow keys on a page of its own, where no element has the focus.  (In a notebook they go from cell to cell.)

/** @import { Player } from "./player.js" */

/** @type {Player[]} The players of the page. */
const players = [];
/** @type {Player | null} The last one that the reader clicked or focused. */
let lastUsed = null;

/** @param {Player} player */
export function arrowKeys(player) {
  if (!players.length) document.addEventListener("keydown", arrowPressed);
  players.push(player);
  for (const kind of ["pointerdown", "focusin"]) {
    player.root.addEventListener(kind, () => {
      lastUsed = player;
    });
  }
}

/**
 * The key goes to the player that was used last if it is in view, else to the one that shows most of itself.
 * @param {KeyboardEvent} event
 */
function arrowPressed(event) {
  if (event.target !== document.body || event.shiftKey || !["ArrowLeft", "ArrowRight"].includes(event.key)) return;
  const visible = players.filter((player) => heightInView(player) > 0);
  const [most] = visible.toSorted((one, other) => heightInView(other) - heightInView(one));
  (visible.find((player) => player === lastUsed) ?? most)?.keyPressed(event);
}

/**
 * How much of the window's height a player takes; nothing where it is folded away.
 * @param {Player} player
 */
function heightInView({ root }) {
  const { top, bottom } = root.getBoundingClientRect();
  return root.checkVisibility() ? Math.min(bottom, innerHeight) - Math.max(top, 0) : 0;
}
