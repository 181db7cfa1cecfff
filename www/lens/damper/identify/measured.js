import { html, nothing } from 'lit';
import { parseNumber } from '../../../words/number.js';
import { damperNames, currentsOf } from '../settings.js';
import { kinds, units } from '../record/headings.js';
import { noticeInWords, problemInWords } from '../record/say.js';
import { largestFile } from '../record/read-file.js';

/**
 * What is to be fitted: files with what was made of them, or records made here.
 *
 * @typedef {import('../identify.js').DamperIdentify} Host
 * @typedef {import('./workbench.js').Source} Source
 * @typedef {import('../../../words/voice.js').Voice} Voice
 */

/** How the made records are moved: strokes that grow from a fifth, twice as fast at the end as at the start. */
const made = { cycles: 4, samples: 500 };

/** What is chosen of the records that are made. */
const choice = { model: 'modified-bouc-wen', noise: 5, seed: 1 };

/** @param {Host} host @param {Voice} voice */
export function measuredForm(host, voice) {
  const { bench } = host;
  return html`
    <section>
      <h2>${voice.say('identify.records')}</h2>
      <div class="identify-row">
        <label class="framed drop">${voice.say('identify.file')}
          <input type="file" class="only-heard" multiple accept=".csv,.txt,.tsv,.dat,text/csv,text/plain" @change=${(/** @type {Event} */ event) => {
            const input = /** @type {HTMLInputElement} */ (event.target);
            const files = [...(input.files ?? [])];
            // The same file may be chosen again.
            input.value = '';
            host.open(files);
          }} /></label>
        <p class="quiet">${voice.say('identify.file.does', { most: largestFile / 1e6 })}</p>
      </div>
      <div class="identify-row">
        <button type="button" class="framed" @click=${() => make(host, voice)}>${voice.say('identify.make')}</button>
        <select class="framed" aria-label=${voice.say('identify.made.model')} .value=${choice.model} @change=${(/** @type {Event} */ event) => { choice.model = /** @type {HTMLSelectElement} */ (event.target).value; }}>
          ${damperNames.map((name) => html`<option value=${name} ?selected=${name === choice.model}>${voice.say(`damper.model.${name}`)}</option>`)}
        </select>
        ${numberField(voice.say('identify.noise'), choice.noise, (value) => value >= 0 && value <= 100, (value) => { choice.noise = value; })} %
        ${numberField(voice.say('identify.seed'), choice.seed, (value) => Number.isInteger(value) && value >= 0, (value) => { choice.seed = value; })}
      </div>
      ${bench.reading ? html`<p role="status" class="reading">${voice.say('identify.reading', { file: bench.reading.name, share: Math.round(100 * bench.reading.fraction) })} <progress max="1" .value=${bench.reading.fraction}></progress></p>` : nothing}
      ${bench.sources.map((source) => sourcePart(host, source, voice))}
    </section>`;
}

/** @param {string} name @param {number} value @param {(value: number) => boolean} isTaken @param {(value: number) => void} put */
function numberField(name, value, isTaken, put) {
  return html`<label>${name} <input type="text" inputmode="decimal" class="number" .value=${String(value)} @change=${(/** @type {Event} */ event) => {
    const input = /** @type {HTMLInputElement} */ (event.target);
    const typed = parseNumber(input.value);
    if (Number.isFinite(typed) && isTaken(typed)) put(typed);
    else input.value = String(value);
  }} /></label>`;
}

/** @param {Host} host @param {Voice} voice */
function make(host, voice) {
  const { scene, bench, motion } = host;
  const table = host.tableOf(choice.model);
  if (!scene || !table) return;
  const parameters = Object.fromEntries(table.parameters.map(({ name, default: usual }) => [name, usual]));
  const excitation = { amplitude: motion.amplitude / 5, endAmplitude: motion.amplitude, frequency: motion.frequency / 2, endFrequency: 2 * motion.frequency };
  const records = currentsOf(host.settings.damperCurrents ?? '', table.command).map((command, i) => {
    const record = scene.dampers.record({ damper: { model: choice.model, command, parameters }, excitation, ...made, noise: choice.noise / 100, seed: choice.seed + i });
    return { ...record, from: 0, to: record.interval * (record.force.length - 1), measured: record.force.length };
  });
  bench.make(voice.say('identify.made', { model: voice.say(`damper.model.${/** @type {typeof damperNames[number]} */ (choice.model)}`), noise: voice.number(choice.noise, 0) }), records, { model: choice.model, parameters });
}

/** A file, or what was made here. @param {Host} host @param {Source} source @param {Voice} voice */
function sourcePart(host, source, voice) {
  const { bench } = host;
  const { name, table, records, notices, problem } = source;
  return html`
    <article class="source">
      <header><b>${name}</b> <button type="button" class="plain" aria-label=${voice.say('identify.remove', { file: name })} title=${voice.say('identify.remove', { file: name })} @click=${() => bench.remove(source)}>✕</button></header>
      ${problem ? html`<p class="refused" role="alert"><span aria-hidden="true">⚠ </span>${problemInWords(problem, voice)}</p>` : nothing}
      ${notices.map((notice) => html`<p class="quiet">${noticeInWords(notice, voice)}</p>`)}
      ${records.length > 0 ? html`<ul>${records.map(({ command, force, from, to, measured }) => html`
        <li>${voice.say('identify.record', { command: voice.number(command, 2), unit: host.fitted?.command.unit ?? 'A', samples: force.length, from: voice.number(from, 2), to: voice.number(to, 2) })}
          ${measured > force.length ? html`<span class="quiet">${voice.say('identify.record.of', { measured })}</span>` : nothing}</li>`)}</ul>` : nothing}
      ${table ? html`<div class="identify-row units">
        ${kinds.filter((kind) => table.columns[kind]).map((kind) => html`
          <label>${voice.say(`record.kind.${kind}`)} <select class="framed" .value=${source.units[kind] || table.units[kind] || Object.keys(units[kind])[0]} @change=${(/** @type {Event} */ event) => bench.change(source, { units: { ...source.units, [kind]: /** @type {HTMLSelectElement} */ (event.target).value } })}>
            ${Object.keys(units[kind]).map((unit) => html`<option value=${unit} ?selected=${unit === (source.units[kind] || table.units[kind] || Object.keys(units[kind])[0])}>${unit}</option>`)}</select></label>`)}
        ${table.columns.current ? nothing : numberField(`${voice.say('record.kind.current')}, A`, source.command, (value) => value >= 0, (value) => bench.change(source, { command: value }))}
      </div>` : nothing}
    </article>`;
}
