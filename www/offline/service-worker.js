/**
 * The site without a network. `release.json`, which the build writes, lists its files, each with the hash of its content.
 * They lie on a shelf of their own: all of one build, or none.
 *
 * A visit is answered from the shelf, whole: no page meets the files of another build. Meanwhile the list is asked for
 * anew; where it has changed, the new build is stocked, and serves from the next visit on. The shelf before stays for
 * pages still open, which may yet ask for a file of theirs; older ones go.
 *
 * This script never changes with a build. Browsers look for a changed one when they are idle, and beside a page that
 * draws without a pause they may never be.
 *
 * @typedef {Event & { waitUntil: (work: Promise<unknown>) => void }} Extendable
 * @typedef {Extendable & { request: Request, respondWith: (answer: Promise<Response>) => void }} Asked
 * @typedef {{ version: string, files: Record<string, string> }} Release
 */

const worker = /** @type {{ registration: { scope: string }, skipWaiting: () => Promise<void> }} */ (/** @type {unknown} */ (self));
/** Where the site lies: other sites of this origin, and other copies of this one, have shelves of their own. */
const { scope } = worker.registration;
const shelves = `shimmy ${scope} `;
const list = `${scope}release.json`;

/** One look for a new build at a time. @type {Promise<void> | null} */
let renewing = null;

self.addEventListener('install', (event) => {
  /** @type {Extendable} */ (event).waitUntil(renew().then(() => worker.skipWaiting()));
});

self.addEventListener('fetch', (event) => {
  const asked = /** @type {Asked} */ (event);
  const address = addressOf(asked.request);
  if (!address) return;
  asked.respondWith(answer(address, asked.request));
  // Without a network there is nothing new.
  if (asked.request.mode === 'navigate') asked.waitUntil(renew().catch(() => {}));
});

/**
 * What to look for on the shelf; nothing where a request is none of the site's. The page itself is one, whatever its
 * address carries. shimmy.html lies beside the site and is none of it.
 * @param {Request} request
 */
function addressOf({ method, mode, url }) {
  const { origin, pathname } = new URL(url);
  const address = origin + pathname;
  if (method !== 'GET' || !address.startsWith(scope)) return null;
  if (mode !== 'navigate') return address;
  return address === scope || address === `${scope}index.html` ? scope : null;
}

/** @param {string} address @param {Request} request */
async function answer(address, request) {
  const shelf = await current();
  const kept = shelf && await (await caches.open(shelf)).match(address);
  return kept || await caches.match(address) || fetch(request);
}

/** The newest shelf that is whole: its list is laid there last. */
async function current() {
  const names = (await caches.keys()).filter((name) => name.startsWith(shelves)).reverse();
  for (const name of names) if (await (await caches.open(name)).match(list)) return name;
  return null;
}

function renew() {
  renewing ??= lookForNew().finally(() => { renewing = null; });
  return renewing;
}

async function lookForNew() {
  const response = await fetch(list, { cache: 'no-cache' });
  if (!response.ok) throw new Error(`${list}: ${response.status}`);
  const { version, files } = /** @type {Release} */ (await response.clone().json());
  const before = await current();
  const shelf = shelves + version;
  if (shelf === before) return;
  await stock(shelf, files, response);
  const others = (await caches.keys()).filter((name) => name.startsWith(shelves) && name !== shelf && name !== before);
  await Promise.all(others.map((name) => caches.delete(name)));
}

/**
 * Brings every file, or none.
 * @param {string} shelf @param {Release['files']} files @param {Response} response the list itself
 */
async function stock(shelf, files, response) {
  await caches.delete(shelf);
  const cache = await caches.open(shelf);
  try {
    await Promise.all(Object.entries(files).map(async ([path, integrity]) => {
      const address = new URL(path, scope).href;
      // A file named by its content that is here already is the same file.
      const known = path.startsWith('assets/') ? await caches.match(address) : undefined;
      const brought = known ?? await fetch(address, { integrity, cache: 'no-cache' });
      if (!brought.ok) throw new Error(`${address}: ${brought.status}`);
      await cache.put(address, brought);
    }));
    await cache.put(list, response);
  } catch (error) {
    await caches.delete(shelf);
    throw error;
  }
}
