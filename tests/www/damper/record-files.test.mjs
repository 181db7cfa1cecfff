// Files of measured dampers: those that are read however they are written, and every way in which one can be wrong.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { readRecordFile } from '../../../www/lens/damper/record/read-file.js';
import { mostSamples, recordsOf } from '../../../www/lens/damper/record/records.js';
import { noticeInWords, problemInWords } from '../../../www/lens/damper/record/say.js';
import { voiceOf } from '../../../www/words/voice.js';

/** @typedef {import('../../../www/lens/damper/record/problem.js').Unreadable} Unreadable */

/** Rows of a damper: 0.01 m at 2 Hz, force in phase with the velocity. @param {number} count @param {(i: number, row: number[]) => (string | number)[]} [write] */
const rows = (count, write = (_, row) => row) => Array.from({ length: count }, (_, i) => {
  const t = i / 100;
  return write(i, [t, 0.01 * Math.sin(4 * Math.PI * t), 500 * Math.cos(4 * Math.PI * t)]);
});
/** @param {string} heading @param {(string | number)[][]} body @param {string} [separator] @param {string} [end] */
const csv = (heading, body, separator = ',', end = '\n') => [heading, ...body.map((row) => row.join(separator))].join(end) + end;
const usual = 'time (s),displacement (m),force (N)';
const good = csv(usual, rows(100));

/** @param {string | Uint8Array<ArrayBuffer>} content @param {Parameters<typeof recordsOf>[1]} [choice] */
const read = async (content, choice) => recordsOf(await readRecordFile(new Blob([content])), choice);

/** UTF-16 with its mark. @param {string} text */
const utf16 = (text) => Uint8Array.from([0xff, 0xfe, ...[...text].flatMap((letter) => [letter.charCodeAt(0) & 255, letter.charCodeAt(0) >> 8])]);

test('a plain file is one record in SI units', async () => {
  const { records: [record, ...more], notices } = await read(good, { command: 0.5 });
  assert.equal(more.length, 0);
  assert.equal(record.command, 0.5);
  assert.equal(record.displacement.length, 100);
  assert.ok(Math.abs(record.interval - 0.01) < 1e-12);
  assert.equal(record.velocity, null);
  assert.deepEqual(notices, []);
});

const inMillimeters = (/** @type {(n: number) => string | number} */ write) => rows(100, (_, [t, x, f]) => [t, 1000 * x, f / 1000].map(write));
const comma = (/** @type {number} */ n) => String(n).replace('.', ',');

/** The same record, written otherwise. @type {Record<string, string | Uint8Array<ArrayBuffer>>} */
const sameFiles = {
  'other units': csv('Time [s],Disp. [mm],Load [kN]', inMillimeters(Number)),
  'semicolons and decimal commas': csv('t (s);x (mm);F (kN)', inMillimeters(comma), ';'),
  'tabs': csv('time_s\tdisplacement_mm\tforce_kN', inMillimeters(Number), '\t'),
  'Turkish': csv('Zaman (sn);Yer değiştirme (mm);Kuvvet (kN)', inMillimeters(comma), ';'),
  'Windows: mark, CRLF, comments, an empty line, quotes': `\ufeff# a damper\r\n\r\n${csv('"time, s","displacement, m","force, N"', rows(100, (_, row) => row.map((value) => `"${value}"`)), ',', '\r\n')}`,
  'lines that end with CR alone': csv(usual, rows(100), ',', '\r'),
  'UTF-16': utf16(good),
  'a row of units': csv('time,displacement,force', [['s', 'mm', 'kN'], ...inMillimeters(Number)]),
  'slashes, and another order': csv('force/N,time/ms,displacement/m,note', rows(100, (_, [t, x, f]) => [f, 1000 * t, x, 'ok'])),
  'a separator at the end of each row': csv(usual, rows(100, (_, row) => [...row, ''])),
  'pounds and inches': csv('t (ms),x (in),F (lbf)', rows(100, (_, [t, x, f]) => [1000 * t, x / 0.0254, f / 4.4482216152605])),
};

for (const [name, content] of Object.entries(sameFiles))
  test(`however it is written: ${name}`, async () => {
    const [wanted, found] = [(await read(good)).records[0], (await read(content)).records[0]];
    for (const column of /** @type {const} */ (['displacement', 'force']))
      found[column].forEach((value, i) => assert.ok(Math.abs(value - wanted[column][i]) <= 1e-9 * 500, `${column} ${i}: ${value}, not ${wanted[column][i]}`));
    assert.ok(Math.abs(found.interval - wanted.interval) < 1e-9);
  });

