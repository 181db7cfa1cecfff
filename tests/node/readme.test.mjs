import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { fileURLToPath } from 'node:url';

test("README's example runs from the top folder and prints what its comments say", () => {
  const root = new URL('../../', import.meta.url);
  const example = readFileSync(new URL('README.md', root), 'utf8').match(/^```js\n([\s\S]*?)^```/m)?.[1];
  assert.ok(example);
  const { status, stdout, stderr } = spawnSync(process.execPath, ['--input-type=module', '--eval', example], {
    cwd: fileURLToPath(root),
    encoding: 'utf8',
  });
  assert.equal(status, 0, stderr);
  const [verdict, angle, frequency] = stdout.split('\n')[1].split(' ');
  assert.equal(verdict, 'shimmies');
  assert.ok(Math.abs(Number(angle) - 0.26508) < 5e-6 && Math.abs(Number(frequency) - 51.87) < 5e-3, stdout);
});
