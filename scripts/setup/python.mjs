// A Python with SciPy: the one that SHIMMY_PYTHON names, else one that is there, else one of our own under target/.

import { existsSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { install, isRoot, onDebian } from './debian.mjs';
import { NUMPY, SCIPY } from './pins.mjs';
import { ROOT } from './root.mjs';
import { busy, Missing, tail } from './say.mjs';
import { ask, whereIs } from './shell.mjs';

const FOLDER = join(ROOT, 'target', 'python');
const OWN = process.platform === 'win32' ? join(FOLDER, 'Scripts', 'python.exe') : join(FOLDER, 'bin', 'python3');
/** Debian's own last: another may stand before it on PATH, without what apt brings. */
const NAMES = [OWN, 'python3', 'python', '/usr/bin/python3'];

/** @param {import('../setup.mjs').Tools} tools */
export function findSciPy(tools) {
  const chosen = process.env.SHIMMY_PYTHON;
  const version = chosen ? take(tools, chosen) : firstWithSciPy(tools) ?? ourOwn(tools) ?? debians(tools);
  if (version) return version;
  throw new Missing(
    chosen
      ? `SHIMMY_PYTHON names ${chosen}, and it does not import SciPy`
      : 'there is none and none can be made: install Python 3.11 or later with its venv, or name a Python that has SciPy in SHIMMY_PYTHON',
  );
}

/** The program for tests that are run by themselves; npm test names it in SHIMMY_PYTHON. */
export const pythonWithSciPy = () => process.env.SHIMMY_PYTHON ?? (existsSync(OWN) ? OWN : 'python3');

/** @param {import('../setup.mjs').Tools} tools */
const firstWithSciPy = (tools) => NAMES.map((name) => take(tools, name)).find((version) => version !== null) ?? null;

/** Takes a Python that has SciPy with the method that scripts use. @param {import('../setup.mjs').Tools} tools @param {string} name */
function take(tools, name) {
  const path = whereIs(name);
  if (!path) return null;
  const program = 'import scipy, sys; from scipy.integrate import DOP853; print(scipy.__version__, "in Python", sys.version.split()[0])';
  const { ok, out } = ask(path, ['-c', program]);
  if (!ok) return null;
  tools.python = path;
  return out;
}

/** A virtual environment with the pinned versions. @param {import('../setup.mjs').Tools} tools */
function ourOwn(tools) {
  const python = ['python3', 'python'].map((name) => whereIs(name)).find((path) => path !== null);
  if (!python) return null;
  busy('SciPy', `python3 -m venv and pip install scipy==${SCIPY}, about half a minute`);
  rmSync(FOLDER, { recursive: true, force: true });
  const made = ask(python, ['-m', 'venv', FOLDER]);
  const filled = made.ok ? ask(OWN, ['-m', 'pip', 'install', '--quiet', `numpy==${NUMPY}`, `scipy==${SCIPY}`]) : made;
  const version = filled.ok ? take(tools, OWN) : null;
  if (!version) {
    rmSync(FOLDER, { recursive: true, force: true });
    busy('SciPy', `that failed: ${tail(filled.all, 3)}`);
  }
  return version;
}

/** @param {import('../setup.mjs').Tools} tools */
function debians(tools) {
  if (!onDebian() || !isRoot()) return null;
  busy('SciPy', 'apt-get install python3-scipy');
  install(['python3-scipy']);
  return take(tools, '/usr/bin/python3');
}
