// Files that are given to the reader: from the kernel, or drawn here.

import { element, SVG } from "./elements.js";

/** @import { Pen } from "./pen.js" */

const PIXELS_PER_POINT = 2;
const INLINED_STYLES = ["fill", "stroke", "font-family", "font-size", "font-weight"]; // set by style sheets and variables
const SVG_TYPE = "image/svg+xml";
const PNG_TYPE = "image/png";
export const PAGE_FORMATS = ["svg", "png"]; // what a page can draw without a kernel

/**
 * Give a file to the reader as a download.
 * @param {{ name: string, mime: string }} file
 * @param {BlobPart[]} buffers Its content is the first.
 */
export function download({ name, mime }, [data]) {
  const url = URL.createObjectURL(new Blob([data], { type: mime }));
  element("a", { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 10000);
}

/**
 * Save the pictures that are shown, one under another, without a kernel.  A picture that moves is saved as it will end.
 * @param {Pen[]} pens
 * @param {string} form One of PAGE_FORMATS.
 */
export async function savePictures(pens, form) {
  const shown = pens.filter(({ svg }) => !svg.matches("[hidden], .sv-empty"));
  for (const pen of shown) pen.arrive();
  const drawn = stacked(shown.map(({ svg }) => svg));
  const text = new XMLSerializer().serializeToString(drawn);
  if (form === "svg") download({ name: "satviz.svg", mime: SVG_TYPE }, [text]);
  else download({ name: "satviz.png", mime: PNG_TYPE }, [await png(text, drawn.viewBox.baseVal)]);
}

/**
 * The pictures as one file that needs no page: their styles are written into it, and their sentences are its title.
 * @param {SVGSVGElement[]} svgs
 */
function stacked(svgs) {
  const sizes = svgs.map((svg) => svg.viewBox.baseVal);
  const [width, height] = [Math.max(...sizes.map((size) => size.width)), sizes.reduce((sum, size) => sum + size.height, 0)];
  const sentences = svgs.map((svg) => svg.getAttribute("aria-label")).join(" ");
  const title = document.createElementNS(SVG, "title");
  title.textContent = sentences;
  const paper = getComputedStyle(svgs[0]).getPropertyValue("--sv-paper").trim();
  const whole = element("svg", { viewBox: `0 0 ${width} ${height}`, width, height, role: "img", "aria-label": sentences }, title, element("rect", { width, height, fill: paper }));
  let y = 0;
  svgs.forEach((svg, i) => {
    const { width: ownWidth, height: ownHeight } = sizes[i];
    whole.append(element("svg", { x: (width - ownWidth) / 2, y, width: ownWidth, height: ownHeight, viewBox: `0 0 ${ownWidth} ${ownHeight}` }, ...withStyles(svg).children));
    y += ownHeight;
  });
  return whole;
}

/**
 * A copy of a picture that needs no style sheet.
 * @param {SVGSVGElement} svg
 */
function withStyles(svg) {
  const copy = /** @type {SVGSVGElement} */ (svg.cloneNode(true));
  /** @param {SVGSVGElement} picture */
  const parts = (picture) => [...picture.querySelectorAll("path, text")];
  const copies = parts(copy);
  parts(svg).forEach((part, i) => {
    const style = getComputedStyle(part);
    for (const name of INLINED_STYLES) copies[i].setAttribute(name, style.getPropertyValue(name));
    for (const name of ["data-text", "data-at"]) copies[i].removeAttribute(name);
  });
  return copy;
}

/**
 * A PNG; rejected where the browser cannot draw one.
 * @param {string} text An SVG.
 * @param {{ width: number, height: number }} size In points.
 * @returns {Promise<Blob>}
 */
async function png(text, { width, height }) {
  const image = new Image();
  image.src = URL.createObjectURL(new Blob([text], { type: SVG_TYPE }));
  await image.decode();
  const canvas = Object.assign(document.createElement("canvas"), { width: width * PIXELS_PER_POINT, height: height * PIXELS_PER_POINT });
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
  context.drawImage(image, 0, 0, canvas.width, canvas.height);
  URL.revokeObjectURL(image.src);
  return new Promise((resolve, reject) => canvas.toBlob((blob) => (blob ? resolve(blob) : reject()), PNG_TYPE));
}
