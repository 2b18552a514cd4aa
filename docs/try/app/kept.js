// A service worker keeps this version of the page, so that the next visit needs no network. A browser that lets a page
// keep nothing goes on without.

/** @param {string} version the hash of the list of files with which this page works */
export async function keep(version) {
  try {
    await navigator.serviceWorker.register("sw.js", { updateViaCache: "none" });
    const { active } = await navigator.serviceWorker.ready;
    active?.postMessage(version);
  } catch {
    // Without it the page works as it does with the network.
  }
}
