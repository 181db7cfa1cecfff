/** Starts a worker: from its own file on a site, from a text within the page where the page is one file. */

/** @returns {Promise<Worker>} */
export async function startWorker() {
  const { default: EngineWorker } =
    import.meta.env.MODE === 'single-file' ? await import('./worker.js?worker&inline') : await import('./worker.js?worker');
  return new EngineWorker();
}
