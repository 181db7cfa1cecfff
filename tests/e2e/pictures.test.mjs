// Every picture that the sheet under Share offers arrives on the disk, whatever is on the screen.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { test } from 'node:test';
import { viewNames } from '../../www/lens/stability/settings.js';
import { viewsOfLens } from '../../www/lens/views.js';
import { untilVerdict, withPage } from './chromium.mjs';

const site = withPage();

const looks = [
  ...viewsOfLens.phase.map((view) => `view.phase=${view}`),
  ...viewsOfLens.forces.map((view) => `lens=forces&view.forces=${view}`),
  ...viewNames.map((view) => `lens=stability&view.stability=${view}`),
  'lens=compare&ghost=0,torsional,dampingConstant:60,state.torsionAngle:0.05',
];

for (const [at, look] of looks.entries())
  test(`what the sheet offers with ${look} is made`, async () => {
    const { page, leave } = await site.open(`#shimmy=2&velocity=80&dampingConstant=20&initial.torsionAngle=0.05&${look}`, { reducedMotion: 'reduce' });
    await untilVerdict(page, 'It shimmies');
    await page.waitForTimeout(300);
    await page.getByText('Share', { exact: true }).click();
    const pictures = page.locator('.out-picture button');
    const count = await pictures.count();
    assert.ok(count >= 4, 'the gear and the timeline at least, as pixels and as lines');
    // The stage is the same beside every lens: its two pictures, as pixels and as lines, are asked for once.
    for (let i = at === 0 ? 0 : 4; i < count; i++) {
      const name = await pictures.nth(i).getAttribute('aria-label');
      const arriving = page.waitForEvent('download', { timeout: 10_000 });
      await pictures.nth(i).click();
      const file = await readFile(await (await arriving.catch(async () => assert.fail(`${name}: ${await page.locator('.out-said').innerText()}`))).path());
      if (name?.endsWith('SVG')) {
        const text = file.toString();
        assert.match(text, /^<svg[^>]*>/, name);
        assert.doesNotMatch(text.replaceAll(/data:[^"]*/g, ''), /NaN|undefined|Infinity/, name);
      } else assert.equal(file.subarray(1, 4).toString(), 'PNG', name ?? '');
    }
    await leave();
  });
