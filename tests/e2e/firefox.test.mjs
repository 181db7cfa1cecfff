// The page in Firefox: opens, the wheel moves, nothing goes wrong.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Builder, By, until } from 'selenium-webdriver';
import firefox from 'selenium-webdriver/firefox.js';
import { fileAddress, serve } from './site.mjs';

/** Collects what goes wrong from the start of the page on; WebDriver has no log of Firefox' console. */
const watch = `
  window.complaints = [];
  addEventListener('error', ({ message }) => complaints.push(message));
  addEventListener('unhandledrejection', ({ reason }) => complaints.push(String(reason)));
  addEventListener('securitypolicyviolation', ({ violatedDirective, blockedURI }) => complaints.push(violatedDirective + ' ' + blockedURI));
  for (const kind of ['error', 'warn']) console[kind] = (...words) => complaints.push(words.join(' '));`;

const pixels = `
  const canvas = document.querySelector('.gear canvas');
  const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  let hash = 0;
  for (let i = 0; i < data.length; i += 4) hash = (hash * 31 + data[i]) | 0;
  return hash;`;

test('in Firefox it opens, from a server and from a file, and the wheel moves', async (t) => {
  const server = await serve();
  t.after(() => server.close());
  const options = new firefox.Options().addArguments('-headless').windowSize({ width: 1440, height: 900 });
  options.setBinary(process.env.SHIMMY_FIREFOX ?? '/usr/bin/firefox-esr');
  const service = new firefox.ServiceBuilder(process.env.SHIMMY_GECKODRIVER ?? 'geckodriver');
  const driver = await new Builder().forBrowser('firefox').setFirefoxOptions(options).setFirefoxService(service).build();
  t.after(() => driver.quit());
  for (const address of [server.address, fileAddress]) {
    await driver.get(address);
    await driver.executeScript(watch);
    const verdict = await driver.wait(until.elementLocated(By.css('shimmy-verdict h1')), 10_000);
    assert.equal(await verdict.getText(), 'It shimmies');
    const one = await driver.executeScript(pixels);
    await driver.sleep(300);
    assert.notEqual(await driver.executeScript(pixels), one, 'the wheel stands still');
    assert.match(await driver.findElement(By.css('.destination')).getText(), /0\.26508 rad\) · 51\.87 Hz/);
    assert.deepEqual(await driver.executeScript('return window.complaints'), []);
  }
});
