// Python beside the page.  It starts from the memory kept when the site was built, else from nothing, and answers.
// The big files are compressed with gzip (.bin), since plain servers do not compress; they are unpacked as they arrive.

import { shutOff } from "./shut_off.js";

/** @typedef {{ place: string, content: Record<string, any> }} Request */
/** @typedef {(place: string, text: string) => string} Answer Of satviz.site.live: from JSON to JSON, empty for none. */
/** @typedef {{ answer: Answer, from: "memory" | "nothing", fetchLibrary?: () => Promise<void> }} Python */
/**
 * What is used of Pyodide.
 * @typedef {object} Pyodide
 * @property {{ writeFile: (path: string, data: Uint8Array) => void }} FS
 * @property {(code: string) => any} runPython
 * @property {(name: string) => any} pyimport
 * @property {(archive: Uint8Array, format: string, options: { extractDir: string }) => void} unpackArchive
 */

// The worker listens first of all: a message that came before the end of the first await would be lost.
// While Python works, poses of one place wait; only the newest is answered.
/** @type {Request[]} */
const waiting = [];
const turns = new MessageChannel();
const post = self.postMessage.bind(self); // kept, since what runs a reader's code is shut off from the page
/** @type {Python | null} */
let python = null;
self.onmessage = ({ data }) => {
  waiting.push(data);
  turns.port2.postMessage(null);
};
turns.port1.onmessage = async () => {
  const request = python && waiting.shift();
  if (!python || !request) return;
  const { place, content } = request;
  if (content.kind === "define") {
    await python.fetchLibrary?.(); // the reader's code may import any module of it
    shutOff();
  }
  const stale = content.kind === "pose" && waiting.some((later) => later.place === place && later.content.kind === "pose");
  try {
    const text = stale ? "" : python.answer(place, JSON.stringify(content));
    if (text) post({ place, text });
  } catch (error) {
    if (place !== "reader") throw error;
    post({ ended: String(error) }); // Python itself has come to its end
  }
};

const LIBRARY_DELAY_MS = 3000; // after the start the rest of the library is fetched
const version = new URL(import.meta.url).search;
const url = (/** @type {string} */ name) => new URL(`${name}${version}`, import.meta.url).href;
const fetchFile = self.fetch.bind(self);
/** @type {{ sizes: Record<string, number>, lock: string }} */
const { sizes, lock } = await (await fetchFile(url("about.json"))).json();
const total = sizes["memory.bin"] ? sizes["memory.bin"] + sizes["wasm.bin"] : Object.values(sizes).reduce((sum, size) => sum + size);
let received = 0;

/**
 * @param {string} name
 * @param {string} type
 */
async function unpacked(name, type) {
  const response = await fetchFile(url(name));
  if (!response.ok || !response.body) throw new Error(`${name}: ${response.status}`);
  /** @type {TransformStream<Uint8Array<ArrayBuffer>, Uint8Array<ArrayBuffer>>} */
  const counted = new TransformStream({
    transform(chunk, controller) {
      received += chunk.byteLength;
      if (!python) post({ progress: Math.min(1, received / total) });
      controller.enqueue(chunk);
    },
  });
  const stream = response.body.pipeThrough(counted).pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream, { headers: { "content-type": type } });
}

/** @param {string} name */
async function bytes(name) {
  return new Uint8Array(await (await unpacked(name, "application/octet-stream")).arrayBuffer());
}

// Pyodide's files arrive unpacked, and with the right type whatever the server says.  Kept memory holds all modules that
// are needed, so the library can come after the first drag.
let cold = !sizes["memory.bin"];
self.fetch = (what, options) => {
  if (String(what).endsWith(".wasm")) return unpacked("wasm.bin", "application/wasm");
  if (String(what).endsWith(".zip")) return cold ? unpacked("library.bin", "application/zip") : Promise.resolve(new Response());
  return fetchFile(what, options);
};

/** @returns {Promise<Python>} */
async function start() {
  const memory = cold ? null : bytes("memory.bin");
  memory?.catch(() => {}); // its failure is handled where it is awaited
  const [{ loadPyodide }, { default: createPyodideModule }] = await Promise.all([import(url("pyodide.js")), import(url("pyodide.asm.js"))]);
  const here = new URL(".", import.meta.url).href;
  const options = { indexURL: here, packageBaseUrl: here, lockFileContents: lock, createPyodideModule };
  if (memory) {
    try {
      /** @type {Pyodide} */
      const pyodide = await loadPyodide({ ...options, _loadSnapshot: memory });
      const fetchLibrary = async () => pyodide.FS.writeFile(pyodide.runPython("import sys; next(p for p in sys.path if p.endswith('.zip'))"), await bytes("library.bin"));
      return { answer: pyodide.pyimport("satviz.site.live").answer, from: "memory", fetchLibrary };
    } catch (error) {
      console.info(`satviz: the kept memory does not load, so Python starts anew (${error})`);
    }
  }
  cold = true;
  /** @type {[Pyodide, Uint8Array]} */
  const [pyodide, satviz] = await Promise.all([loadPyodide(options), bytes("satviz.bin")]);
  pyodide.unpackArchive(satviz, "zip", { extractDir: "/satviz" });
  pyodide.runPython("import sys; sys.path.append('/satviz')");
  return { answer: pyodide.pyimport("satviz.site.live").answer, from: "nothing" };
}

try {
  python = await start();
  post({ ready: python.from });
  for (const _ of waiting) turns.port2.postMessage(null);
  const { fetchLibrary } = python;
  if (fetchLibrary) {
    let fetched = /** @type {Promise<void> | null} */ (null);
    python.fetchLibrary = () => (fetched ??= fetchLibrary());
    setTimeout(() => python?.fetchLibrary?.(), LIBRARY_DELAY_MS);
  }
} catch (error) {
  post({ failed: String(error) });
}
