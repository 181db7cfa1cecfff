/**
 * The values of a gear in groups, as the drawer lists them. A parameter that no group names stands in the last.
 *
 * @typedef {'motion' | 'gear' | 'tire' | 'freeplay' | 'others'} Group
 */

/** @type {readonly (readonly [Group, readonly string[]])[]} */
const groups = [
  ['motion', ['velocity', 'verticalForce']],
  ['gear', ['dampingConstant', 'friction.moment', 'torsionalStiffness', 'momentOfInertia', 'casterLength']],
  ['tire', [
    'halfContactLength', 'relaxationLength', 'sideForceDerivative', 'sideForceLimitAngle', 'aligningMomentDerivative',
    'aligningMomentLimitAngle', 'treadWidthMomentConstant',
  ]],
  ['freeplay', ['freeplayAngle']],
];

/**
 * The groups that have members, each with its own.
 * @template {{ name: string }} Named
 * @param {readonly Named[]} all
 * @returns {{ group: Group, members: Named[] }[]}
 */
export function grouped(all) {
  const named = groups.map(([group, names]) => ({ group, members: names.flatMap((name) => all.filter((one) => one.name === name)) }));
  const others = all.filter(({ name }) => !groups.some(([, names]) => names.includes(name)));
  return [...named, { group: /** @type {Group} */ ('others'), members: others }].filter(({ members }) => members.length > 0);
}