const swapped = rows(100);
[swapped[50], swapped[51]] = [swapped[51], swapped[50]];
const put = (/** @type {number} */ at, /** @type {number} */ column, /** @type {string | number} */ value) => rows(100, (i, row) => (i === at ? row.map((one, c) => (c === column ? value : one)) : row));

/** What is wrong, the code that says so, and what it says besides. @type {[string, string | Uint8Array<ArrayBuffer>, string, Record<string, string | number>?, Parameters<typeof recordsOf>[1]?][]} */
const wrong = [
  ['empty', '', 'empty'],
  ['blank lines alone', '\n\r\n  \n', 'empty'],
  ['a comment alone', '# time, displacement, force\n', 'empty'],
  ['a picture', Uint8Array.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0, 0, 0, 13]), 'binary'],
  ['a workbook', Uint8Array.from([0x50, 0x4b, 3, 4, 20, 0, 6, 0]), 'spreadsheet'],
  ['a workbook of old', Uint8Array.from([0xd0, 0xcf, 0x11, 0xe0, 0xa1, 0xb1]), 'spreadsheet'],
  ['UTF-16 without its mark', utf16(good).slice(2), 'binary'],
  ['no heading', csv('0,0,500', rows(99)), 'noHeader', { line: 1 }],
  ['no heading, with decimal commas', csv('0,0;0,0;500,0', rows(99), ';'), 'noHeader', { line: 1 }],
  ['a heading alone', `${usual}\n`, 'noRows'],
  ['spaces between cells', csv('time displacement force', rows(100), ' '), 'separator', { line: 1 }],
  ['no time', csv('displacement (m),force (N)', rows(100, (_, [, x, f]) => [x, f])), 'missing', { kind: 'time', line: 1 }],
  ['no force', csv('time (s),displacement (m)', rows(100, (_, [t, x]) => [t, x])), 'missing', { kind: 'force' }],
  ['no displacement', csv('# bench 3\ntime,velocity,force', rows(100)), 'missing', { kind: 'displacement', line: 2 }],
  ['headings that name nothing', csv('Channel 1,Channel 2,Channel 3', rows(100)), 'missing', { kind: 'time', found: 'Channel 1, Channel 2, Channel 3' }],
  ['two forces', csv('time,displacement,force,Load (kN)', rows(100, (_, row) => [...row, 0])), 'twice', { kind: 'force', first: 'force', second: 'Load (kN)' }],
  ['a unit that is none', csv('time (s),displacement (furlong),force (N)', rows(100)), 'unit', { unit: 'furlong', line: 1 }],
  ['a unit of something else', csv('time (s),displacement (N),force (N)', rows(100)), 'unit', { unit: 'N', allowed: 'm, mm, cm, µm, in' }],
  ['NaN', csv(usual, put(40, 2, 'NaN')), 'notMeasured', { line: 42, column: 3, kind: 'force', cell: 'NaN' }],
  ['infinite', csv(usual, put(7, 1, '-inf')), 'notMeasured', { line: 9, column: 2, cell: '-inf' }],
  ['a number beyond numbers', csv(usual, put(7, 1, '1e999')), 'notANumber', { line: 9, cell: '1e999' }],
  ['an error of a spreadsheet', csv(usual, put(3, 2, '#DIV/0!')), 'notMeasured', { line: 5 }],
  ['a word among numbers', csv(usual, put(20, 1, 'over')), 'notANumber', { line: 22, column: 2, cell: 'over' }],
  ['a number with its unit', csv(usual, put(20, 2, '12 N')), 'notANumber', { line: 22, cell: '12 N' }],
  ['a hexadecimal number', csv(usual, put(20, 2, '0x1F')), 'notANumber', { line: 22 }],
  ['a date for time', csv(usual, put(0, 0, '2024-05-01 12:00:00')), 'notANumber', { line: 2, column: 1, cell: '2024-05-01 12:00:00' }],
  ['two decimal signs', csv(usual.replaceAll(',', ';'), rows(100, (i, row) => row.map((n) => (i === 9 ? '1.234,5' : comma(n)))), ';'), 'notANumber', { line: 11, cell: '1.234,5' }],
  ['an empty cell', csv(usual, put(60, 2, '')), 'emptyCell', { line: 62, column: 3 }],
  ['a cell too few', csv(usual, rows(100, (i, row) => (i === 30 ? row.slice(0, 2) : row))), 'cells', { line: 32, found: 2, wanted: 3 }],
  ['a cell too many', csv(usual, rows(100, (i, row) => (i === 30 ? [...row, 7] : row))), 'cells', { line: 32, found: 4, wanted: 3 }],
  ['commas that part and count', csv(usual, rows(100, (_, row) => row.map((n) => n.toFixed(4).replace('.', ',')))), 'commas', { line: 2 }],
  ['a quote that does not end', csv(usual, put(10, 1, '"0.01')), 'quote', { line: 12 }],
  ['letters after a quote', csv(usual, put(10, 1, '"0.01"m')), 'quote', { line: 12 }],
  ['a heading in between', csv(usual, [...rows(50), usual.split(','), ...rows(50)]), 'notANumber', { line: 52, cell: 'time (s)' }],
  ['time that stands', csv(usual, put(30, 0, 0.29)), 'timeStands', { line: 32, time: 0.29 }],
  ['time that goes back', csv(usual, swapped), 'timeBack', { line: 53, before: 0.51, time: 0.5 }],
  ['time that runs backward', csv(usual, rows(100, (i, [, x, f]) => [1 - i / 100, x, f])), 'timeBack', { line: 3 }],
  ['one row', csv(usual, rows(1)), 'tooFew', { rows: 1, least: 20 }],
  ['a few rows', csv(usual, rows(12)), 'tooFew', { rows: 12 }],
  ['time by leaps', csv(usual, rows(100, (i, [, x, f]) => [Math.floor(i / 5) * 10 + (i % 5) * 0.01, x, f])), 'uneven', { pieces: 20 }],
  ['a force that does not move', csv(usual, rows(100, (_, [t, x]) => [t, x, 3])), 'constant', { kind: 'force' }],
  ['a piston that does not move', csv(usual, rows(100, (_, [t, , f]) => [t, 0.02, f])), 'constant', { kind: 'displacement' }],
  ['a current that wanders', csv(`${usual},current (A)`, rows(800, (i, row) => [...row, i / 400])), 'wanders', { most: 12 }],
  ['one endless line', `${usual}\n${'1,'.repeat(30_000)}`, 'longLine', { line: 2 }],
  ['a letter', 'Dear colleague,\n\nthe damper works, as far as we can see.\n', 'missing', { kind: 'time' }],
];

