// The menu of what a widget saves: files, and texts to copy.

import { PAGE_FORMATS, savePictures } from "./download.js";
import { button, element, toolMenu } from "./elements.js";

/** @import { Pen } from "./pen.js" */
/** @typedef {{ formats: string[], request: (form: string) => void }} Kernel The formats that Python offers, and how to request a file. */

/**
 * The address at which a site's explorer opens a scene.
 * @param {string | undefined} site The site's address, empty where none is known.
 * @param {string} link
 */
export function sceneLink(site, link) {
  return `${site ?? ""}scene.html#${link}`;
}

/**
 * Copy a text, and return whether that succeeded.  Only a page from https or from this machine has the clipboard, and a
 * browser may forbid it there.
 * @param {string} text
 */
export async function copyText(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const field = element("textarea", { readonly: true });
    field.value = text;
    const focused = /** @type {HTMLElement | null} */ (document.activeElement);
    document.body.append(field);
    field.select();
    const copied = document.execCommand("copy");
    field.remove();
    focused?.focus();
    return copied;
  }
}

/**
 * The menu, and beside it the place that says what became of a file.
 * @param {Pen[]} pens
 * @param {Kernel | null} kernel Draws the files.  Without a kernel the page saves its own pictures.
 * @param {Record<string, () => string>} texts What can be copied, by the name of its button.
 */
export function saveMenu(pens, kernel, texts) {
  const status = element("span", { class: "sv-done", role: "status" });
  /** @param {string} form */
  const savePage = (form) => savePictures(pens, form).catch(() => {
    status.textContent = "This browser cannot draw the file.";
  });
  const { formats, request } = kernel ?? { formats: PAGE_FORMATS, request: savePage };
  /** @param {() => string} text */
  const copy = async (text) => {
    status.textContent = (await copyText(text())) ? "Copied." : "This browser does not allow it: copy by hand.";
  };
  const copies = Object.entries(texts).map(([name, text]) => button(name, () => copy(text)));
  const saves = formats.map((form) => button(`save ${form.toUpperCase()}`, () => request(form), { content: form.toUpperCase() }));
  const { menu } = toolMenu("save", "save", ...saves, ...copies);
  menu.addEventListener("toggle", () => {
    if (menu.open) status.textContent = "";
  });
  return { menu, status };
}
