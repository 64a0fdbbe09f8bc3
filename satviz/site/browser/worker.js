// Python beside the page: starts from the memory kept when the site was built, else from nothing, and answers.
// The big files are gzip (.bin), since plain servers do not pack; they are unpacked while they come in.

// First of all ears: a message that comes before the first await has ended would be lost.
// Of the poses of one place that have piled up while Python worked only the newest is worth an answer.
const waiting = [];
const turn = new MessageChannel();
let python = null;
self.onmessage = ({ data }) => {
  waiting.push(data);
  turn.port2.postMessage(null);
};
turn.port1.onmessage = () => {
  if (!python || !waiting.length) return;
  const { place, content } = waiting.shift();
  const stale = content.kind === "pose" && waiting.some((later) => later.place === place && later.content.kind === "pose");
  const text = stale ? "" : python.answer(place, JSON.stringify(content));
  if (text) postMessage({ place, text });
};

const LATE_MS = 3000; // after the start the rest of the library is fetched
const version = new URL(import.meta.url).search;
const url = (name) => new URL(`${name}${version}`, import.meta.url).href;
const server = self.fetch.bind(self);
const { sizes, lock } = await (await server(url("about.json"))).json();
const whole = sizes["memory.bin"] ? sizes["memory.bin"] + sizes["wasm.bin"] : Object.values(sizes).reduce((sum, size) => sum + size);
let got = 0;

async function unpacked(name, type) {
  const response = await server(url(name));
  if (!response.ok) throw new Error(`${name}: ${response.status}`);
  const counted = new TransformStream({
    transform(chunk, controller) {
      got += chunk.byteLength;
      if (!python) postMessage({ progress: Math.min(1, got / whole) });
      controller.enqueue(chunk);
    },
  });
  const stream = response.body.pipeThrough(counted).pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream, { headers: { "content-type": type } });
}

const bytes = async (name) => new Uint8Array(await (await unpacked(name, "application/octet-stream")).arrayBuffer());

// What Pyodide asks for comes unpacked, and of the right type whatever the server says.  Kept memory holds all modules
// that are needed, so that the library may come after the first drag.
let anew = !sizes["memory.bin"];
self.fetch = (what, more) => {
  if (String(what).endsWith(".wasm")) return unpacked("wasm.bin", "application/wasm");
  if (String(what).endsWith(".zip")) return anew ? unpacked("library.bin", "application/zip") : Promise.resolve(new Response());
  return server(what, more);
};

async function start() {
  const memory = anew ? null : bytes("memory.bin");
  memory?.catch(() => {}); // told where it is waited for
  const [{ loadPyodide }, { default: createPyodideModule }] = await Promise.all([import(url("pyodide.js")), import(url("pyodide.asm.js"))]);
  const here = new URL(".", import.meta.url).href;
  const options = { indexURL: here, packageBaseUrl: here, lockFileContents: lock, createPyodideModule };
  if (memory) {
    try {
      const python = await loadPyodide({ ...options, _loadSnapshot: memory });
      const late = async () => python.FS.writeFile(python.runPython("import sys; next(p for p in sys.path if p.endswith('.zip'))"), await bytes("library.bin"));
      return { answer: python.pyimport("satviz.site.live").answer, from: "memory", late };
    } catch (error) {
      console.info(`satviz: the kept memory does not load, so Python starts anew (${error})`);
    }
  }
  anew = true;
  const [python, satviz] = await Promise.all([loadPyodide(options), bytes("satviz.bin")]);
  python.unpackArchive(satviz, "zip", { extractDir: "/satviz" });
  python.runPython("import sys; sys.path.append('/satviz')");
  return { answer: python.pyimport("satviz.site.live").answer, from: "nothing" };
}

try {
  python = await start();
  postMessage({ ready: python.from });
  for (const _ of waiting) turn.port2.postMessage(null);
  setTimeout(() => python.late?.(), LATE_MS);
} catch (error) {
  postMessage({ failed: String(error) });
}
