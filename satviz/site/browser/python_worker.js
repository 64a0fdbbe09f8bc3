// Python in a worker, one for the page, and a widget's model that talks to it.

/** @import { Listener, Message, Pose, State, WidgetModel } from "../../render/browser/messages.js" */
/** @import { Show } from "../../render/browser/player.js" */
/** @typedef {{ progress?: number, ready?: string, failed?: string }} Start How far the start of Python is: from 0 to 1, done, or failed. */
/** @typedef {Record<string, any> & { kind?: string }} Content */
/** @typedef {{ kind: "opened", first: State, pose: Partial<Pose>, presets: string[], failing: string[], challenges: Record<string, string> }} OpenedExplorer */
/** @typedef {{ kind: "opened", shows: Show[], narrow: Show[], step: number, predict: boolean, everyAxis: boolean, range: [number, number] | null, link: string }} OpenedPlayer */
/** @typedef {{ kind: "refused", n?: undefined, why: string }} NotOpened */
/** @typedef {OpenedExplorer | OpenedPlayer} Opened */

export class PythonWorker {
  /** @param {string} script */
  constructor(script) {
    /** @type {Map<string, { receive: (content: any) => void }>} By the name of the place. */
    this.models = new Map();
    /** @type {((start: Start) => void)[]} */
    this.startListeners = [];
    this.worker = new Worker(script, { type: "module" });
    this.worker.onmessage = ({ data }) => this.receive(data);
    this.worker.onerror = () => this.receive({ failed: "its script does not load" });
  }

  /** @param {Start & { place?: string, text?: string }} message */
  receive({ place, text, ...start }) {
    if (place && text) this.models.get(place)?.receive(JSON.parse(text));
    else for (const listener of this.startListeners) listener(start);
  }

  /**
   * @param {string} place
   * @param {Content} content
   */
  send(place, content) {
    this.worker.postMessage({ place, content });
  }
}

/** @implements {WidgetModel} */
export class SiteModel {
  /**
   * @param {PythonWorker} python
   * @param {string} place
   * @param {{ opened: (content: Opened | NotOpened) => void, changed: (state: State) => void }} callbacks
   */
  constructor(python, place, callbacks) {
    this.python = python;
    this.place = place;
    this.callbacks = callbacks;
    /** @type {Record<string, any>} */
    this.values = {};
    /** @type {Set<Listener>} */
    this.listeners = new Set();
    python.models.set(place, this);
  }

  /** @param {string} name */
  get(name) {
    return this.values[name];
  }

  /**
   * @param {"msg:custom"} _event
   * @param {Listener} listener
   */
  on(_event, listener) {
    this.listeners.add(listener);
  }

  /**
   * @param {"msg:custom"} _event
   * @param {Listener} listener
   */
  off(_event, listener) {
    this.listeners.delete(listener);
  }

  /** @param {Content} content */
  send(content) {
    if (content.kind) this.python.send(this.place, content);
  }

  /** @param {Message | Opened} content */
  receive(content) {
    if (content.kind === "opened") {
      this.callbacks.opened(content);
      return;
    }
    if (content.kind === "refused" && content.n === undefined) {
      this.callbacks.opened({ kind: "refused", why: content.why }); // the page says why, once
      return;
    }
    if (content.kind === "state") this.callbacks.changed(content);
    for (const listener of this.listeners) listener(content, []);
  }
}
