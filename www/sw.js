// Keeps the site for when there is no network. Whatever of this site is asked for comes from the network while there
// is one, and a copy stays; without one the copy answers. A first visit keeps everything, what is wanted later
// included. Other origins, other sites of the same origin and parts of files are none of its business.

const scope = self.registration.scope;
const STORE = `groundling ${scope}`;

// What the page's programs load by themselves; what else there is, the page names.
const LATER = ["engine.js", "learner.js", "learner_bg.wasm", "renderer.js", "renderer_bg.wasm", "keeper.js", "keeper_bg.wasm", "workbench.js", "workbench_bg.wasm", "workbench.css", "cleanup.model", "words.txt", "robot.html", "robot.css", "robot.js", "robot_bg.wasm", "help.en.html", "help.de.html"];

// The address that a copy is kept under: the engine's script is one file, whichever program it is asked for.
function nameOf(address) {
  const { origin, pathname } = new URL(address, scope);
  return origin + pathname.replace(/index\.html$/, "");
}

// All of the site, as this page of it says.
function filesOf(page) {
  const named = [...page.matchAll(/\b(?:href|src|data-late)="?([^"\s>]+)/g)].map(([, name]) => nameOf(name));
  return new Set([scope, ...LATER.map(nameOf), ...named].filter((name) => name.startsWith(scope)));
}

// Keeps all of a page's site, and nothing of the one before it: not every name changes with what it names.
async function keepAll(page) {
  const store = await caches.open(STORE);
  const files = filesOf(page);
  await store.addAll([...files]);
  const old = (await store.keys()).filter(({ url }) => !files.has(url));
  await Promise.all(old.map((request) => store.delete(request)));
}

async function keep(name, response) {
  const store = await caches.open(STORE);
  const before = name === scope && await store.match(name);
  const page = name === scope && await response.clone().text();
  await store.put(name, response);
  if (before && page !== await before.text()) await keepAll(page);
}

self.addEventListener("install", (event) => {
  self.skipWaiting();
  event.waitUntil(fetch(scope).then(async (response) => {
    if (response.ok) await keepAll(await response.text());
  }));
});

self.addEventListener("fetch", (event) => {
  const { request } = event;
  const name = nameOf(request.url);
  if (request.method !== "GET" || request.headers.has("range") || !name.startsWith(scope)) return;
  event.respondWith(fetch(request).then((response) => {
    // A copy that cannot be kept, for want of room, is none; the page has its answer.
    if (response.status === 200) event.waitUntil(keep(name, response.clone()).catch(() => {}));
    return response;
  }, async (error) => {
    const copy = await caches.match(name, { cacheName: STORE });
    if (!copy) throw error;
    // An answer of its own has the address that was asked for, which tells the engine which program it is.
    return new Response(copy.body, copy);
  }));
});
