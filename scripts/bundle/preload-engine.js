// The engine's module is asked for while the page's script still arrives, not after it: the wheel moves the sooner.
// Only for the site; the single file has the module inside. The one for ensembles comes when there is one to move.

/** @returns {import('vite').Plugin} */
export const preloadEngine = () => ({
  name: 'preload-engine',
  apply: 'build',
  transformIndexHtml: {
    order: 'post',
    handler: (_, { bundle = {} }) =>
      Object.keys(bundle)
        .filter((name) => /shimmy_bg[^/]*\.wasm$/.test(name))
        .map((name) => ({
          tag: 'link',
          // As fetch() asks for it, or the browser would fetch it twice.
          attrs: { rel: 'preload', as: 'fetch', type: 'application/wasm', crossorigin: true, href: `./${name}` },
          injectTo: /** @type {const} */ ('head'),
        })),
  },
});
