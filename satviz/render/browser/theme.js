// The widgets follow the page around them: they are light or dark as it is, whatever the system prefers.

import { element } from "./elements.js";

/**
 * Set the theme of `root` now and at each change of the page, until the returned function is called.
 * @param {HTMLElement} root
 */
export function followTheme(root) {
  const match = () => {
    const theme = isDark(root) ? "dark" : "light";
    if (root.dataset.theme !== theme) root.dataset.theme = theme;
  };
  const matchTwice = () => {
    match();
    clearTimeout(again);
    again = setTimeout(match, 500); // the page's colours may fade over
  };
  let again = 0;
  // An element outside the page has no surroundings yet: it is matched when it is placed, before it is painted.
  const placed = new ResizeObserver(() => {
    placed.disconnect();
    match();
  });
  const system = matchMedia("(prefers-color-scheme: dark)");
  const changes = new MutationObserver(matchTwice);
  for (const page of [document.documentElement, document.body]) changes.observe(page, { attributes: true });
  system.addEventListener("change", matchTwice);
  if (root.isConnected) matchTwice();
  else placed.observe(root);
  return () => {
    clearTimeout(again);
    placed.disconnect();
    changes.disconnect();
    system.removeEventListener("change", matchTwice);
  };
}

/**
 * JupyterLab and VS Code say whether their page is dark.  Elsewhere the colour that shows behind the element decides.
 * @param {HTMLElement} root
 */
function isDark(root) {
  const { body } = document;
  if (body.dataset.jpThemeLight) return body.dataset.jpThemeLight === "false";
  if (body.matches(".vscode-light, .vscode-high-contrast-light")) return false;
  if (body.matches(".vscode-dark, .vscode-high-contrast")) return true;
  for (let around = surroundings(root); around; around = surroundings(around)) {
    const [r, g, b, opacity = 1] = around instanceof Element ? rgba(getComputedStyle(around).backgroundColor) : [0, 0, 0, 0];
    if (opacity > 0.5) return 0.3 * r + 0.6 * g + 0.1 * b < 0.5;
  }
  const scheme = getComputedStyle(document.documentElement).colorScheme;
  return scheme.includes("dark") && (!scheme.includes("light") || matchMedia("(prefers-color-scheme: dark)").matches);
}

/**
 * The parent of a node; of a shadow root its host.
 * @param {Node} node
 * @returns {Node | null}
 */
function surroundings(node) {
  return node.parentNode ?? (node instanceof ShadowRoot ? node.host : null);
}

/**
 * Any colour of CSS as numbers from 0 to 1.  A canvas would not do: browsers that guard against fingerprinting add
 * noise to what is read from it.
 * @param {string} colour
 */
function rgba(colour) {
  if (!colour) return [0, 0, 0, 0]; // the colour of an element that is on no page
  const probe = document.body.appendChild(element("i", { hidden: true }));
  probe.style.color = `color-mix(in srgb, ${colour}, ${colour})`;
  const found = (getComputedStyle(probe).color.match(/-?[\d.]+(e-\d+)?/g) ?? []).map(Number);
  probe.remove();
  return found;
}
