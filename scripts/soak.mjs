// Throws hostile input at the module for minutes: `npm run soak -- --cases 100000 --seed 7`, `--only 1234` for one case.

import { parseArgs } from 'node:util';
import { ensureModule } from './build-wasm.mjs';
import { end, RunFailed } from './setup/run.mjs';
import { found } from './setup/say.mjs';
import { setUp } from './setup.mjs';
import { soak } from '../tests/soak/soak.mjs';

const { values } = parseArgs({
  options: { cases: { type: 'string', default: '100000' }, seed: { type: 'string' }, only: { type: 'string' } },
});

try {
  const seed = Number(values.seed ?? Math.floor(Math.random() * 2 ** 31));
  const from = Number(values.only ?? 0);
  const to = values.only === undefined ? Number(values.cases) : from + 1;
  ensureModule(setUp('module'));
  found('soak', `cases ${from} to ${to} of seed ${seed}`);
  const start = Date.now();
  const { bytesAtHalf, bytesAtEnd } = await soak(seed, from, to, (index) => {
    if (process.stdout.isTTY) process.stdout.write(`\r  case ${index}`);
  }).catch((error) => {
    throw new RunFailed(error.message);
  });
  const seconds = Math.round((Date.now() - start) / 1000);
  found('soak', `stood ${to - from} cases in ${seconds} s; memory ${bytesAtHalf} bytes half-way, ${bytesAtEnd} at the end`);
} catch (error) {
  end(error);
}
