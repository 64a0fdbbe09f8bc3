// A file handed to the reader: from the kernel, or drawn here.
export function download({ name }, [data]) {
  const type = { svg: "image/svg+xml", png: "image/png", gif: "image/gif" }[name.split(".").pop()];
  const url = URL.createObjectURL(new Blob([data], { type }));
  element("a", { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 10000);
}

const FINE = 2; // pixels a point
const STYLED = ["fill", "stroke", "font-family", "font-size", "font-weight"]; // what style sheets and variables decide

// The picture as it is shown, saved without a kernel; of one that moves what it comes to.
export async function saveDrawn(pen, form) {
  pen.arrive();
  const { svg } = pen;
  const text = standing(svg);
  download({ name: `satviz.${form}` }, [form === "svg" ? text : await painted(text, svg.viewBox.baseVal)]);
}

// The picture as a file that stands by itself: its styles written into it, its sentence as its title.
function standing(svg) {
  const copy = svg.cloneNode(true);
  const parts = (of) => [...of.querySelectorAll("path, text")];
  const made = parts(copy);
  parts(svg).forEach((part, i) => {
    const style = getComputedStyle(part);
    for (const name of STYLED) made[i].setAttribute(name, style.getPropertyValue(name));
    for (const name of ["data-text", "data-at"]) made[i].removeAttribute(name);
  });
  for (const name of copy.getAttributeNames()) if (!["viewBox", "role", "aria-label"].includes(name)) copy.removeAttribute(name);
  const { width, height } = svg.viewBox.baseVal;
  for (const [name, value] of Object.entries({ xmlns: SVG, width, height })) copy.setAttribute(name, value);
  const title = document.createElementNS(SVG, "title");
  title.textContent = svg.getAttribute("aria-label");
  const paper = getComputedStyle(svg).getPropertyValue("--sv-paper").trim();
  copy.prepend(title, element("rect", { width, height, fill: paper }));
  return new XMLSerializer().serializeToString(copy);
}

// The same as a PNG.
async function painted(text, { width, height }) {
  const image = new Image();
  image.src = URL.createObjectURL(new Blob([text], { type: "image/svg+xml" }));
  await image.decode();
  const canvas = Object.assign(document.createElement("canvas"), { width: width * FINE, height: height * FINE });
  canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
  URL.revokeObjectURL(image.src);
  return new Promise((made) => canvas.toBlob(made, "image/png"));
}
