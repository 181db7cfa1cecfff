import assert from 'node:assert/strict';
import { test } from 'node:test';
import { plateOf } from '../../../www/out/plate.js';
import { recordingContext } from '../plot-recorder.mjs';
import { theme } from '../theme.mjs';

const size = { width: 300, height: 200 };
const address = `https://example.org/#shimmy=1&${Array.from({ length: 14 }, (_, i) => `parameterNumber${i}=${i}`).join('&')}`;

/** @param {string} link @param {string} [note] */
function drawn(link, note) {
  const { context, calls, named } = recordingContext();
  /** @type {string[]} */
  const order = [];
  const plate = plateOf({
    size,
    paint: (ctx) => { order.push('view'); ctx.moveTo(0, 0); },
    over: (ctx) => { order.push('pen'); ctx.moveTo(1, 1); },
  }, { title: 'Nose gear · Phase', note, values: 'Speed\u00a080\u00a0m/s · Damping\u00a020', link }, theme, context);
  calls.length = 0;
  plate.paint(context, plate.size);
  return { plate, order, named };
}

test('title and values stand above the view, the address below, all of it', () => {
  const { plate, order, named } = drawn(address);
  const written = named('fillText').map(({ args: [text, x, y] }) => ({ text, x, y }));
  assert.deepEqual(written.slice(0, 2).map(({ text }) => text), ['Nose gear · Phase', 'Speed\u00a080\u00a0m/s · Damping\u00a020']);
  assert.equal(written.slice(2).map(({ text }) => text).join(''), address);
  assert.ok(written.length > 8, 'the address is broken into lines');
  // Half of the type's size a letter, as the recorder measures.
  for (const { text } of written.slice(2)) assert.ok(text.length * 0.5 * 0.85 * theme.size <= size.width, text);
  const [view, pen] = named('moveTo');
  const [left, top] = view.at(0, 0);
  assert.equal(left, 20);
  assert.ok(top > written[1].y && top + size.height < written[2].y, 'the view is not written over');
  assert.deepEqual(pen.at(0, 0), view.at(0, 0));
  assert.deepEqual(order, ['view', 'pen']);
  assert.ok(written.every(({ y }, i) => y > (written[i - 1]?.y ?? 0)) && plate.size.height > (written.at(-1)?.y ?? Infinity));
});

test('a short address leaves the plate lower', () => {
  assert.ok(drawn('https://example.org/').plate.size.height < drawn(address).plate.size.height - 50);
});

test('what is said of the view stands between title and values, and what is not takes no room', () => {
  const { plate, named } = drawn('https://example.org/', '68.3\u00a0% of the plane is stable');
  assert.deepEqual(named('fillText').map(({ args: [text] }) => text).slice(0, 3), ['Nose gear · Phase', '68.3\u00a0% of the plane is stable', 'Speed\u00a080\u00a0m/s · Damping\u00a020']);
  assert.ok(plate.size.height > drawn('https://example.org/', '').plate.size.height + theme.size);
  assert.equal(drawn('https://example.org/', '').plate.size.height, drawn('https://example.org/').plate.size.height);
});
