// A sample of what `npm run soak` throws at the module.

import { test } from 'node:test';

import { soak } from '../soak/soak.mjs';

test('hostile input is refused in words, and the module goes on', async () => {
  await soak(20_260_801, 0, 3000);
});
