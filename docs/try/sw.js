// Keeps the files of one version of the page, each under its hash: this version, whose list is files.json with this hash.
// A version is taken whole or not at all, and a page that is open stays with the version that it began with.
const VERSION = "{version}";
const LIST = "files.json";
const worker = /** @type {ServiceWorkerGlobalScope} */ (/** @type {unknown} */ (self));
const SCOPE = worker.registration.scope;

/** @param {string} name @param {string} integrity */
const key = (name, integrity) => `${SCOPE}${name}?${integrity}`;
const opened = () => caches.open("gyrostat");

/**
 * A file of this version, kept; what is not kept is fetched, and is the file that it has to be.
 * @param {string} name
 * @param {string} integrity
 * @returns {Promise<Response>}
 */
async function file(name, integrity) {
  const store = await opened(), place = key(name, integrity), kept = await store.match(place);
  if (kept) return kept;
  const response = await fetch(SCOPE + name, { integrity, cache: "no-cache" });
  if (!response.ok) throw new Error(`${name}: ${response.status}`);
  await store.put(place, response.clone());
  return response;
}

/** @type {Promise<Record<string, { integrity: string }>> | undefined} */
let list;
/** The list of this version. */
function listed() {
  list ??= file(LIST, VERSION).then((response) => response.json());
  list.catch(() => { list = undefined; });
  return list;
}

async function whole() {
  await Promise.all(Object.entries(await listed()).map(([name, { integrity }]) => file(name, integrity)));
}

// No page is open that began with another version.
async function alone() {
  const store = await opened(), files = Object.entries(await listed());
  const needed = new Set([key(LIST, VERSION), ...files.map(([name, { integrity }]) => key(name, integrity))]);
  for (const { url } of await store.keys()) if (!needed.has(url)) await store.delete(url);
}

/** @param {string} name @param {Request} request */
async function answer(name, request) {
  if (name === LIST) return file(LIST, VERSION);
  const entry = (await listed())[name];
  return entry ? file(name, entry.integrity) : fetch(request);
}

worker.addEventListener("install", (event) => event.waitUntil(whole()));
worker.addEventListener("activate", (event) => event.waitUntil(alone()));
worker.addEventListener("fetch", (event) => {
  const { request } = event, [address] = request.url.split(/[?#]/);
  const name = address.slice(SCOPE.length) || "index.html";
  // The archives are kept unpacked, by the threads that unpack them, which look there first.
  if (request.method !== "GET" || !address.startsWith(SCOPE) || name === "sw.js" || name.endsWith(".xz")) return;
  event.respondWith(answer(name, request));
});
// A page that came without this worker is its own if it is of the same version.
worker.addEventListener("message", (event) => {
  if (event.data === VERSION) event.waitUntil(worker.clients.claim());
});
