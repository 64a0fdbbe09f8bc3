// Undo and redo.

/** @import { Pose } from "./messages.js" */

export class PoseHistory {
  constructor() {
    /** @type {Pose[]} */
    this.past = [];
    /** @type {Pose[]} */
    this.future = [];
  }

  /** @param {Pose} pose The one that a change leaves. */
  remember(pose) {
    this.past.push(pose);
    this.future = [];
  }

  /**
   * @param {Pose} pose The one that is left.
   * @returns {Pose | undefined}
   */
  undo(pose) {
    const before = this.past.pop();
    if (before) this.future.push(pose);
    return before;
  }

  /**
   * @param {Pose} pose The one that is left.
   * @returns {Pose | undefined}
   */
  redo(pose) {
    const after = this.future.pop();
    if (after) this.past.push(pose);
    return after;
  }
}
