// The table of axes.

import { button, element } from "./elements.js";

const SHORT = 34; // letters of two ranges that fit beside each other in a narrow table

/**
 * An axis of the table: tested, or skipped for a reason.
 * @typedef {object} TestedRow
 * @property {string} pair The pair of convex parts, empty where there is one pair.
 * @property {string} axis
 * @property {number} number
 * @property {number} gap
 * @property {string} outcome
 * @property {string} a The range of A on the axis.
 * @property {string} b
 */
/** @typedef {{ pair: string, axis: string, reason: string }} SkippedRow */
/** @typedef {TestedRow | SkippedRow} Row */

// A row is lit, greyed or still empty.  An empty row does not show whether its axis will be tested, since that tells
// where the run stops.
export class Table {
  /**
   * @param {string[]} names Of the two shapes.
   * @param {{ pick?: (row: number) => void }} [options] `pick` makes the rows buttons.
   */
  constructor(names, { pick } = {}) {
    this.pick = pick;
    this.head = element("tr");
    this.body = element("tbody");
    this.element = element("table", { class: "sv-table", "aria-label": "the axes and their ranges" }, element("thead", {}, this.head), this.body);
    this.names = names;
    this.setNames(names);
  }

  /** @param {string[]} names */
  setNames(names) {
    const heads = ["axis", ...names, "gap"].map((name) => element("th", { scope: "col" }, name));
    this.head.replaceChildren(element("td"), ...heads);
    this.names = names;
  }

  /**
   * @param {Row[]} rows
   * @param {{ lit?: number | null, known?: (row: number) => boolean }} [options] `known`: does a row show its result?
   */
  show(rows, { lit = null, known = () => true } = {}) {
    let pair = "";
    const lines = [];
    for (const [i, row] of rows.entries()) {
      if (row.pair !== pair) {
        pair = row.pair;
        lines.push(element("tr", { class: "sv-pair" }, element("th", { colspan: 5, scope: "rowgroup" }, pair)));
      }
      lines.push(this.line(row, i, lit === i, known(i)));
    }
    this.body.replaceChildren(...lines);
    const short = rows.every((row) => !row.pair && ("reason" in row || row.a.length + row.b.length <= SHORT));
    this.element.classList.toggle("sv-short", short); // each range stays on one line
  }

  /**
   * @param {Row} row
   * @param {number} i
   * @param {boolean} lit
   * @param {boolean} known
   */
  line(row, i, lit, known) {
    const skipped = "reason" in row;
    const classes = `${lit ? "sv-lit" : ""} ${skipped && known ? "sv-skipped" : ""}`.trim();
    const number = known || lit ? String(skipped ? "–" : row.number) : "";
    const name = this.pick && !skipped ? button(`show ${row.axis}`, () => this.pick?.(i), { content: row.axis }) : row.axis;
    const cells = [element("td", {}, number), element("td", {}, name), ...this.result(row, known)];
    return element("tr", { class: classes, "aria-current": lit ? "step" : null }, ...cells);
  }

  /**
   * @param {Row} row
   * @param {boolean} known
   */
  result(row, known) {
    if ("reason" in row && known) return [element("td", { colspan: 3, class: "sv-reason" }, row.reason)];
    const shown = known && !("reason" in row) ? row : { a: "", b: "", outcome: "", gap: null };
    const role = shown.gap === null ? "" : shown.gap >= 0 ? "sv-gap" : "sv-overlap";
    const [a, b] = this.names;
    const outcome = shown.outcome.split(/(?<=,)( )/).map((part) => (part === " " ? part : element("span", {}, part))); // breaks after a comma only
    return [element("td", { class: "sv-A", "data-of": a }, shown.a), element("td", { class: "sv-B", "data-of": b }, shown.b), element("td", { class: role }, ...outcome)];
  }
}
