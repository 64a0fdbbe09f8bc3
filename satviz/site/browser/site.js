// The pages: players start when they are near, explorers when Python is there, too.  Both are the notebook's widgets.

import { arrowKeys } from "../../render/browser/arrows.js";
import { element } from "../../render/browser/elements.js";
import { Player } from "../../render/browser/player.js";
import { CheckPage } from "./check.js";
import { judgedChoices } from "./choices.js";
import { playFirstMinute } from "./first_minute.js";
import { fitFrame } from "./fit_frame.js";
import { slidingFrames } from "./frames.js";
import { PythonWorker } from "./python_worker.js";
import { waitForAnswers } from "./rest_of_chapter.js";
import { decoded, SITE, ScenePlace, showStill, statusOf } from "./scene_place.js";
import { showSolved } from "./solved.js";

/**
 * The JSON of a player, which is compressed in its page.
 * @param {Element} root
 */
async function unpackedShows(root) {
  const bytes = Uint8Array.from(atob(JSON.parse(root.querySelector("script")?.textContent ?? "")), (letter) => letter.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"))).json();
}

for (const list of document.querySelectorAll(/** @type {"ul"} */ ("ul.choices"))) judgedChoices(list);
for (const chapter of document.querySelectorAll(/** @type {"article"} */ (".chapter article"))) waitForAnswers(chapter);
for (const place of document.querySelectorAll(/** @type {"div"} */ (".frames"))) slidingFrames(place);
for (const stage of document.querySelectorAll(/** @type {"section"} */ (".front .stage"))) playFirstMinute(stage);
for (const place of document.querySelectorAll(/** @type {"p"} */ (".progress"))) showSolved(place);

/**
 * A scene is opened, and a player is made, when it is less than a screen away: a long page does not draw all at once.
 * @param {Iterable<Element>} roots
 * @param {(root: Element) => void} start
 */
function whenNear(roots, start) {
  const observer = new IntersectionObserver((entries) => {
    for (const { isIntersecting, target } of entries) {
      if (!isIntersecting) continue;
      observer.unobserve(target);
      start(target);
    }
  }, { rootMargin: "100%" });
  for (const root of roots) observer.observe(root);
}

whenNear(document.querySelectorAll(".player"), (root) => {
  unpackedShows(root).then(({ shows, ...options }) => {
    const made = element("div");
    arrowKeys(new Player(made, shows, { ...options, site: SITE }));
    root.replaceChildren(made);
  });
});

/** @type {HTMLElement[]} */
const scenes = [...document.querySelectorAll(/** @type {"div"} */ (".live"))];
const workerScript = document.body.dataset.python;
const script = /** @type {HTMLScriptElement} */ (document.currentScript); // its folder is the site's, also for the page of a missing address

/** @param {string} why */
function stayStill(why) {
  const linked = document.body.classList.contains("explorer");
  const show = () => {
    for (const root of scenes) {
      const shown = !linked || showStill(root, decoded(location.hash.slice(1)));
      statusOf(root).textContent = `${why}, so ${shown ? "the picture stays still" : "it cannot show the scene of this link"}.`;
    }
  };
  show();
  if (linked) addEventListener("hashchange", show);
}

if (!workerScript) stayStill("This copy of the site has no Python in it");
else if (location.protocol === "file:") stayStill("A browser starts Python only from a web server (in this folder: python -m http.server)");
else if (scenes.length) {
  const python = new PythonWorker(workerScript);
  const linked = document.body.classList.contains("explorer");
  const places = scenes.map((root, i) => new ScenePlace(root, python, i, linked));
  const check = /** @type {HTMLElement | null} */ (document.querySelector(".check"));
  if (check) new CheckPage(check, python, workerScript, places[0]);
  if (linked) for (const place of places) place.open();
  else {
    whenNear(scenes, (root) => {
      const place = places[scenes.indexOf(/** @type {HTMLElement} */ (root))];
      if (!place.widget && !place.opening) place.open();
    });
  }
}
if (document.body.classList.contains("embed")) fitFrame();
if (isSecureContext && "serviceWorker" in navigator) navigator.serviceWorker.register(new URL("sw.js", script.src)).catch(() => {});
