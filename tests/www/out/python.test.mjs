// The scripts that the page gives out, run as anybody would.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { pythonWithSciPy } from '../../../scripts/setup/python.mjs';
import { pythonModel } from '../../../www/out/python/model.js';
import { pythonOf } from '../../../www/out/python.js';
import { shimmy } from '../../node/module.mjs';
import { opening, tableOf, wholeRun } from './runs.mjs';

const folder = mkdtempSync(join(tmpdir(), 'shimmy-python-'));
after(() => rmSync(folder, { recursive: true, force: true }));

const link = 'https://example.org/shimmy/#shimmy=1&velocity=80';

/** @param {ReturnType<typeof wholeRun>} run */
const scriptOf = (run) =>
  pythonOf(run, tableOf(run.model), shimmy.simulate({ ...run, samples: 21 }), { file: 'run.py', link });

/** @param {string} script */
function python(script) {
  const path = join(folder, 'run.py');
  writeFileSync(path, script);
  const { status, stdout, stderr, error } = spawnSync(pythonWithSciPy(), [path], { encoding: 'utf8', env: { ...process.env, PYTHONIOENCODING: 'ascii' } });
  assert.equal(error, undefined);
  return { status, stdout, stderr };
}

/** @type {[string, ReturnType<typeof wholeRun>][]} */
const runs = [
  ['the opening run', opening()],
  ['a rattle in the gap', wholeRun('torsional', { velocity: 50, dampingConstant: 100, freeplayAngle: Math.PI / 180 }, 2)],
  ['the linear gear', wholeRun('torsional-linear', { velocity: 80, dampingConstant: 60 }, 2)],
  ['dry friction that turns with the wheel', wholeRun('torsional', { velocity: 80, dampingConstant: 20, 'friction.moment': 60 }, 2)],
  ['dry friction that sticks in every swing', wholeRun('torsional', { velocity: 5, dampingConstant: 0, torsionalStiffness: 2000, casterLength: 0.05, 'friction.moment': 1000 }, 2)],
  ['the linear gear, held in the end', wholeRun('torsional-linear', { velocity: 40, dampingConstant: 60, 'friction.moment': 60 }, 2)],
];

for (const [name, run] of runs) {
  test(`SciPy comes to our numbers: ${name}`, () => {
    const { status, stdout, stderr } = python(scriptOf(run));
    assert.equal(status, 0, stdout + stderr);
    assert.equal(stderr, '');
    assert.match(stdout, /The two agree\./);
    // Twenty-one rows, and both ends of the run among them.
    assert.equal(stdout.split('\n').filter((line) => /^ +\d+\.\d{4} /.test(line)).length, 21);
    assert.match(stdout, /^ +2\.0000 /m);
  });
}

test('a script in which one parameter was changed finds the difference', () => {
  const script = scriptOf(opening());
  const tampered = script.replace('damping_constant = c = 20.0 ', 'damping_constant = c = 20.001 ');
  assert.notEqual(tampered, script);
  const { status, stdout, stderr } = python(tampered);
  assert.equal(status, 1, stdout + stderr);
  assert.match(stdout, /DISAGREE/);
});

test('a script tells where it comes from and names every parameter, with symbol and unit', () => {
  const script = scriptOf(opening());
  assert.ok(script.includes(link));
  assert.match(script, /^relaxation_length = σ = 0\.3 +# m$/m);
  assert.match(script, /^aligning_moment_derivative = c_Mα = 2\.0 +# m\/rad$/m);
  assert.equal(script.match(/^\w+ = [\wα-ω]+ = .+# .+$/gmu)?.length, 14);
});

test('a script tells of friction where there is some, and only there', () => {
  const with60 = scriptOf(wholeRun('torsional', { 'friction.moment': 60 }, 2));
  assert.match(with60, /^friction_moment = M_f = 60\.0 +# N m$/m);
  assert.doesNotMatch(scriptOf(opening()), /friction/);
});

test('a model without equations in Python is refused', () => {
  assert.equal(pythonModel('perpetuum-mobile'), null);
  assert.throws(() => pythonOf({ ...opening(), model: 'perpetuum-mobile' }, tableOf('torsional'), { time: [] }, { file: '', link }), /perpetuum-mobile/);
});
