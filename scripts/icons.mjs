// Makes the PNGs of www/public/ from its icon.svg: as it is, and with corners filled for systems that cut their own.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { ROOT } from './setup/root.mjs';
import { found } from './setup/say.mjs';
import { chromiumArguments } from './setup/webdriver.mjs';
import { setUp } from './setup.mjs';

const tools = setUp('chromium');
const { chromium } = await import('playwright-core');
const browser = await chromium.launch({ executablePath: tools.chromium, args: chromiumArguments() });

const folder = join(ROOT, 'www', 'public');
const svg = readFileSync(join(folder, 'icon.svg'), 'utf8');
const filled = svg.replace(/(<rect id="sheet"[^>]*) rx="\d+"/, '$1');

/** @type {[string, number, string][]} */
const pictures = [
  ['icon-192.png', 192, svg],
  ['icon-512.png', 512, svg],
  ['icon-maskable-192.png', 192, filled],
  ['icon-maskable-512.png', 512, filled],
  ['apple-touch-icon.png', 180, filled],
];
for (const [name, size, text] of pictures) {
  const page = await browser.newPage({ viewport: { width: size, height: size } });
  await page.setContent(`<style>body { margin: 0 } svg { display: block; width: 100vw }</style>${text}`);
  await page.screenshot({ path: join(folder, name), omitBackground: true });
  await page.close();
  found('icon', name);
}
await browser.close();