test('there are more than thirty ways to be wrong', () => assert.ok(wrong.length >= 30, `${wrong.length}`));

for (const [name, content, code, values = {}, choice] of wrong)
  test(`wrong, and told why: ${name}`, async () => {
    const problem = await read(content, choice).then(() => assert.fail('it was read'), (error) => /** @type {Unreadable} */ (error));
    assert.equal(problem.code, code, problem.message);
    for (const [key, value] of Object.entries(values)) assert.equal(problem.values[key], value, `${key} in ${problem.message}`);
    for (const language of /** @type {const} */ (['en', 'tr'])) {
      const said = problemInWords(problem, voiceOf(language));
      assert.doesNotMatch(said, /undefined|[{}]/, said);
    }
  });

test('a file that is too large is refused before it is read', async () => {
  const file = /** @type {Blob} */ (/** @type {unknown} */ ({ size: 2e8, slice: () => assert.fail('it was read') }));
  await assert.rejects(readRecordFile(file), { code: 'tooLarge', values: { megabytes: 200, most: 100 } });
});

test('a letter of old Windows in a heading is read', async () => {
  // "dépl" is not UTF-8 here; the note's column is ignored and named.
  const bytes = Uint8Array.from([...good.replaceAll('\n', ',1\n').replace(',1\n', ',d\u00e9pl\n')].map((letter) => letter.charCodeAt(0)));
  const { notices } = await read(bytes);
  assert.deepEqual(notices, [{ code: 'ignored', values: { columns: 'dépl' } }]);
});

