// dist/index.html cannot run from a double-click: browsers load modules from a server only.
// It says so itself and points to shimmy.html, which can.

import { openedFromFileEn, openedFromFileTr } from '../../www/words/opened-from-file.js';

const ID = 'opened-from-file';

const STYLE =
  'position:fixed;inset:0;z-index:9;margin:0;padding:20vh 12vw;background:#f4f3ee;color:#14202b;font:22px/1.5 sans-serif';

/** A classic script, for a module would not run. */
const SHOW = `if (location.protocol === 'file:') document.getElementById('${ID}').hidden = false;`;

/** @param {string} language @param {string} words */
const paragraph = (language, words) =>
  `<p lang="${language}">${words.replace('{link}', '<a href="shimmy.html">shimmy.html</a>')}</p>`;

/** @returns {import('vite').Plugin} */
export const openedFromFile = () => ({
  name: 'opened-from-file',
  apply: 'build',
  transformIndexHtml: () => [
    {
      tag: 'div',
      attrs: { id: ID, hidden: true, style: STYLE },
      children: paragraph('en', openedFromFileEn) + paragraph('tr', openedFromFileTr),
      injectTo: 'body-prepend',
    },
    { tag: 'script', children: SHOW, injectTo: 'body-prepend' },
  ],
});
