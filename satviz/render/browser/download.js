// A file handed to the reader: from the kernel, or drawn here.
export function download({ name }, [data]) {
  const type = { svg: "image/svg+xml", png: "image/png", gif: "image/gif" }[name.split(".").pop()];
  const url = URL.createObjectURL(new Blob([data], { type }));
  element("a", { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 10000);
}

const FINE = 2; // pixels a point
const STYLED = ["fill", "stroke", "font-family", "font-size", "font-weight"]; // what style sheets and variables decide

// The pictures as they are shown, one under another, saved without a kernel; of one that moves what it comes to.
export async function saveDrawn(pens, form) {
  const shown = pens.filter(({ svg }) => !svg.hasAttribute("hidden"));
  for (const pen of shown) pen.arrive();
  const drawn = standing(shown.map(({ svg }) => svg));
  const text = new XMLSerializer().serializeToString(drawn);
  download({ name: `satviz.${form}` }, [form === "svg" ? text : await painted(text, drawn.viewBox.baseVal)]);
}

// Pictures as a file that stands by itself: their styles written into it, their sentences as its title.
function standing(svgs) {
  const sizes = svgs.map((svg) => svg.viewBox.baseVal);
  const [width, height] = [Math.max(...sizes.map((size) => size.width)), sizes.reduce((sum, size) => sum + size.height, 0)];
  const says = svgs.map((svg) => svg.getAttribute("aria-label")).join(" ");
  const title = document.createElementNS(SVG, "title");
  title.textContent = says;
  const paper = getComputedStyle(svgs[0]).getPropertyValue("--sv-paper").trim();
  const whole = element("svg", { viewBox: `0 0 ${width} ${height}`, width, height, role: "img", "aria-label": says }, title, element("rect", { width, height, fill: paper }));
  let y = 0;
  svgs.forEach((svg, i) => {
    const { width: wide, height: high } = sizes[i];
    whole.append(element("svg", { x: (width - wide) / 2, y, width: wide, height: high, viewBox: `0 0 ${wide} ${high}` }, ...styled(svg).children));
    y += high;
  });
  return whole;
}

// A copy of a picture without need of style sheets.
function styled(svg) {
  const copy = svg.cloneNode(true);
  const parts = (of) => [...of.querySelectorAll("path, text")];
  const made = parts(copy);
  parts(svg).forEach((part, i) => {
    const style = getComputedStyle(part);
    for (const name of STYLED) made[i].setAttribute(name, style.getPropertyValue(name));
    for (const name of ["data-text", "data-at"]) made[i].removeAttribute(name);
  });
  return copy;
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
