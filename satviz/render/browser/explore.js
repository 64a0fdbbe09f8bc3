// The widget of sv.explore.

import { element } from "./elements.js";
import { Explorer } from "./explorer.js";

/** @import { WidgetModel } from "./messages.js" */

/** @param {{ model: WidgetModel, el: HTMLElement }} widget */
function render({ model, el }) {
  const explorer = new Explorer(model, el.appendChild(element("div")));
  return () => explorer.remove();
}

export default { render };
