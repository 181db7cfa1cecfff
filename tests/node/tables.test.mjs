import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { shimmy, STATES } from './module.mjs';

/** An object literal of JavaScript, and not a Map or a class. @param {unknown} value */
const isPlain = (value) => Object.getPrototypeOf(value) === Object.prototype;

test('the version is that of the crate', () => {
  const manifest = readFileSync(new URL('../../Cargo.toml', import.meta.url), 'utf8');
  assert.equal(shimmy.version(), manifest.match(/^version = "(.+)"/m)?.[1]);
});

test('models are plain objects with plain objects inside', () => {
  for (const model of shimmy.models()) {
    assert.ok(isPlain(model));
    assert.deepEqual(Object.keys(model), ['name', 'title', 'parameters', 'friction', 'state']);
    assert.ok([...model.parameters, ...model.state].every(isPlain));
  }
});

test('the torsional gears have the parameters and the state that the contract names', () => {
  const models = new Map(shimmy.models().map((model) => [model.name, model]));
  const linear = [
    'velocity',
    'casterLength',
    'halfContactLength',
    'relaxationLength',
    'momentOfInertia',
    'torsionalStiffness',
    'dampingConstant',
    'verticalForce',
    'sideForceDerivative',
    'aligningMomentDerivative',
    'treadWidthMomentConstant',
  ];
  const bounds = ['sideForceLimitAngle', 'aligningMomentLimitAngle', 'freeplayAngle'];
  const namesOf = (/** @type {string} */ model) => models.get(model)?.parameters.map(({ name }) => name).sort();
  assert.deepEqual(namesOf('torsional'), [...linear, ...bounds].sort());
  assert.deepEqual(namesOf('torsional-linear'), [...linear].sort());
  for (const { state, friction } of models.values()) {
    assert.deepEqual(friction.map(({ name }) => name), ['friction.moment']);
    assert.deepEqual(state.map(({ name }) => name), STATES);
  }
});

test('every parameter can be shown: name, symbol, range with the default inside, words', () => {
  for (const model of shimmy.models()) {
    for (const parameter of [...model.parameters, ...model.friction]) {
      const { name, symbol, unit, min, max, scale, doc } = parameter;
      assert.ok(name && symbol && typeof unit === 'string' && doc.length > 10, name);
      assert.ok(min < max && min <= parameter.default && parameter.default <= max, name);
      assert.match(scale, /^(linear|log)$/);
      assert.ok(scale === 'linear' || min > 0, `${name}: a logarithmic range begins above 0`);
    }
    for (const { name, symbol, unit, scale, doc } of model.state) {
      assert.ok(name && symbol && typeof unit === 'string' && scale > 0 && doc.length > 10, name);
    }
  }
});

test('the defaults run: a slider at either end of its range is accepted', () => {
  for (const { name: model, parameters } of shimmy.models()) {
    for (const { name, min, max } of parameters) {
      for (const value of [min, max]) {
        shimmy.simulate({ model, parameters: { [name]: value }, duration: 0.01 });
      }
    }
  }
});

test('every method listed runs and names itself', () => {
  const methods = shimmy.methods();
  assert.ok(['auto', 'dormand-prince', 'dop853', 'rk4'].every((name) => methods.some((method) => method.name === name)));
  for (const method of methods) {
    assert.ok(isPlain(method) && method.title && method.doc.length > 10, method.name);
    const { stats } = shimmy.simulate({ model: 'torsional', method: method.name, duration: 0.05 });
    if (method.name === 'auto') assert.notEqual(stats.method, 'auto');
    else assert.equal(stats.method, method.name);
  }
});

test('the relations of the tire are offered: σ = 3a, κ = 0.15 a² c_Fα F_z', () => {
  for (const model of ['torsional', 'torsional-linear']) {
    const parameters = { halfContactLength: 0.2, sideForceDerivative: 10, verticalForce: 5000 };
    const linked = shimmy.linkedParameters({ model, parameters });
    assert.ok(isPlain(linked));
    assert.ok(Math.abs(linked.relaxationLength - 0.6) < 1e-15);
    assert.ok(Math.abs(linked.treadWidthMomentConstant - 300) < 1e-10);
  }
});

test('they are never applied in silence: half the contact length alone changes only itself', () => {
  const at = { model: 'torsional', initial: { torsionAngle: 0.01 }, times: [0.1], rtol: 1e-10 };
  const shorter = shimmy.simulate({ ...at, parameters: { halfContactLength: 0.05 } });
  const same = shimmy.simulate({
    ...at,
    parameters: { halfContactLength: 0.05, relaxationLength: 0.3, treadWidthMomentConstant: 270 },
  });
  assert.equal(shorter.torsionAngle[0], same.torsionAngle[0]);
});
