// Takes the README's picture: the page as it opens, a few seconds later, in the light theme.

import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { bundlePage } from './build.mjs';
import { ensureModule } from './build-wasm.mjs';
import { ROOT } from './setup/root.mjs';
import { end } from './setup/run.mjs';
import { found } from './setup/say.mjs';
import { chromiumArguments } from './setup/webdriver.mjs';
import { setUp } from './setup.mjs';

const tools = setUp('module', 'chromium');
try {
  ensureModule(tools);
  bundlePage(tools);
} catch (error) {
  end(error);
}

const { chromium } = await import('playwright-core');
const browser = await chromium.launch({ executablePath: tools.chromium, args: chromiumArguments() });
const page = await browser.newPage({ viewport: { width: 1440, height: 900 }, colorScheme: 'light' });
await page.goto(pathToFileURL(join(ROOT, 'dist', 'shimmy.html')).href);
await page.getByText('It shimmies').first().waitFor();
await page.waitForTimeout(9000);

const path = join('.github', 'screenshot.png');
await page.screenshot({ path: join(ROOT, path) });
await browser.close();
found('screenshot', path);
