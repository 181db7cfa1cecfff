import assert from 'node:assert/strict';
import { test } from 'node:test';
import { untilVerdict, withPage } from './chromium.mjs';

const address = new URL('../../dist/index.html', import.meta.url).href;
const site = withPage(null);

test("the site's page, opened as a file, says that it cannot run so and leads to the one that can", async () => {
  const page = await site.browser.newPage();
  await page.goto(address);
  const note = page.locator('#opened-from-file');
  assert.ok(await note.isVisible());
  await note.getByRole('link', { name: 'shimmy.html' }).first().click();
  await page.waitForURL(/shimmy\.html$/);
  await untilVerdict(page, 'It shimmies');
});
