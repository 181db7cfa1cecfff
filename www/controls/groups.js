/**
 * The values of a gear in groups, as the drawer lists them. A parameter that no group names stands in the last.
 *
 * @typedef {'motion' | 'gear' | 'tire' | 'freeplay' | Fitted | 'others'} Group
 * @typedef {'damper' | 'control' | 'landing'} Fitted what is fitted to a gear: its parameters' names begin with it
 */

/** @type {readonly (readonly [Group, readonly string[]])[]} */
const groups = [
  ['motion', ['velocity', 'touchdownVelocity', 'deceleration', 'finalVelocity', 'liftFraction', 'verticalForce']],
  ['gear', ['dampingConstant', 'friction.moment', 'torsionalStiffness', 'momentOfInertia', 'casterLength']],
  ['tire', [
    'halfContactLength', 'relaxationLength', 'sideForceDerivative', 'sideForceLimitAngle', 'aligningMomentDerivative',
    'aligningMomentLimitAngle', 'treadWidthMomentConstant',
  ]],
  ['freeplay', ['freeplayAngle']],
];

/** @type {readonly Fitted[]} */
const fitted = ['damper', 'control', 'landing'];

/**
 * The groups that have members, each with its own.
 * @template {{ name: string }} Named
 * @param {readonly Named[]} all
 * @param {readonly Group[]} [open] groups that are there without members too
 * @returns {{ group: Group, members: Named[] }[]}
 */
export function grouped(all, open = []) {
  const named = groups.map(([group, names]) => ({ group, members: names.flatMap((name) => all.filter((one) => one.name === name)) }));
  const fittings = fitted.map((group) => ({ group, members: all.filter(({ name }) => name.startsWith(`${group}.`)) }));
  const known = new Set([...named, ...fittings].flatMap(({ members }) => members));
  const others = all.filter((one) => !known.has(one));
  return [...named, ...fittings, { group: /** @type {Group} */ ('others'), members: others }].filter(({ group, members }) => members.length > 0 || open.includes(group));
}
