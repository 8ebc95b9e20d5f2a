// The service worker: whatever the lab consists of is kept at the first visit, so that later ones need no network.
// The build puts a version and the list of files in place of the empty ones.

const [version, files] = /** @type {[string, string[]]} */ (["", []]);
const scope = /** @type {ServiceWorkerGlobalScope} */ (/** @type {unknown} */ (globalThis));
const store = `precess-${version}`;

scope.addEventListener("install", (event) => {
  event.waitUntil(
    caches
      .open(store)
      .then((cache) => cache.addAll(["./", "icon.svg", ...files]))
      .then(() => scope.skipWaiting()),
  );
});

scope.addEventListener("activate", (event) => {
  const clear = async () => {
    for (const key of await caches.keys())
      if (key.startsWith("precess-") && key !== store) await caches.delete(key);
    await scope.clients.claim();
  };
  event.waitUntil(clear());
});

/** @param {Request} request */
async function answer(request) {
  const kept = await caches.match(request, { ignoreSearch: true, ignoreVary: true });
  // Names of files change with what is in them; the page itself is asked for first, so that a newer one is seen.
  if (request.mode !== "navigate") return kept ?? fetch(request);
  try {
    return await fetch(request);
  } catch (error) {
    const page = kept ?? (await caches.match("./"));
    if (page) return page;
    throw error;
  }
}

scope.addEventListener("fetch", (event) => {
  const { request } = event;
  if (request.method === "GET" && new URL(request.url).origin === location.origin) {
    event.respondWith(answer(request));
  }
});
