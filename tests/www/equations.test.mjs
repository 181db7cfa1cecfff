// What a parameter's name opens: its meaning in both languages, and the equations with its symbol lit.

import { test } from 'node:test';
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import init, * as engine from '../../www/pkg/shimmy.js';
import { equationsOf, legendOf, relationOf } from '../../www/controls/equations.js';
import { modelsOf } from '../../www/engine/models.js';
import { followed } from '../../www/run/links.js';
import { docs } from '../../www/words/tr/docs.js';
import { docOf } from '../../www/words/docs.js';
import { voiceOf } from '../../www/words/voice.js';

await init({ module_or_path: await readFile(new URL('../../www/pkg/shimmy_bg.wasm', import.meta.url)) });
const models = modelsOf(engine);

/** The markup of a template with all that is filled in. @param {unknown} template @returns {string} */
function markup(template) {
  if (Array.isArray(template)) return template.map(markup).join('');
  if (typeof template !== 'object' || template === null || !('strings' in template)) return String(template);
  const { strings, values } = /** @type {import('lit').TemplateResult} */ (template);
  return strings.map((text, i) => text + (i < values.length ? markup(values[i]) : '')).join('');
}

/** As it reads, without markup. @param {string} text */
const read = (text) => text.replaceAll(/<mspace[^>]*><\/mspace>/g, ' ').replaceAll(/<[^>]+>/g, '');
/** @param {string} model @param {string} symbol @param {'en' | 'tr'} [language] */
const equations = (model, symbol, language = 'en') => equationsOf(model, symbol, voiceOf(language)).map(markup);
/** @param {string} text */
const lit = (text) => [...text.matchAll(/<mrow class="lit">(.*?)<\/mrow>/g)].map(([, symbol]) => read(symbol));

test('every parameter of every model has a meaning in both languages', () => {
  const known = new Set();
  for (const { parameters } of models)
    for (const parameter of parameters) {
      assert.ok(parameter.doc.length > 20, parameter.name);
      assert.equal(docOf(parameter, 'en'), parameter.doc);
      const key = [`${parameter.of}/${parameter.name}`, parameter.name].find((one) => docs[one]);
      assert.ok(key && docs[key].length > 20, `no Turkish for ${parameter.name} ${parameter.of}`);
      known.add(key);
      assert.equal(docOf(parameter, 'tr'), docs[key]);
      // Whose it is, which formula it enters and what is valid is said in both.
      for (const what of [/\((Somieski|Atabay|Spencer et al\.|Yang et al\.) \d+/, /ẏ|ψ̇|F_z|I_z|s\(ψ\)|αz|Aẋ|k[₀₁]\(.*?\)/]) assert.equal(docs[key].match(what)?.[0], parameter.doc.match(what)?.[0], key);
      assert.equal(/value > 0/.test(parameter.doc), /0’dan büyük/.test(docs[key]), key);
      assert.equal(/value ≥ 0/.test(parameter.doc), /0 ve üstündeki/.test(docs[key]), key);
    }
  for (const key of Object.keys(docs)) assert.ok(known.has(key), `${key} is no parameter`);
});

test('every parameter of every model is in its equations, lit wherever it stands and nothing else', () => {
  for (const { name: model, parameters } of models)
    for (const { symbol } of parameters) {
      const text = equations(model, symbol).join('');
      const found = lit(text);
      assert.ok(found.length > 0, `${symbol} is not in the equations of ${model}`);
      assert.deepEqual(new Set(found), new Set([symbol.replace('_', '')]));
      assert.equal(lit(equations(model, 'none').join('')).length, 0);
    }
});

test('a symbol is lit as often as the model has it', () => {
  const count = (/** @type {string} */ model, /** @type {string} */ symbol) => lit(equations(model, symbol).join('')).length;
  assert.deepEqual(['v', 'e', 'a', 'σ', 'c', 'κ', 'k', 'I_z'].map((symbol) => count('torsional', symbol)), [3, 2, 1, 2, 1, 1, 1, 1]);
  assert.deepEqual(['F_z', 'c_Fα', 'c_Mα', 'δ', 'α_g', 'ψ_fp'].map((symbol) => count('torsional', symbol)), [3, 2, 1, 2, 3, 2]);
  assert.deepEqual(['v', 'e', 'a', 'σ', 'c_Fα', 'c_Mα', 'F_z'].map((symbol) => count('torsional-linear', symbol)), [3, 2, 1, 2, 1, 1, 1]);
});

test('the equations read as the papers write them', () => {
  const [moments, kinematics, slip, sideForce, aligning, spring, friction] = equations('torsional', 'none').map(read);
  assert.equal(moments, 'Iz ψ¨=−k s(ψ)−c ψ.−κv ψ.+Mz−e Fy−R');
  assert.equal(kinematics, 'y.=v ψ+(e−a) ψ.−vσ y');
  assert.equal(slip, 'α=arctan(y/σ)');
  assert.match(sideForce, /^Fy=\s*cFα Fz α\|α\|≤δ\s*cFα Fz δ sgn αbeyond$/);
  assert.match(aligning, /^Mz=\s*−cMα Fz αgπ sin π ααg\|α\|≤αg\s*0beyond$/);
  assert.match(spring, /^s\(ψ\)=\s*ψ−ψfp sgn ψ\|ψ\|>ψfp\s*0within$/);
  assert.equal(read(equations('torsional-linear', 'none')[0]), 'Iz ψ¨=−k ψ−c ψ.−κv ψ.−(cMα+e cFα) Fz yσ−R');
  assert.match(friction, /^R=\s*Mf sgn ψ\.ψ\.≠0\s*−Mf…Mfψ\.=0$/);
  assert.match(read(equations('torsional', 'none', 'tr').join('')), /ötesinde.*içinde/s);
  assert.deepEqual(equationsOf('lorenz', 'r', voiceOf('en')), []);
});

test('every variable that is no parameter is named', () => {
  for (const { name: model, parameters } of models) {
    const known = new Set([...parameters.map(({ symbol }) => symbol), ...legendOf(model).map(({ symbol }) => symbol), 'π'].map((symbol) => symbol.replace('_', '')));
    const used = equations(model, 'none').flatMap((text) => [...text.matchAll(/<msub>.*?<\/msub>|<mi>.*?<\/mi>/g)].map(([one]) => read(one)));
    for (const symbol of used) assert.ok(known.has(symbol), `${symbol} of ${model} is not named`);
  }
});

test('a chain says what holds among the engine’s defaults', () => {
  const relation = (/** @type {string} */ name, /** @type {'en' | 'tr'} */ language) => read(markup(relationOf(name, '', voiceOf(language))));
  const { halfContactLength: a, sideForceDerivative, verticalForce, relaxationLength, treadWidthMomentConstant } =
    Object.fromEntries(models[0].parameters.map((parameter) => [parameter.name, parameter.default]));
  assert.equal(relation('relaxationLength', 'en'), 'σ=3 a');
  assert.ok(Math.abs(relaxationLength - 3 * a) < 1e-12);
  assert.equal(relation('treadWidthMomentConstant', 'en'), 'κ=0.15 a2 cFα Fz');
  assert.equal(relation('treadWidthMomentConstant', 'tr'), 'κ=0,15 a2 cFα Fz');
  assert.ok(Math.abs(treadWidthMomentConstant - 0.15 * a ** 2 * sideForceDerivative * verticalForce) < 1e-9);
  for (const name of Object.keys(followed)) assert.match(markup(relationOf(name, '', voiceOf('en'))), /<math/);
});
