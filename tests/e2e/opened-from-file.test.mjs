import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { launch, untilVerdict } from './chromium.mjs';

const site = new URL('../../dist/index.html', import.meta.url).href;

/** @type {import('playwright-core').Browser} */
let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

test("the site's page, opened as a file, says that it cannot run so and leads to the one that can", async () => {
  const page = await browser.newPage();
  await page.goto(site);
  const note = page.locator('#opened-from-file');
  assert.ok(await note.isVisible());
  await note.getByRole('link', { name: 'shimmy.html' }).first().click();
  await page.waitForURL(/shimmy\.html$/);
  await untilVerdict(page, 'It shimmies');
});