test('records part where the current is set anew, and where time begins again', async () => {
  const currents = [0, 0.5, 1];
  const measured = rows(300, (i, row) => [...row, currents[Math.floor(i / 100)] + 0.004 * Math.sin(i)]);
  const { records } = await read(csv(`${usual},current (A)`, measured));
  assert.deepEqual(records.map(({ command }) => Math.round(command * 100) / 100), currents);
  assert.deepEqual(records.map(({ force }) => force.length), [100, 100, 100]);
  assert.equal(records[1].force[0], 500 * Math.cos(4 * Math.PI));
  const again = await read(csv(`${usual},current (mA)`, [0, 500].flatMap((current) => rows(60, (_, row) => [...row, current]))));
  assert.deepEqual(again.records.map(({ command, displacement, from }) => [command, displacement.length, from]), [[0, 60, 0], [0.5, 60, 0]]);
  const unnamed = await read(good + rows(50).map((row) => row.join(',')).join('\n'), { command: 0.3 });
  assert.deepEqual(unnamed.records.map(({ command, displacement }) => [command, displacement.length]), [[0.3, 100], [0.3, 50]]);
});

test('uneven steps are resampled, and that is said', async () => {
  const shaken = rows(200, (i) => {
    const t = (i + 0.3 * Math.sin(7 * i)) / 100;
    return [t, 0.01 * Math.sin(4 * Math.PI * t), 500 * Math.cos(4 * Math.PI * t)];
  });
  const { records: [record], notices } = await read(csv(usual, shaken));
  assert.equal(notices[0].code, 'resampled');
  const begin = Number(shaken[0][0]);
  // Straight lines between samples 0.013 s apart miss a 2 Hz sine by less than (ωh)²/8 = 0.4 %.
  record.force.forEach((force, i) => assert.ok(Math.abs(force - 500 * Math.cos(4 * Math.PI * (begin + i * record.interval))) < 2.5, `${i}`));
});

test('of a long record there are enough samples of each cycle, and no more than a fit has use for', async () => {
  const dense = Array.from({ length: 40_000 }, (_, i) => [i / 10_000, 0.01 * Math.sin((4 * Math.PI * i) / 10_000), 500 * Math.cos((4 * Math.PI * i) / 10_000)]);
  const { records: [record] } = await read(csv(usual, dense));
  assert.ok(record.displacement.length <= mostSamples && record.displacement.length > 100);
  assert.equal(record.measured, 40_000);
  assert.ok(0.5 / record.interval >= 100, `${0.5 / record.interval} samples a cycle`);
  assert.ok(Math.abs(record.to - 3.9999) < 1e-9 && Math.abs(record.to - record.from - (record.displacement.length - 1) * record.interval) < 1e-9);
  record.displacement.forEach((x, i) => assert.ok(Math.abs(x - 0.01 * Math.sin(4 * Math.PI * (record.from + i * record.interval))) < 1e-9));
});

test('what is likelier a slip of the unit is asked back', async () => {
  const { notices } = await read(csv('time,displacement,force', inMillimeters(Number)));
  assert.deepEqual(notices.map(({ code }) => code), ['noUnit', 'noUnit', 'noUnit', 'far']);
  assert.match(noticeInWords(notices[3], voiceOf('tr')), /9,98/);
  const chosen = await read(csv('time,displacement,force', inMillimeters(Number)), { units: { time: 's', displacement: 'mm', force: 'kN' } });
  assert.deepEqual(chosen.notices, []);
  assert.ok(Math.abs(chosen.records[0].force[0] - 500) < 1e-9);
  assert.deepEqual((await read(csv('time (s),displacement (m),force (N),command (V)', rows(50, (_, row) => [...row, 1.5])))).notices, [{ code: 'volts', values: {} }]);
});

test('fifty megabytes are read in slices that leave the page its frames, and reading can be given up', async () => {
  const line = (/** @type {number} */ i) => `${(i / 1e4).toFixed(4)},${(0.01 * Math.sin(i / 800)).toFixed(9)},${(500 * Math.cos(i / 800)).toFixed(7)},0.500\n`;
  const lines = Array.from({ length: 1_350_000 }, (_, i) => line(i));
  const file = new Blob([`time (s),displacement (m),force (N),current (A)\n${lines.join('')}`]);
  assert.ok(file.size > 45e6 && file.size < 60e6, `${file.size}`);
  let [turns, done] = [0, 0];
  const table = await readRecordFile(file, { onProgress: (fraction) => { turns++; done = fraction; } });
  assert.equal(table.rows, 1_350_000);
  assert.ok(turns > 20 && done > 0.9, `${turns} turns, ${done}`);
  assert.equal(recordsOf(table).records[0].command, 0.5);
  const abort = new AbortController();
  await assert.rejects(readRecordFile(file, { onProgress: () => abort.abort(new Error('given up')), signal: abort.signal }), /given up/);
});
