// What apt and dpkg know. Only where the system is Debian's kind and we may install.

import { ask, whereIs } from './shell.mjs';
import { Missing, tail } from './say.mjs';

export const onDebian = () => whereIs('apt-get') !== null && whereIs('dpkg-query') !== null;

export const isRoot = () => process.getuid?.() === 0;

/** The installed version of a package, or null. @param {string} name */
export function packageVersion(name) {
  const { ok, out } = ask('dpkg-query', ['--show', '--showformat=${db:Status-Status} ${Version}', name]);
  return ok && out.startsWith('installed ') ? out.slice('installed '.length) : null;
}

/**
 * The file of an installed package whose path ends so.
 * @param {string} name
 * @param {string} ending
 * @returns {string}
 */
export function packageFile(name, ending) {
  const path = ask('dpkg-query', ['--listfiles', name]).out.split('\n').find((line) => line.endsWith(ending));
  if (!path) throw new Missing(`Debian's package ${name} holds no file …${ending}`);
  return path;
}

let listsAreFresh = false;

/**
 * Installs packages; the lists of what there is are brought up to date once a run.
 * @param {string[]} names
 */
export function install(names) {
  const env = { ...process.env, DEBIAN_FRONTEND: 'noninteractive' };
  if (!listsAreFresh) ask('apt-get', ['update'], { env });
  listsAreFresh = true;
  const { ok, all } = ask('apt-get', ['install', '--yes', '--no-install-recommends', ...names], { env });
  if (!ok) throw new Missing(`apt-get install ${names.join(' ')} failed:\n${tail(all)}`);
}
