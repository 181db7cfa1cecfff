// Our time on one run beside that of others, all at the same error and measured in the same minute; nothing is asserted.
// `--quick` leaves out what takes long: the other crates and their build, the slow Python solvers, the table of methods.

import { existsSync, readFileSync } from 'node:fs';
import { cpus } from 'node:os';
import { join } from 'node:path';
import { brotliCompressSync, gzipSync } from 'node:zlib';
import { ensureModule } from './build-wasm.mjs';
import { ROOT } from './setup/root.mjs';
import { end, RunFailed } from './setup/run.mjs';
import { found, tail } from './setup/say.mjs';
import { ask } from './setup/shell.mjs';
import { setUp } from './setup.mjs';
import * as report from '../benches/javascript/report.js';

/** @typedef {import('../benches/javascript/report.js').Entry} Entry */

const BENCHES = join(ROOT, 'benches');
const NATIVE = join(BENCHES, 'native');
/** Without the other crates; and for the processor that is here, beside the flags of .cargo/config.toml. */
const ALONE = ['--no-default-features'];
const THIS_CPU = ['--config', 'build.rustflags=["-Ctarget-cpu=native"]'];

const quick = process.argv.includes('--quick');

/**
 * Runs a program that prints lines of JSON, and reads them.
 * @param {string} program
 * @param {string[]} args
 * @param {NodeJS.ProcessEnv} env
 * @param {string} [cwd]
 * @returns {any[]}
 */
function measure(program, args, env, cwd = ROOT) {
  const { ok, out, all } = ask(program, quick ? [...args, '--quick'] : args, { env, cwd });
  if (!ok) throw new RunFailed(`${program} ${args.join(' ')}:\n${tail(all)}`);
  return out.split('\n').filter((line) => line.startsWith('{')).map((line) => JSON.parse(line));
}

/**
 * Builds the native contestants and runs them.
 * @param {NodeJS.ProcessEnv} env
 * @param {string} folder of the build, within benches/native/target
 * @param {...string} flags
 */
function native(env, folder, ...flags) {
  const target = join(NATIVE, 'target', folder);
  const { ok, all } = ask('cargo', ['build', '--release', '--locked', '--target-dir', target, ...flags], { env, cwd: NATIVE });
  if (!ok) throw new RunFailed(`cargo build in benches/native:\n${tail(all)}`);
  return measure(join(target, 'release', 'shimmy-bench'), [], env);
}

/** The libraries in JavaScript have a lock file of their own, which nothing but this command needs. @param {NodeJS.ProcessEnv} env */
function installPeers(env) {
  const cwd = join(BENCHES, 'javascript');
  if (existsSync(join(cwd, 'node_modules', 'odex')) && existsSync(join(cwd, 'node_modules', 'ode45-cash-karp'))) return;
  const npm = process.env.npm_execpath?.endsWith('.js') ? [process.execPath, process.env.npm_execpath] : ['npm'];
  const { ok, all } = ask(npm[0], [...npm.slice(1), 'ci'], { env, cwd });
  if (!ok) throw new RunFailed(`npm ci in benches/javascript:\n${tail(all)}`);
}

function main() {
  const tools = setUp('native', 'module', 'python', 'chromium');
  ensureModule(tools);
  installPeers(tools.native);
  const node = (/** @type {string} */ file) =>
    measure(process.execPath, [join(BENCHES, 'javascript', file)], { ...tools.native, SHIMMY_CHROMIUM: tools.chromium });

  found('benchmark', `one process at a time on ${cpus().length} × ${cpus()[0]?.model ?? 'unknown'}`);
  const lines = [
    ...node('in-node.js'),
    ...node('in-chromium.js'),
    ...(quick ? native(tools.native, 'quick', ...ALONE) : native(tools.native, 'plain')),
    ...(quick ? [] : native(tools.native, 'this-cpu', ...ALONE, ...THIS_CPU)),
    ...node('peers.js'),
    ...measure(tools.python, [join(BENCHES, 'peers.py')], tools.native),
    ...measure(tools.python, [join(BENCHES, 'identification.py')], tools.native),
  ];

  const entries = /** @type {Entry[]} */ (lines.filter((line) => line.solver));
  for (const line of lines) {
    if (line.missing) console.log(`  ${line.missing} was not found: its solvers are left out`);
    if (line.found) console.log(`  ${line.found}`);
    if (line.flags) console.log(`  native, built with ${line.flags}`);
    if (line.tight) console.log(`  our dop853 at rtol 1e-13 and the reference differ by ${report.powers(line.tight)} at the two times`);
  }
  console.log(`\n${report.contest(entries)}`);
  console.log(`\n${report.goals(entries)}`);
  console.log(`\n${report.maps(lines.filter((line) => line.map).map((line) => line.map))}`);
  console.log(`\n${report.branches(lines.filter((line) => line.branch).map((line) => line.branch))}`);
  console.log(`\n${report.ensembles(lines.filter((line) => line.ensemble).map((line) => line.ensemble))}`);
  console.log(`\n${report.identifications(lines.filter((line) => line.identification).map((line) => line.identification))}`);
  const rows = lines.filter((line) => line.row).map((line) => line.row);
  if (rows.length) console.log(`\n${report.workAndPrecision(rows)}`);
  console.log(`\n${report.warmUps(lines.filter((line) => line.warmUp).map((line) => line.warmUp))}`);

  const module = readFileSync(join(ROOT, 'www', 'pkg', 'shimmy_bg.wasm'));
  console.log(`\n${report.bytes(module.length, gzipSync(module, { level: 9 }).length, brotliCompressSync(module).length)}`);
}

try {
  main();
} catch (error) {
  end(error);
}
