// Node.js itself and the npm packages of the lock file.

import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { ask } from './shell.mjs';
import { busy, Missing, tail } from './say.mjs';
import { ROOT } from './root.mjs';

/** @returns {string} */
export function findNode() {
  const { engines } = JSON.parse(readFileSync(join(ROOT, 'package.json'), 'utf8'));
  if (!serves(process.versions.node, engines.node)) {
    throw new Missing(`this is ${process.version}, and ${engines.node} is needed: https://nodejs.org`);
  }
  return process.version;
}

/**
 * Whether a version is in a range of the form `^20.19.0 || >=22.12.0`.
 * @param {string} version @param {string} range
 */
function serves(version, range) {
  const [major, minor] = version.split('.').map(Number);
  return range.split('||').some((part) => {
    const [wantedMajor, wantedMinor] = part.match(/\d+/g)?.map(Number) ?? [0, 0];
    const same = major === wantedMajor && minor >= wantedMinor;
    return same || (part.includes('>=') && major > wantedMajor);
  });
}

/** Installs what the lock file says, unless it is there already. @returns {string} */
export function installPackages() {
  if (packagesAreThere()) return 'as the lock file says';
  busy('npm packages', 'npm ci');
  const { ok, all } = npm('ci');
  if (!ok) throw new Missing(`npm ci failed:\n${tail(all)}`);
  return 'installed as the lock file says';
}

/** npm notes what it installed in node_modules: every version must be the lock file's; optional ones may be absent. */
function packagesAreThere() {
  const path = join(ROOT, 'node_modules', '.package-lock.json');
  if (!existsSync(path)) return false;
  const { '': _, ...wanted } = readPackages(join(ROOT, 'package-lock.json'));
  const here = readPackages(path);
  return Object.entries(wanted).every(([name, { version, optional }]) =>
    here[name] ? here[name].version === version : optional,
  );
}

/** @param {string} path @returns {Record<string, {version: string, optional?: boolean}>} */
const readPackages = (path) => JSON.parse(readFileSync(path, 'utf8')).packages;

/** npm run by this very Node.js when npm started us, else the one on PATH. @param {...string} args */
function npm(...args) {
  const script = process.env.npm_execpath;
  return script?.endsWith('.js')
    ? ask(process.execPath, [script, ...args], { cwd: ROOT })
    : ask('npm', args, { cwd: ROOT });
}
