// Chromium and Firefox with their drivers: those of the system. On Debian root has apt bring them.

import { ask, whereIs } from './shell.mjs';
import { busy, Missing } from './say.mjs';
import { install, isRoot, onDebian } from './debian.mjs';
import { cargoTool } from './cargo-tools.mjs';
import { GECKODRIVER } from './pins.mjs';
import { writeWebdriverFiles } from './webdriver.mjs';

const CHROMIUMS = [
  'chromium',
  'chromium-browser',
  'google-chrome',
  'google-chrome-stable',
  '/Applications/Google Chrome.app/Contents/MacOS/Google Chrome',
  '/Applications/Chromium.app/Contents/MacOS/Chromium',
];
const FIREFOXES = ['firefox', 'firefox-esr', '/Applications/Firefox.app/Contents/MacOS/firefox'];

/** @param {import('../setup.mjs').Tools} tools */
export function findChromium(tools) {
  tools.chromium = program('Chromium', 'SHIMMY_CHROMIUM', CHROMIUMS, 'chromium', 'install Chromium or Chrome');
  return versionOf(tools.chromium);
}

/** The driver speaks to a browser of its own version only. @param {import('../setup.mjs').Tools} tools */
export function findChromedriver(tools) {
  const advice = "put the ChromeDriver of your Chromium's version on PATH (https://googlechromelabs.github.io/chrome-for-testing)";
  tools.chromedriver = program('ChromeDriver', 'SHIMMY_CHROMEDRIVER', ['chromedriver'], 'chromium-driver', advice);
  const [driver, browser] = [tools.chromedriver, tools.chromium].map(versionOf);
  if (parseInt(driver) !== parseInt(browser)) throw new Missing(`it is of version ${driver} and Chromium of ${browser}: ${advice}`);
  return driver;
}

/** @param {import('../setup.mjs').Tools} tools */
export function findFirefox(tools) {
  tools.firefox = program('Firefox', 'SHIMMY_FIREFOX', FIREFOXES, 'firefox-esr', 'install Firefox');
  return versionOf(tools.firefox);
}

/** Any version serves; where there is none cargo builds one. @param {import('../setup.mjs').Tools} tools */
export function findGeckodriver(tools) {
  const wanted = process.env.SHIMMY_GECKODRIVER ?? 'geckodriver';
  let path = whereIs(wanted, tools.wasm);
  const text = path ? versionOf(path) : cargoTool(tools, 'geckodriver', 'geckodriver', GECKODRIVER, [], 2);
  path ??= whereIs(wanted, tools.wasm);
  if (!path) throw new Missing(`cargo built it, and it is not found as ${wanted}`);
  tools.geckodriver = path;
  tools.webdriver = writeWebdriverFiles(tools);
  return text;
}

/**
 * The path of a program: as the variable says, else the first of the names that is there, else what apt brings.
 * @param {string} step
 * @param {string} variable
 * @param {string[]} names
 * @param {string} debianPackage
 * @param {string} advice
 * @returns {string}
 */
function program(step, variable, names, debianPackage, advice) {
  const chosen = process.env[variable];
  if (chosen) return whereIs(chosen) ?? giveUp(`${variable} names ${chosen}, and no program is there`);
  const path = firstOf(names);
  if (path) return path;
  if (!onDebian()) return giveUp(`not found: ${advice}, or name it in ${variable}`);
  if (!isRoot()) return giveUp(`not found; as root: apt-get install ${debianPackage} (or name it in ${variable})`);
  busy(step, `apt-get install ${debianPackage}`);
  install([debianPackage]);
  return firstOf(names) ?? giveUp(`apt-get installed ${debianPackage}, and none of ${names.join(', ')} is there`);
}

/** @param {string[]} names */
const firstOf = (names) => names.map((name) => whereIs(name)).find((path) => path !== null);

/** @param {string} why @returns {never} */
function giveUp(why) {
  throw new Missing(why);
}

/** @param {string} path */
const versionOf = (path) => ask(path, ['--version']).out.match(/\d+(\.\d+)+/)?.[0] ?? 'of unknown version';
