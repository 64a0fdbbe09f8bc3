// The service worker keeps the site's files: those with a version as they are; pages anew where there is a network.

/** @type {ServiceWorkerGlobalScope} */
const worker = /** @type {any} */ (self);
const CACHE_NAME = "satviz VERSION";

worker.addEventListener("install", () => worker.skipWaiting());
worker.addEventListener("activate", (event) => event.waitUntil(removeOldCaches()));
worker.addEventListener("fetch", (event) => {
  const { url, method } = event.request;
  if (method === "GET" && url.startsWith(worker.registration.scope)) event.respondWith(answer(event, url.endsWith("?VERSION")));
});

async function removeOldCaches() {
  for (const name of await caches.keys()) if (name.startsWith("satviz ") && name !== CACHE_NAME) await caches.delete(name);
  await worker.clients.claim();
}

/**
 * @param {FetchEvent} event
 * @param {boolean} versioned A page may have a query of its own, which changes nothing in its file.
 */
async function answer(event, versioned) {
  const { request } = event;
  const cache = await caches.open(CACHE_NAME);
  const kept = await cache.match(request, { ignoreSearch: !versioned });
  if (kept && versioned) return kept;
  try {
    const found = await fetch(request);
    // The page does not wait until a file is kept, and gets it also where there is no space to keep it.
    if (found.ok) event.waitUntil(cache.put(versioned ? request : request.url.replace(/[?#].*/, ""), found.clone()).catch(() => {}));
    return found;
  } catch (error) {
    if (kept) return kept;
    throw error;
  }
}
