// The widget of sv.play: the player, with files made by the kernel.

import { download } from "./download.js";
import { element } from "./elements.js";
import { Player } from "./player.js";

/** @import { WidgetModel } from "./messages.js" */

/** @param {{ model: WidgetModel, el: HTMLElement }} widget */
function render({ model, el }) {
  /** @type {import("./player.js").RequestFile} */
  const requestFile = (form, step, which) => model.send({ kind: "save", form, step, which });
  const [shows, narrow = [], predict, speed, link, site, formats] = ["shows", "narrow", "predict", "speed", "link", "site", "formats"].map((name) => model.get(name));
  const player = new Player(el.appendChild(element("div")), shows, { predict, speed, narrow, formats, requestFile, link, site });
  /** @type {import("./messages.js").Listener} */
  const receive = (content, buffers) => {
    if (content.kind === "file") download(content, buffers);
    else if (content.kind === "refused") player.status.textContent = content.why;
  };
  model.on("msg:custom", receive);
  return () => {
    model.off("msg:custom", receive);
    player.remove();
  };
}

export default { render };
