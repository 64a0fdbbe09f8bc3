// A place for a scene: its still picture, until Python has opened the scene that the address or the page names.

import { arrowKeys } from "../../render/browser/arrows.js";
import { element } from "../../render/browser/elements.js";
import { Explorer, pictureWidth } from "../../render/browser/explorer.js";
import { Player } from "../../render/browser/player.js";
import { SiteModel } from "./python_worker.js";
import { keepSolved } from "./solved.js";

/** @import { State } from "../../render/browser/messages.js" */
/** @import { NotOpened, Opened, PythonWorker, Start } from "./python_worker.js" */

export const SITE = new URL(".", location.href).href;
const ADDRESS_MS = 300; // the address follows the scene when it has rested so long

/**
 * Without Python a built-in scene has its picture, and any other one has none.
 * @param {HTMLElement} root
 * @param {string} fragment It names the scene.
 * @returns {boolean} Is there a picture of the scene?
 */
export function showStill(root, fragment) {
  const [name] = fragment.split("&");
  if (!name || name === root.dataset.hash) return true;
  const known = [...document.querySelectorAll(/** @type {"a"} */ (".offer a"))].some(({ hash }) => hash === `#${name}`);
  // an element asks for its picture as soon as it is made
  const shown = known ? [element("img", { src: `pictures/${name}.svg`, alt: "", class: "picture" })] : [];
  root.firstElementChild?.replaceChildren(...shown);
  return known;
}

export class ScenePlace {
  /**
   * @param {HTMLElement} root It is followed by its status, and by a paragraph with a link to the explorer.
   * @param {PythonWorker} python
   * @param {number} number
   * @param {boolean} linked Does the address of the page name the scene?
   */
  constructor(root, python, number, linked) {
    this.root = root;
    this.python = python;
    this.linked = linked;
    this.name = `place-${number}`;
    this.status = statusOf(root);
    this.link = /** @type {HTMLAnchorElement} */ (this.status.nextElementSibling?.firstElementChild);
    /** @type {HTMLElement | null} The list of scenes, for when a link opens none. */
    this.sceneList = linked ? document.querySelector(".offer") : null;
    /** @type {Player | Explorer | null} */
    this.widget = null;
    this.opening = false;
    this.updatingAddress = 0;
    /** @type {((state: State) => void) | null} Is told of each state of an explorer. */
    this.onstate = null;
    this.model = new SiteModel(python, this.name, { opened: (content) => this.opened(content), changed: (state) => this.changed(state) });
    python.startListeners.push((start) => this.showStart(start));
    if (linked) addEventListener("hashchange", () => this.open());
  }

  open() {
    clearTimeout(this.updatingAddress); // the address names another scene now
    const fragment = this.linked ? decoded(location.hash.slice(1)) : "";
    const withinPage = document.getElementById(fragment) !== null;
    if (this.widget && withinPage) return;
    this.opening = true;
    if (this.linked && !this.widget && !withinPage) showStill(this.root, fragment);
    const query = this.linked ? location.search.slice(1) : "";
    const hash = fragment && !withinPage ? fragment : this.root.dataset.hash;
    this.python.send(this.name, { kind: "open", hash, query, width: pictureWidth(this.root.clientWidth) });
  }

  /** @param {Start} start */
  showStart({ progress = 0, ready, failed }) {
    if (ready) {
      this.root.dataset.from = ready; // "memory" or "nothing"
      this.say("");
    } else if (failed) this.say("This picture stays still: Python could not start in this browser.");
    else if (progress < 1) this.say(`Python is loading: ${Math.floor(progress * 10) * 10} %. Then you can drag.`);
    else this.say("Python is starting. Then you can drag.");
  }

  /** @param {State} state */
  changed(state) {
    this.updateLink(state.link);
    keepSolved(state);
    this.onstate?.(state);
  }

  /**
   * The link to the explorer, or on the explorer's own page the address, opens the scene as it is now.
   * @param {string} link
   */
  updateLink(link) {
    if (this.opening) return;
    this.say("");
    if (this.sceneList) this.sceneList.hidden = true;
    const to = new URL(this.link.href);
    to.hash = link;
    this.link.href = to.href;
    clearTimeout(this.updatingAddress);
    if (this.linked) this.updatingAddress = setTimeout(() => history.replaceState(null, "", to.hash), ADDRESS_MS);
  }

  /** @param {string} text */
  say(text) {
    if (this.status.textContent !== text) this.status.textContent = text;
  }

  /** @param {Opened | NotOpened} content */
  opened(content) {
    this.opening = false;
    const refused = content.kind === "refused";
    if (this.sceneList) this.sceneList.hidden = !refused;
    this.root.hidden = refused && !this.widget; // the still picture is not what the link names
    if (refused) {
      this.say(`This link cannot be opened: ${content.why.replace(/\.?$/, ".")}`);
      if (this.sceneList && this.widget) this.status.scrollIntoView(); // it is below the scene
      return;
    }
    this.say("");
    const made = element("div");
    this.widget?.remove();
    if ("shows" in content) {
      const player = new Player(made, content.shows, { ...content, site: SITE });
      if (content.everyAxis) player.switchShow();
      player.go(content.step, { animate: false });
      arrowKeys(player);
      this.link.hash = `${content.link}&step=${content.step}${content.predict ? "&predict=1" : ""}`;
      this.widget = player;
    } else {
      this.model.values = { ...content, alone: true, pasting: this.linked && !document.body.classList.contains("embed"), site: SITE };
      this.model.listeners.clear();
      this.widget = new Explorer(this.model, made);
      arrowKeys(this.widget);
      this.link.hash = content.first.link;
      this.onstate?.(content.first);
    }
    this.root.replaceChildren(made);
    this.root.classList.add("ready");
    performance.measure("satviz-first-drag", { start: 0, end: performance.now() });
  }
}

/**
 * The element after a place, which says how its Python starts.
 * @param {HTMLElement} root
 */
export function statusOf(root) {
  return /** @type {HTMLElement} */ (root.nextElementSibling);
}

/** @param {string} text */
export function decoded(text) {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}
