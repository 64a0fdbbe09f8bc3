// The explorer's toolbar: which scene, what is shown, what to do, what to save and to send on.

import { element, toolButton, toolToggle } from "./elements.js";
import { saveMenu, sceneLink } from "./save_menu.js";

/** @import { Explorer } from "./explorer.js" */
/** @import { State } from "./messages.js" */

export class ExplorerControls {
  /** @param {Explorer} explorer */
  constructor(explorer) {
    const { model } = explorer;
    /** @type {Record<string, string[]>} */
    const groups = { "of the chapters": model.get("presets"), "where a shortcut fails": model.get("failing") };
    const scenes = Object.entries(groups).map(([label, names]) => element("optgroup", { label }, ...names.map((name) => element("option", { value: name }, name))));
    this.presets = element("select", { "aria-label": "presets", onchange: () => explorer.choosePreset(this.presets.value) }, element("option", { value: "" }, "presets"), ...scenes);
    /** @type {Record<string, string>} */
    const challenges = model.get("challenges");
    const goals = Object.entries(challenges).map(([value, name]) => element("option", { value }, name));
    this.breakShortcut = goals.find(({ value }) => value === "break");
    this.goals = element("select", { "aria-label": "challenges", onchange: () => explorer.chooseGoal(this.goals.value) }, element("option", { value: "" }, "challenges"), ...goals);
    this.views = /** @type {const} */ (["shortcut", "truth"]).map((view) => toolButton(view, view, () => explorer.change({ view, pinned: null }), { pressed: "false" }));
    this.viewGroup = element("span", { class: "sv-view", role: "group", "aria-label": "what is shown", hidden: true }, ...this.views);
    this.undo = toolButton("undo", "undo", () => explorer.undo(), { keys: "Control+Z" });
    this.redo = toolButton("redo", "redo", () => explorer.redo(), { keys: "Control+Shift+Z" });
    const reset = toolButton("reset", "reset", () => explorer.reset());
    this.freeAxis = toolToggle("axis", "free axis", (on) => explorer.change({ degree: on ? 30 : null, pinned: null }));
    this.mtv = toolToggle("way", "way out", (on) => explorer.change({ mtv: on }));
    this.difference = toolToggle("difference", "B − A", (on) => explorer.change({ difference: on }));
    this.snap = toolToggle("snap", "snap", () => {});
    this.snap.toggle.title = "When you release a shape near the other one, it moves until both touch exactly.";
    /** @type {import("./save_menu.js").Kernel | null} */
    const kernel = model.get("alone") ? null : { formats: model.get("formats"), request: (form) => model.send({ kind: "save", form }) };
    const copies = { "copy JSON": () => explorer.state.json, "copy link": () => sceneLink(model.get("site"), explorer.state.link) };
    const { menu, status } = saveMenu([explorer.pen, explorer.linePen, explorer.curvePen, explorer.differencePen], kernel, copies);
    /** @type {(label: string, ...children: Node[]) => HTMLElement} */
    const group = (label, ...children) => element("div", { class: "sv-group", role: "group", "aria-label": label }, ...children);
    this.drawing = group("draw");
    this.scenes = element("div", { class: "sv-controls sv-scenes", role: "group", "aria-label": "scene" }, this.presets, this.goals);
    this.status = status;
    this.element = element("div", { class: "sv-controls sv-bar", role: "group", "aria-label": "explorer" },
      group("shown", this.viewGroup, this.freeAxis.toggle, this.mtv.toggle, this.difference.toggle),
      group("do", this.snap.toggle, this.undo, this.redo, reset),
      this.drawing, group("share", menu), status);
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
    this.freeAxis.box.checked = pose.degree !== null;
    this.mtv.box.checked = pose.mtv;
    this.difference.box.checked = pose.difference;
  }
}
