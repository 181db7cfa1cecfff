/**
 * What the heading of a column says: which quantity, and in which unit.
 *
 *     displacement (mm) · Disp. [mm] · disp_mm · displacement/mm · "Yer değiştirme, mm"
 *
 * @typedef {'time' | 'displacement' | 'velocity' | 'force' | 'current'} Kind
 * @typedef {{ kind: Kind | null, unit: string, stranger: string }} Heading `kind`: null where it names none of them;
 *   `unit`: '' where none is named; `stranger`: a unit that is not known
 */

/** The columns of a record; the last two need not be there. @type {readonly Kind[]} */
export const kinds = ['time', 'displacement', 'force', 'velocity', 'current'];
export const needed = kinds.slice(0, 3);

/** Units by quantity, the first is SI, with what one of them is in SI. A command in volts goes to the model as amperes. @type {Readonly<Record<Kind, Readonly<Record<string, number>>>>} */
export const units = {
  time: { s: 1, ms: 1e-3, 'µs': 1e-6, min: 60 },
  displacement: { m: 1, mm: 1e-3, cm: 1e-2, 'µm': 1e-6, in: 0.0254 },
  velocity: { 'm/s': 1, 'mm/s': 1e-3, 'cm/s': 1e-2, 'in/s': 0.0254 },
  force: { N: 1, kN: 1e3, lbf: 4.4482216152605, kgf: 9.80665 },
  current: { A: 1, mA: 1e-3, V: 1 },
};

/** How units are written besides. @type {Readonly<Record<string, string>>} */
const spellings = {
  sec: 's', secs: 's', second: 's', seconds: 's', sn: 's', saniye: 's', msec: 'ms', us: 'µs', 'μs': 'µs', dk: 'min',
  meter: 'm', meters: 'm', metre: 'm', millimeter: 'mm', um: 'µm', 'μm': 'µm', inch: 'in', inches: 'in', '"': 'in', mps: 'm/s', 'm·s⁻¹': 'm/s', 'inch/s': 'in/s',
  newton: 'N', newtons: 'N', lb: 'lbf', lbs: 'lbf', pound: 'lbf', pounds: 'lbf', kp: 'kgf', amp: 'A', amps: 'A', ampere: 'A', amperes: 'A', amper: 'A', volt: 'V', volts: 'V',
};

/** What a quantity is called, in plain letters. @type {Readonly<Record<Kind, readonly string[]>>} */
const names = {
  time: ['time', 't', 'timestamp', 'elapsed', 'zaman', 'sure', 'zeit', 'temps'],
  displacement: ['displacement', 'disp', 'displ', 'x', 'position', 'pos', 'stroke', 'yerdegistirme', 'deplasman', 'konum', 'strok', 'weg', 'hub'],
  velocity: ['velocity', 'vel', 'speed', 'v', 'xdot', 'dx/dt', 'hiz', 'geschwindigkeit'],
  force: ['force', 'f', 'load', 'kuvvet', 'yuk', 'kraft'],
  current: ['current', 'i', 'command', 'cmd', 'amps', 'amp', 'ampere', 'voltage', 'akim', 'gerilim', 'komut', 'strom'],
};
const whose = /^(piston|damper|damping|measured|coil|sonumleyici|bobin|olculen)/;

/** @param {string} text @returns {Heading} */
export function headingOf(text) {
  const clean = text.trim().replace(/\s+/g, ' ');
  for (const [name, unit] of readings(clean)) {
    const kind = kindOf(name);
    if (!kind) continue;
    const known = unit === '' ? '' : unitOf(kind, unit);
    return { kind, unit: known ?? '', stranger: known === null ? unit : '' };
  }
  return { kind: null, unit: '', stranger: '' };
}

/** A unit by any of its spellings; null for what is none of this quantity. @param {Kind} kind @param {string} text */
export function unitOf(kind, text) {
  const bare = text.trim();
  for (const one of [bare, spellings[bare], spellings[bare.toLowerCase()], bare.toLowerCase()]) if (one && Object.hasOwn(units[kind], one)) return one;
  // KN and MM are what an export in capitals makes of them.
  return Object.keys(units[kind]).find((one) => one.toLowerCase() === bare.toLowerCase()) ?? null;
}

/** Name and unit, in every way they may be parted; the likeliest first. @param {string} text @returns {[string, string][]} */
function readings(text) {
  const bracketed = text.match(/^(.*?)\s*[([{]([^)\]}]*)[)\]}]\s*$/);
  if (bracketed) return [[bracketed[1], bracketed[2]]];
  const parted = text.match(/^(.+?)\s*[,:]\s*(\S+)$/) ?? text.match(/^(.+)_([^_]+)$/) ?? text.match(/^([^/]+)\/(\S+)$/) ?? text.match(/^(.+) (\S+)$/);
  return [[text, ''], ...(parted ? [/** @type {[string, string]} */ ([parted[1], parted[2]])] : [])];
}

/** @param {string} name @returns {Kind | null} */
function kindOf(name) {
  const bare = plain(name);
  for (const word of [bare, bare.replace(whose, '')]) for (const kind of kinds) if (names[kind].includes(word)) return kind;
  return null;
}

/** Small letters without accents, spaces and dots. @param {string} text */
function plain(text) {
  return text.toLowerCase().normalize('NFD').replaceAll(/\p{M}/gu, '').replaceAll('ı', 'i').replaceAll(/[\s._-]/g, '').replaceAll('ẋ', 'xdot');
}
