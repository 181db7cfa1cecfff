/**
 * Has the browser keep the site, for visits without a network; never where the page is a file. Some while after the
 * start, which needs the line and the processor for itself.
 */
export function registerOffline() {
  if (!location.protocol.startsWith('http') || !('serviceWorker' in navigator)) return;
  window.addEventListener('load', () => setTimeout(() => {
    navigator.serviceWorker.register('./service-worker.js', { updateViaCache: 'none' }).catch(() => {
      // A private window, a full disk, no network: the page works on, and is kept at a later visit.
    });
  }, 1000));
}
