// The pages: players start at once, explorers when Python is there.  The widgets' own code runs over a small model.

const HERE = new URL(".", location).href;

// Python in a worker, one for the page.
class Python {
  constructor(script) {
    this.models = new Map();
    this.told = []; // who follows the start
    this.started = performance.now();
    this.worker = new Worker(script, { type: "module" });
    this.worker.onmessage = ({ data }) => this.heard(data);
    this.worker.onerror = () => this.heard({ failed: "its script does not load" });
  }
  heard({ place, text, ...start }) {
    if (place) this.models.get(place)?.heard(JSON.parse(text));
    else for (const follow of this.told) follow(start);
  }
  send(place, content) {
    this.worker.postMessage({ place, content });
  }
}

// What a widget asks of its model.
class Model {
  constructor(python, place, values = {}) {
    Object.assign(this, { python, place, values, listeners: new Set() });
    python.models.set(place, this);
  }
  get(name) {
    return this.values[name];
  }
  on(_event, listener) {
    this.listeners.add(listener);
  }
  off(_event, listener) {
    this.listeners.delete(listener);
  }
  send(content) {
    if (content.kind) this.python.send(this.place, content);
  }
  tell(content) {
    for (const listener of this.listeners) listener(content, []);
  }
  heard(content) {
    const ofLink = content.kind === "opened" || (content.kind === "refused" && content.n === undefined);
    if (ofLink) return this.opened(content); // the page says why, once
    if (content.kind === "state") this.follows(content);
    this.tell(content);
  }
}

// A place for a scene: its still picture, until Python has opened what stands behind the #.
class Place {
  constructor(element, python, number, linked) {
    Object.assign(this, { element, python, linked, name: `place-${number}` });
    this.status = element.nextElementSibling;
    this.way = this.status.nextElementSibling.firstElementChild;
    this.offer = linked ? document.querySelector(".offer") : null; // the scenes, where a link opens none
    this.model = new Model(python, this.name);
    this.model.opened = (content) => this.opened(content);
    this.model.follows = (state) => this.follows(state);
    python.told.push((start) => this.follow(start));
    this.open();
    if (linked) addEventListener("hashchange", () => this.open());
  }
  open() {
    clearTimeout(this.later); // the address is another scene's now
    const behind = this.linked ? decoded(location.hash.slice(1)) : "";
    if (this.shown && document.getElementById(behind)) return; // a way within the page
    this.opening = true;
    this.python.send(this.name, { kind: "open", hash: behind && !document.getElementById(behind) ? behind : this.element.dataset.hash });
  }
  follow({ progress, ready, failed }) {
    if (ready) this.element.dataset.from = ready; // where Python started from
    if (ready) this.say("");
    else if (failed) this.say("This picture stays still: Python could not start in this browser.");
    else if (progress < 1) this.say(`Python is on its way: ${Math.floor(progress * 10) * 10} %. Then you can drag.`);
    else this.say("Python is starting. Then you can drag.");
  }
  // The way to the explorer, or on its own page the address, is a link to the scene as it stands.
  follows({ link }) {
    if (this.opening) return;
    this.say("");
    if (this.offer) this.offer.hidden = true;
    const to = new URL(this.way.href);
    to.hash = link;
    this.way.href = to.href;
    clearTimeout(this.later);
    if (this.linked) this.later = setTimeout(() => history.replaceState(null, "", to.hash), 300);
  }
  say(text) {
    if (this.status.textContent !== text) this.status.textContent = text;
  }
  opened(content) {
    this.opening = false;
    const refused = content.kind === "refused";
    if (this.offer) this.offer.hidden = !refused;
    this.element.hidden = refused && !this.shown; // the still picture is not what the link asked for
    if (refused) {
      this.say(`This link cannot be opened: ${content.why.replace(/\.?$/, ".")}`);
      if (this.offer && this.shown) this.status.scrollIntoView(); // it is below the scene
      return;
    }
    this.say("");
    const made = element("div");
    this.shown?.remove();
    if (content.shows) {
      this.shown = new Player(made, content.shows, { ...content, site: HERE });
      if (content.rest) this.shown.other();
      this.shown.go(content.step, { animate: false });
      arrowKeys(this.shown);
    } else {
      this.model.values = { ...content, alone: true, site: HERE };
      this.model.listeners.clear();
      this.shown = new Explorer(this.model, made);
    }
    this.element.replaceChildren(made);
    this.element.classList.add("ready");
    performance.measure("satviz-first-drag", { start: 0, end: performance.now() });
  }
}

function decoded(text) {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}

for (const place of document.querySelectorAll(".player")) {
  const { shows, ...more } = JSON.parse(place.querySelector("script").textContent);
  const made = element("div");
  arrowKeys(new Player(made, shows, { ...more, site: HERE }));
  place.replaceChildren(made);
}
const scenes = [...document.querySelectorAll(".live")];
const still = (why) => scenes.forEach((place) => (place.nextElementSibling.textContent = `${why}, so the picture stays still.`));
if (!document.body.dataset.python) still("This copy of the site has no Python in it");
else if (location.protocol === "file:") still("A browser starts Python only from a web server (in this folder: python -m http.server)");
else if (scenes.length) {
  const python = new Python(document.body.dataset.python);
  scenes.forEach((place, i) => new Place(place, python, i, document.body.classList.contains("explorer")));
}
if (isSecureContext && "serviceWorker" in navigator) navigator.serviceWorker.register("sw.js").catch(() => {});
