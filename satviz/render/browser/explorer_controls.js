// The row of menus, buttons and boxes below the explorer's picture.

import { button, element } from "./elements.js";
import { saveMenu, sceneLink } from "./save_menu.js";

/** @import { Explorer } from "./explorer.js" */
/** @import { State } from "./messages.js" */

export class ExplorerControls {
  /** @param {Explorer} explorer */
  constructor(explorer) {
    const { model } = explorer;
    /** @type {Record<string, string[]>} */
    const groups = { "the article's": model.get("presets"), "where a shortcut fails": model.get("failing") };
    const scenes = Object.entries(groups).map(([label, names]) => element("optgroup", { label }, ...names.map((name) => element("option", { value: name }, name))));
    this.presets = element("select", { "aria-label": "presets", onchange: () => explorer.choosePreset(this.presets.value) }, element("option", { value: "" }, "presets"), ...scenes);
    /** @type {Record<string, string>} */
    const challenges = model.get("challenges");
    const goals = Object.entries(challenges).map(([value, name]) => element("option", { value }, name));
    this.breakShortcut = goals.find(({ value }) => value === "break");
    this.goals = element("select", { "aria-label": "challenges", onchange: () => explorer.chooseGoal(this.goals.value) }, element("option", { value: "" }, "challenges"), ...goals);
    this.views = ["shortcut", "truth"].map((view) => button(view, () => explorer.change({ view, pinned: null }), { pressed: "false" }));
    this.viewGroup = element("span", { class: "sv-view", role: "group", "aria-label": "what is shown", hidden: true }, ...this.views);
    this.undo = button("undo", () => explorer.undo(), { keys: "Control+Z" });
    this.redo = button("redo", () => explorer.redo(), { keys: "Control+Shift+Z" });
    const reset = button("reset", () => explorer.reset());
    this.freeAxis = checkbox((on) => explorer.change({ degree: on ? 30 : null, pinned: null }));
    this.wayOut = checkbox((on) => explorer.change({ wayOut: on }));
    this.difference = checkbox((on) => explorer.change({ against: on }));
    const labels = [["free axis", this.freeAxis], ["way out", this.wayOut], ["B − A", this.difference]];
    const boxes = labels.map(([label, box]) => element("label", {}, box, ` ${label}`));
    /** @type {import("./save_menu.js").Kernel | null} */
    const kernel = model.get("alone") ? null : { formats: model.get("formats"), request: (form) => model.send({ kind: "save", form }) };
    const copies = { "copy JSON": () => explorer.state.json, "copy link": () => sceneLink(model.get("site"), explorer.state.link) };
    const { menu, status } = saveMenu([explorer.pen, explorer.curvePen, explorer.differencePen], kernel, copies);
    this.element = element("div", { class: "sv-controls", role: "group", "aria-label": "explorer" },
      this.presets, this.goals, this.viewGroup, this.undo, this.redo, reset, ...boxes, menu, status);
    this.scene = "";
  }

  /** @param {State} state */
  show({ view, scene, goal }) {
    this.viewGroup.hidden = !view;
    for (const each of this.views) each.setAttribute("aria-pressed", String(each.textContent === view));
    if (scene !== this.scene) {
      this.scene = scene;
      const { name } = JSON.parse(scene);
      this.presets.value = [...this.presets.options].some(({ value }) => value === name) ? name : "";
    }
    this.goals.value = goal?.goal ?? "";
    if (this.breakShortcut) this.breakShortcut.disabled = !view; // without a shortcut there is none to break
  }

  /**
   * The boxes follow the pose, which undo changes too.
   * @param {Explorer} explorer
   */
  follow({ pose, history }) {
    this.undo.disabled = !history.past.length;
    this.redo.disabled = !history.future.length;
    this.freeAxis.checked = pose.degree !== null;
    this.wayOut.checked = pose.wayOut;
    this.difference.checked = pose.against;
  }
}

/** @param {(checked: boolean) => void} onchange */
function checkbox(onchange) {
  return element("input", { type: "checkbox", onchange: ({ target }) => onchange(target.checked) });
}
