// What makes dist/index.html an app to install: its manifest, its sign on a telephone's desktop, the color of the frame.
// The files are in www/public/.

/** @param {string} content @param {string} scheme @returns {import('vite').HtmlTagDescriptor} */
const themeColor = (content, scheme) => ({
  tag: 'meta',
  attrs: { name: 'theme-color', content, media: `(prefers-color-scheme: ${scheme})` },
  injectTo: 'head',
});

/** @returns {import('vite').Plugin} */
export const installable = () => ({
  name: 'installable',
  apply: 'build',
  transformIndexHtml: () => [
    { tag: 'link', attrs: { rel: 'manifest', href: './manifest.webmanifest' }, injectTo: 'head' },
    { tag: 'link', attrs: { rel: 'apple-touch-icon', href: './apple-touch-icon.png' }, injectTo: 'head' },
    // The header's surface, as style/tokens.css has it.
    themeColor('#ffffff', 'light'),
    themeColor('#1a222b', 'dark'),
  ],
});
