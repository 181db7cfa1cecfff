import { html, nothing } from 'lit';
import { tell } from '../../../command.js';
import { symbolOf } from '../../../controls/symbol.js';
import { download } from '../../../out/download.js';
import { tableCsv } from '../../../out/table-csv.js';
import { parameterName, writeValue } from './say.js';

/**
 * What came of it: the values with their spread over the seeds and whether the data fix them, the error of each record, and the
 * ways to take it along.
 *
 * @typedef {import('../identify.js').DamperIdentify} Host
 * @typedef {import('../../../words/voice.js').Voice} Voice
 */

/** The damper that was found, as a run takes it. @param {Host} host @returns {{ model: string, parameters: Record<string, number> } | null} */
export function damperFound({ bench }) {
  const best = bench.bestFit?.result;
  return best && best.error !== null ? { model: best.model, parameters: best.parameters } : null;
}

/** @param {Host} host @param {Voice} voice */
export function resultPart(host, voice) {
  const { bench, fitted } = host;
  const best = bench.bestFit;
  const found = best?.result;
  if (!found || found.error === null || !fitted || bench.isBusy) return nothing;
  const { known } = bench;
  const rows = fitted.parameters.map((parameter) => ({ parameter, value: found.parameters[parameter.name], spread: known?.parameters.find(({ name }) => name === parameter.name) ?? null }));
  const loose = rows.filter(({ spread }) => spread?.fixed === false).map(({ parameter }) => parameter.symbol.replace('_', ''));
  return html`
    <section class="identify-result">
      <h2>${voice.say('identify.result', { error: voice.number(100 * found.error, 2) })}</h2>
      <p class="quiet">${voice.say('identify.result.of', { model: voice.say(`damper.model.${/** @type {'bouc-wen'} */ (found.model)}`), seeds: bench.fits.map(({ seed }) => seed).join(', '), best: best.seed })}</p>
      <div class="identify-row">
        <button type="button" class="primary" @click=${() => tell(host, 'fitDamper', damperFound(host))}>${voice.say('identify.onGear')}</button>
        <button type="button" class="framed" @click=${() => take(host, 'json', voice)}>JSON</button>
        <button type="button" class="framed" @click=${() => take(host, 'csv', voice)}>CSV</button>
        <p role="status">${host.said}</p>
      </div>
      <p>${found.fits.map(({ command, error }) => voice.say('identify.record.error', { command: voice.number(command, 2), unit: fitted.command.unit, error: voice.number(100 * error, 2) })).join(' · ')}</p>
      ${loose.length > 0 ? html`<p class="is-unstable">${voice.say('identify.loose', { list: loose.join(', ') })}</p>` : nothing}
      <div class="figures-table" role="region" tabindex="0" aria-label=${voice.say('identify.result.table')}><table>
        <thead><tr><th scope="col">${voice.say('identify.parameter')}</th><th scope="col" class="figure">${voice.say('identify.value')}</th><th scope="col"></th><th scope="col" class="figure">${voice.say('identify.range')}</th><th scope="col">${voice.say('identify.fixed')}</th></tr></thead>
        <tbody>${rows.map(({ parameter, value, spread }) => html`
          <tr class=${spread?.fixed === false ? 'is-unstable' : ''}><th scope="row">${symbolOf(parameter.symbol)} ${parameterName(parameter, voice)}</th>
            <td class="figure"><b>${writeValue(value, voice)}</b></td><td>${parameter.unit === '1' ? '' : parameter.unit}</td>
            <td class="figure">${spread && bench.fits.length > 1 ? `${writeValue(spread.range[0], voice)} … ${writeValue(spread.range[1], voice)}` : '–'}</td>
            <td>${spread ? voice.say(spread.fixed ? 'identify.fixed.yes' : 'identify.fixed.no') : voice.say('identify.fixed.held')}</td></tr>`)}</tbody>
      </table></div>
    </section>`;
}

/** @param {Host} host @param {'json' | 'csv'} format @param {Voice} voice */
async function take(host, format, voice) {
  const { bench, fitted } = host;
  const damper = damperFound(host);
  const best = bench.bestFit?.result;
  if (!damper || !best || !fitted) return;
  const name = `shimmy-damper-${damper.model}.${format}`;
  const text = format === 'json' ? `${JSON.stringify({ damper, identification: { error: best.error, seed: best.seed, generation: best.generation, population: bench.population, records: best.fits.map(({ command, error }) => ({ command, error })) } }, null, 2)}\n`
    : tableCsv([{ name: 'parameter', unit: '' }, { name: 'value', unit: 'SI' }, { name: 'low', unit: 'SI' }, { name: 'high', unit: 'SI' }, { name: 'fixed', unit: '' }], fitted.parameters.map((parameter) => {
      const spread = bench.known?.parameters.find((one) => one.name === parameter.name);
      return [parameter.name, damper.parameters[parameter.name], spread?.range[0] ?? null, spread?.range[1] ?? null, spread ? String(spread.fixed) : 'held'];
    }));
  try {
    const outcome = await download(new Blob([text], { type: format === 'json' ? 'application/json' : 'text/csv' }), name);
    host.said = outcome === 'cancelled' ? '' : voice.say(`out.${outcome}`, { file: name });
  } catch (error) {
    host.said = voice.say('out.failed', { reason: error instanceof Error ? error.message : String(error) });
  }
}
