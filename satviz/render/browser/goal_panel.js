// A challenge: what it asks, how the scene stands to it, and a hint for readers who want one.

import { button, element } from "./elements.js";

/** @import { Goal } from "./messages.js" */

export class GoalPanel {
  /** @param {() => void} giveUp */
  constructor(giveUp) {
    this.asks = element("b");
    this.says = element("span");
    this.hint = element("p");
    const hint = element("details", {}, element("summary", {}, "a hint"), this.hint);
    this.giveUp = button("give up", giveUp);
    this.element = element("div", { class: "sv-goal", hidden: true }, this.asks, this.says, hint, this.giveUp);
  }

  /** @param {Goal | undefined} goal */
  show(goal) {
    this.element.hidden = !goal;
    if (!goal) return;
    this.element.classList.toggle("sv-met", goal.met);
    this.giveUp.hidden = goal.met;
    for (const name of /** @type {const} */ (["asks", "says", "hint"])) {
      if (this[name].textContent !== goal[name]) this[name].textContent = goal[name];
    }
  }

  /**
   * What is said aloud: what the challenge asks when it is new, then how the scene stands to it.
   * @param {Goal | undefined} goal
   */
  announcement(goal) {
    if (!goal) return [];
    const isNew = this.element.hidden || goal.asks !== this.asks.textContent;
    return [...(isNew ? [goal.asks] : []), ...(goal.met ? ["Done."] : []), goal.says];
  }
}
