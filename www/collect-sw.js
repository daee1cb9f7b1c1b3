// Keeps the page that asks for when there is no network, so that a person who loses it can load the page again and go on.
// Whatever of this site is asked for comes from the network while there is one, and a copy stays; without one the copy
// answers. It keeps nothing of other origins, and nothing that is sent.

const FILES = ["collect.html", "base.css", "collect.css", "collect.js", "collect_bg.wasm", "boot.js", "icon.svg"];
const base = new URL("./", self.location.href).href;
const STORE = `groundling collect ${base}`;

// The address that a copy is kept under: who comes, and with which names, is nothing of it.
function nameOf(address) {
  const { origin, pathname } = new URL(address, base);
  return origin + pathname;
}

self.addEventListener("install", (event) => {
  self.skipWaiting();
  event.waitUntil(caches.open(STORE).then((store) => store.addAll(FILES.map(nameOf))));
});

// The page that is open already is served from now on, so that its study is kept, too.
self.addEventListener("activate", (event) => event.waitUntil(self.clients.claim()));

self.addEventListener("fetch", (event) => {
  const { request } = event;
  const name = nameOf(request.url);
  if (request.method !== "GET" || request.headers.has("range") || !name.startsWith(base)) return;
  event.respondWith(fetch(request).then((response) => {
    if (response.status === 200) {
      const copy = response.clone();
      event.waitUntil(caches.open(STORE).then((store) => store.put(name, copy)).catch(() => {}));
    }
    return response;
  }, async (error) => {
    const copy = await caches.match(name, { cacheName: STORE });
    if (!copy) throw error;
    return copy;
  }));
});
