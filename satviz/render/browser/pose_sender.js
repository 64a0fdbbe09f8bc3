// Poses on their way to Python: few at a time, and the newest wins.
//
// Jupyter's server leaves Nagle's algorithm on: what it has sent must be acknowledged before it sends more, and a
// browser that has nothing to send acknowledges up to 40 ms late.  So an answer waits in the server until the next
// message from here: the next pose, which must not wait for that answer, or an empty message.

/** @import { Pose } from "./messages.js" */
/** @typedef {{ snap: "a" | "b", byKey: boolean } | null} Snapping The shape that may be moved to where it touches the other; by an arrow key, or dragged. */

const MAX_IN_FLIGHT = 3; // poses without an answer
const ACKNOWLEDGE_MS = 8; // the empty message comes this long after a pose, when the answer should wait in the server
const ANSWER_TIMEOUT_MS = 3000; // an answer that is later is not waited for

export class PoseSender {
  /** @param {(content: Record<string, unknown>) => void} send */
  constructor(send) {
    this.send = send;
    this.sent = 0; // the number of the last pose
    this.answered = 0; // the last one with an answer
    this.abandoned = 0; // the last one whose answer is not waited for
    /** @type {(Pose & { final: boolean, width: number | null } & Partial<NonNullable<Snapping>>) | null} The newest pose, while it waits. */
    this.next = null;
    this.acknowledging = 0;
    this.timeout = 0;
  }

  // Is a pose newer than the last answer?
  get ahead() {
    return this.next !== null || this.answered < this.sent;
  }

  /**
   * @param {Pose} pose
   * @param {boolean} final A pose that is not final is one of many: Python keeps the kernel busy between them.
   * @param {number | null} width Of the place for the picture; null: as wide as a picture ever is.
   * @param {Snapping} snapping
   */
  push(pose, final, width, snapping) {
    this.next = { ...pose, final, width, ...snapping };
    this.flush();
  }

  flush() {
    if (!this.next || this.sent - Math.max(this.answered, this.abandoned) >= MAX_IN_FLIGHT) return;
    const { final } = this.next;
    this.sent += 1;
    this.send({ kind: "pose", n: this.sent, ...this.next });
    this.next = null;
    clearTimeout(this.acknowledging);
    this.acknowledging = setTimeout(() => this.send({ final }), ACKNOWLEDGE_MS);
    clearTimeout(this.timeout);
    this.timeout = setTimeout(() => {
      this.abandoned = this.sent;
      this.flush();
    }, ANSWER_TIMEOUT_MS);
  }

  /** @param {number} number Of the pose that Python has answered. */
  receive(number) {
    this.answered = number;
    this.flush();
  }

  // Forget the pose that waits.
  discard() {
    this.next = null;
  }

  stop() {
    clearTimeout(this.acknowledging);
    clearTimeout(this.timeout);
  }
}
