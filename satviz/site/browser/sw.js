// Keeps the site's files: those with a version as they are, pages anew where there is a network.
const KEPT = "satviz VERSION";

self.addEventListener("install", () => self.skipWaiting());
self.addEventListener("activate", (event) => event.waitUntil(clean()));
self.addEventListener("fetch", (event) => {
  const { url, method } = event.request;
  if (method === "GET" && url.startsWith(self.registration.scope)) event.respondWith(answer(event, url.includes("?")));
});

async function clean() {
  for (const name of await caches.keys()) if (name.startsWith("satviz ") && name !== KEPT) await caches.delete(name);
  await self.clients.claim();
}

async function answer(event, versioned) {
  const { request } = event;
  const cache = await caches.open(KEPT);
  const kept = await cache.match(request);
  if (kept && versioned) return kept;
  try {
    const found = await fetch(request);
    // the page need not wait until a file is kept, nor go without where there is no room to keep it
    if (found.ok) event.waitUntil(cache.put(request, found.clone()).catch(() => {}));
    return found;
  } catch (error) {
    if (kept) return kept;
    throw error;
  }
}
