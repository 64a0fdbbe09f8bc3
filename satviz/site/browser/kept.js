// What this reader's own browser keeps; a browser that keeps nothing, or has no room, works all the same.

const OURS = "satviz-"; // begins the names of what is kept

/** @param {string} name */
export function kept(name) {
  try {
    return localStorage.getItem(OURS + name);
  } catch {
    return null;
  }
}

/**
 * @param {string} name
 * @param {string | null} text Null: forget it.
 */
export function keep(name, text) {
  try {
    if (text === null) localStorage.removeItem(OURS + name);
    else localStorage.setItem(OURS + name, text);
  } catch {} // nothing is kept
}

/**
 * @param {string} name
 * @returns {unknown} The JSON value that is kept; null where there is none, or where another page has left something.
 */
export function keptValue(name) {
  try {
    return JSON.parse(kept(name) ?? "null");
  } catch {
    return null;
  }
}
