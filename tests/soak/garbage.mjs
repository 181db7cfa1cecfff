// Values that nobody should pass, and that somebody will.

/** What the hostile getters and proxies throw: it may come through, and nothing else may in its place. */
export class Booby extends Error {}

const throws = () => {
  throw new Booby('a getter of the caller threw');
};

/** Every trap of a proxy throws. */
const trapped = () => new Proxy({}, new Proxy({}, { get: () => throws }));

const revoked = () => {
  const { proxy, revoke } = Proxy.revocable({}, {});
  revoke();
  return proxy;
};

const cyclic = () => {
  /** @type {Record<string, unknown>} */
  const record = { velocity: 50 };
  record.parameters = record;
  record.initial = [record];
  return record;
};

/** @param {number} levels @param {(inner: unknown) => unknown} wrap */
const nested = (levels, wrap) => {
  let value = /** @type {unknown} */ (1);
  for (let level = 0; level < levels; level++) value = wrap(value);
  return value;
};

const detached = () => {
  const array = new Float64Array(4);
  structuredClone(array.buffer, { transfer: [array.buffer] });
  return array;
};

const TYPED = [
  Int8Array, Uint8Array, Uint8ClampedArray, Int16Array, Uint16Array, Int32Array, Uint32Array, Float32Array, Float64Array,
  BigInt64Array, BigUint64Array,
];

/** Numbers at the ends of what a double can say, and just past what a field can take. */
export const NUMBERS = [
  NaN, Infinity, -Infinity, 0, -0, 5e-324, -5e-324, 2.2250738585072014e-308, 1e-300, 1e-30, Number.EPSILON, 0.5, -0.5, -1,
  1e16, -1e16, 2 ** 31, 2 ** 32, 2 ** 53, 2 ** 53 + 2, 2 ** 64, 1e100, 1e155, -1e155, 1e308, -1e308, Number.MAX_VALUE,
];

/** @type {Record<string, (random: import('./random.mjs').Random) => unknown>} */
const MAKERS = {
  undefined: () => undefined,
  null: () => null,
  boolean: (random) => random.chance(0.5),
  number: (random) => random.pick(NUMBERS),
  'number, any bits': (random) => {
    const bits = new DataView(new ArrayBuffer(8));
    bits.setUint32(0, random.word());
    bits.setUint32(4, random.word());
    return bits.getFloat64(0);
  },
  bigint: (random) => random.pick([0n, 10n, -1n, 2n ** 64n, 2n ** 2000n]),
  symbol: (random) => random.pick([Symbol('velocity'), Symbol.iterator, Symbol.toPrimitive]),
  string: (random) =>
    random.pick(['', ' ', '12', '1e3', '-0', 'NaN', 'Infinity', 'torsional', 'torsionl', 'velocity', '__proto__', 'constructor',
      'toString', '\0', '\ud800', '🛬'.repeat(50), 'x'.repeat(100_000), 'ψ', '[object Object]', 'null']),
  function: (random) => random.pick([() => 50, throws, class Gear {}, Math.max, async () => 1]),
  map: () => new Map(Object.entries({ velocity: 50 })),
  set: () => new Set([1, 2]),
  date: (random) => new Date(random.pick([NaN, 0, 8.64e15])),
  expression: () => /velocity/g,
  error: () => new Error('an error as a value'),
  promise: () => Promise.resolve(1),
  'weak map': () => new WeakMap(),
  boxed: (random) => random.pick([Object(50), Object('torsional'), Object(true), Object(10n), Object(Symbol('boxed'))]),
  'empty record': () => ({}),
  'record without a prototype': () => Object.assign(Object.create(null), { velocity: 50 }),
  'frozen record': () => Object.freeze({ velocity: 50 }),
  'record of another key': () => ({ velocty: 50, [Symbol('s')]: 1, 7: 8 }),
  'key __proto__': () => JSON.parse('{"__proto__": {"velocity": 3}}'),
  'getter that throws': () => Object.defineProperty({}, 'velocity', { enumerable: true, get: throws }),
  'valueOf that throws': () => ({ valueOf: throws, toString: throws }),
  'valueOf that lies': () => ({ valueOf: () => 50, toString: () => 'torsional', [Symbol.toPrimitive]: () => 50 }),
  'iterator that throws': () => ({ [Symbol.iterator]: throws, length: 3 }),
  'iterator without end': () => ({ *[Symbol.iterator]() { for (;;) yield 1; } }),
  'proxy that throws': trapped,
  'revoked proxy': revoked,
  'cyclic record': cyclic,
  'cyclic list': () => {
    /** @type {unknown[]} */
    const list = [1];
    list.push(list);
    return list;
  },
  'deep record': (random) => nested(random.pick([10, 200, 20_000]), (inner) => ({ parameters: inner })),
  'deep list': (random) => nested(random.pick([10, 200, 20_000]), (inner) => [inner]),
  'empty list': () => [],
  'list of numbers': (random) => Array.from({ length: random.below(5) }, () => random.pick(NUMBERS)),
  'list of anything': (random) => Array.from({ length: 3 }, () => plain(random)),
  'sparse list': () => {
    const list = [];
    list[5] = 1;
    return list;
  },
  'list with a length only': () => new Array(1000),
  'list-like': (random) => ({ length: random.pick([-1, 1.5, 2 ** 32, 2 ** 53, NaN, '3']), 0: 1 }),
  'typed array': (random) => new (random.pick(TYPED))(random.below(5)),
  'typed array of NaN': () => Float64Array.of(NaN, 1, -1),
  'detached typed array': detached,
  'shared typed array': () => new Float64Array(new SharedArrayBuffer(32)),
  buffer: (random) => random.pick([new ArrayBuffer(8), new SharedArrayBuffer(8), new DataView(new ArrayBuffer(8))]),
  generator: () => (function* () { yield 1; })(),
};

const NAMES = Object.keys(MAKERS);

/** The garbage that is no list of garbage itself. @param {import('./random.mjs').Random} random */
function plain(random) {
  const name = random.pick(NAMES.filter((each) => each !== 'list of anything'));
  return MAKERS[name](random);
}

/**
 * Something that does not belong there, and what to call it.
 * @param {import('./random.mjs').Random} random
 */
export function garbage(random) {
  const name = random.pick(NAMES);
  return { name, value: MAKERS[name](random) };
}

/** Lines that a word of garbage may be written in: never longer, whatever it holds. @param {unknown} value */
export function shown(value) {
  try {
    const text = typeof value === 'string' ? JSON.stringify(value) : String(value);
    return text.length > 60 ? `${text.slice(0, 60)}…` : text;
  } catch {
    return 'a value that cannot be written';
  }
}
