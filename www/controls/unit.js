/**
 * The units in which people think: degrees, kilonewtons, and for the speed whichever of three they choose. Behind the page
 * everything is SI.
 *
 * @typedef {typeof velocityUnits[number]} VelocityUnit
 * @typedef {{ name: string, size: number, isRound: boolean }} Unit as shown; `size`: how much of the SI unit one is;
 *   `isRound`: whether round numbers of the SI unit are round numbers of it, too
 */

export const velocityUnits = /** @type {const} */ (['m/s', 'kn', 'km/h']);

/** A knot is a nautical mile of 1852 m in an hour, by definition. @type {Readonly<Record<VelocityUnit, Unit>>} */
const velocities = {
  'm/s': { name: 'm/s', size: 1, isRound: true },
  kn: { name: 'kn', size: 1852 / 3600, isRound: false },
  'km/h': { name: 'km/h', size: 1 / 3.6, isRound: false },
};

/** @type {Readonly<Record<string, Unit>>} */
const others = {
  rad: { name: '°', size: Math.PI / 180, isRound: false },
  N: { name: 'kN', size: 1000, isRound: true },
  1: { name: '', size: 1, isRound: true },
};

/**
 * The unit in which a quantity is shown.
 * @param {string} unit of the engine's table
 * @param {VelocityUnit} velocityUnit
 * @returns {Unit}
 */
export function shownUnit(unit, velocityUnit) {
  return unit === 'm/s' ? velocities[velocityUnit] : others[unit] ?? { name: unit, size: 1, isRound: true };
}

/** What may be typed behind a number, by the unit of the engine's table: how much of that one is. Others know their own alone. @type {Readonly<Record<string, Readonly<Record<string, number>>>>} */
const typed = {
  'm/s': { 'm/s': 1, kn: velocities.kn.size, kt: velocities.kn.size, 'km/h': velocities['km/h'].size },
  rad: { rad: 1, '°': others.rad.size, deg: others.rad.size, derece: others.rad.size },
  N: { N: 1, kN: 1000 },
  m: { m: 1, cm: 0.01, mm: 0.001 },
};

/**
 * A number that was typed with its unit behind it: the number as text, and how much of the table's unit one of it is; null
 * where no unit that is known stands there.
 * @param {string} text
 * @param {string} unit of the engine's table
 */
export function typedUnit(text, unit) {
  const known = typed[unit] ?? (unit === '1' ? {} : { [unit]: 1 });
  const whole = text.trim();
  const name = Object.keys(known).sort((one, other) => other.length - one.length).find((one) => whole.toLowerCase().endsWith(one.toLowerCase()));
  return name === undefined ? null : { number: whole.slice(0, -name.length), size: known[name] };
}

/** The unit after this one, round and round. @param {VelocityUnit} unit */
export function nextVelocityUnit(unit) {
  return velocityUnits[(velocityUnits.indexOf(unit) + 1) % velocityUnits.length];
}

/** @param {unknown} name @returns {name is VelocityUnit} */
export function isVelocityUnit(name) {
  return velocityUnits.some((unit) => unit === name);
}
