import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { hasRelaxedSimd, probe } from '../../www/engine/relaxed-simd.js';

const degree = Math.PI / 180;
/** A gear whose rest and large cycle are both stable, one that rattles, and sweeps that both do. */
const works = [
  ['basins', {
    model: 'torsional', refine: false,
    parameters: { velocity: 102, dampingConstant: 29, casterLength: -0.2, aligningMomentDerivative: 4.8, sideForceLimitAngle: 0.047, aligningMomentLimitAngle: 0.29 },
    x: { state: 'torsionAngle', from: -0.3, to: 0.3, count: 16 }, y: { state: 'torsionRate', from: -100, to: 100, count: 12 },
  }],
  ['basins', {
    model: 'torsional', refine: false, parameters: { dampingConstant: 100 },
    x: { parameter: 'velocity', from: 20, to: 100, count: 12 }, y: { parameter: 'freeplayAngle', from: 0.1 * degree, to: 2 * degree, count: 4 },
  }],
  ['sweep', { model: 'torsional', parameters: { dampingConstant: 20 }, over: { parameter: 'velocity', from: 20, to: 80, count: 13 } }],
];

/** What a module gives in a Node.js that knows relaxed SIMD, by a flag or without. @param {string} name */
function given(name) {
  const script = `
    import { readFileSync } from 'node:fs';
    import { initSync, Job } from ${JSON.stringify(new URL('../../www/pkg/shimmy.js', import.meta.url).href)};
    initSync({ module: readFileSync(${JSON.stringify(fileURLToPath(new URL(`../../www/pkg/${name}`, import.meta.url)))}) });
    const results = ${JSON.stringify(works)}.map(([kind, spec]) => {
      const job = new Job(kind, spec);
      while (!job.advance(1000).done);
      const result = job.result();
      return (result.up ? [result.up, result.down] : [result]).map(({ kind, amplitude }) => ({ kind: [...kind], amplitude: [...amplitude] }));
    });
    console.log(JSON.stringify(results.flat()));`;
  const flags = hasRelaxedSimd() ? [] : ['--experimental-wasm-relaxed-simd'];
  return JSON.parse(execFileSync(process.execPath, [...flags, '--input-type=module', '--eval', script], { encoding: 'utf8' }));
}

test('the module with relaxed SIMD tells the same of every motion, up to rounding', () => {
  const [strict, relaxed] = ['shimmy_bg.wasm', 'shimmy_relaxed.wasm'].map(given);
  assert.equal(strict.length, 4);
  let [cells, others] = [0, 0];
  strict.forEach((/** @type {{ kind: number[], amplitude: number[] }} */ one, /** @type {number} */ place) => {
    const other = relaxed[place];
    assert.deepEqual(other.kind, one.kind);
    one.amplitude.forEach((amplitude, cell) => {
      const off = Math.abs(other.amplitude[cell] - amplitude);
      assert.ok(off <= 1e-9 * amplitude, `${place}, ${cell}: ${amplitude} and ${other.amplitude[cell]}`);
      cells++;
      if (off > 0) others++;
    });
  });
  // It is another module: where processors multiply and add with one rounding, some last digits differ.
  console.log(`# ${others} of ${cells} amplitudes differ in their last digits`);
});

test('what asks for relaxed SIMD is a module that has it, and nothing else', () => {
  const valid = (/** @type {Uint8Array} */ bytes, /** @type {string[]} */ flags) =>
    execFileSync(process.execPath, [...flags, '--print', `WebAssembly.validate(Uint8Array.of(${bytes}))`], { encoding: 'utf8' }).trim();
  const flags = hasRelaxedSimd() ? [] : ['--experimental-wasm-relaxed-simd'];
  assert.equal(valid(probe, flags), 'true');
  // It hangs on the one instruction.
  const broken = probe.map((byte) => (byte === 0x87 ? 0xff : byte));
  assert.equal(valid(broken, flags), 'false');
});
