// The explorer's table of axes, which changes at every pose.

import { Table } from "./table.js";

/** @import { Row } from "./table.js" */

export class LiveTable extends Table {
  kinds = ""; // of the rows that were shown last: their pairs and reasons

  /**
   * Show every row.  Rows like the last ones change in place: new ones would cost another layout of the page, and the
   * focus.
   * @param {string[]} names
   * @param {Row[]} rows
   * @param {number | null} lit
   */
  update(names, rows, lit) {
    const kinds = JSON.stringify(rows.map((row) => [row.pair, "reason" in row ? row.reason : null]));
    if (kinds === this.kinds) {
      const made = new Table(names, { pick: this.pick });
      made.show(rows, { lit });
      copyInto(this.element, made.element);
    } else {
      this.kinds = kinds;
      this.setNames(names);
      this.show(rows, { lit });
    }
  }
}

/**
 * Change an element, and what it contains, to what another one shows, which takes the place only of what is built
 * otherwise.
 * @param {Element} old
 * @param {Element} made
 */
function copyInto(old, made) {
  for (const name of new Set([...old.getAttributeNames(), ...made.getAttributeNames()])) {
    const value = made.getAttribute(name);
    if (value === null) old.removeAttribute(name);
    else if (value !== old.getAttribute(name)) old.setAttribute(name, value);
  }
  if (made.childElementCount && made.childElementCount === old.childElementCount) {
    for (const [i, child] of [...old.children].entries()) copyInto(child, made.children[i]);
  } else if (old.textContent !== made.textContent) old.replaceChildren(...made.childNodes);
}
