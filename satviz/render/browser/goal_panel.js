// A challenge: its task, the state of the scene, and a hint for readers who want one.

import { button, element } from "./elements.js";

/** @import { Goal } from "./messages.js" */

export class GoalPanel {
  /** @param {() => void} giveUp */
  constructor(giveUp) {
    this.task = element("b");
    this.status = element("span");
    this.hint = element("p");
    const hint = element("details", {}, element("summary", {}, "a hint"), this.hint);
    this.giveUp = button("give up", giveUp);
    this.element = element("div", { class: "sv-goal", hidden: true }, this.task, this.status, hint, this.giveUp);
  }

  /** @param {Goal | undefined} goal */
  show(goal) {
    this.element.hidden = !goal;
    if (!goal) return;
    this.element.classList.toggle("sv-met", goal.met);
    this.giveUp.hidden = goal.met;
    for (const name of /** @type {const} */ (["task", "status", "hint"])) {
      if (this[name].textContent !== goal[name]) this[name].textContent = goal[name];
    }
  }

  /**
   * What is read aloud: the task of a new challenge, then the state of the scene.
   * @param {Goal | undefined} goal
   */
  announcement(goal) {
    if (!goal) return [];
    const isNew = this.element.hidden || goal.task !== this.task.textContent;
    return [...(isNew ? [goal.task] : []), ...(goal.met ? ["Done."] : []), goal.status];
  }
}
