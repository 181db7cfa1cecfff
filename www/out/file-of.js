import { csvOf } from './csv.js';
import { fileName } from './file-name.js';
import { plateOf } from './plate.js';
import { pngOf } from './png.js';
import { pythonOf } from './python.js';
import { runJson } from './run-json.js';
import { runOf } from './run-of.js';
import { svgOf } from './svg.js';

/**
 * Makes the file that was asked for.
 *
 * @typedef {import('../engine/engine.js').Engine} Engine
 * @typedef {import('../engine/engine.js').Model} Model
 * @typedef {import('./run-of.js').Experiment} Experiment
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('./plate.js').Picture} Picture
 * @typedef {import('./plate.js').Caption} Caption
 * @typedef {'csv' | 'json' | 'python' | 'png' | 'svg'} Format
 * @typedef {{
 *   engine: Pick<Engine, 'simulate'>, experiment: Experiment, table: Model, duration: number, link: string,
 *   picture?: Picture, caption?: Caption, theme?: Theme,
 * }} Material `duration` of the run, in s; picture, caption and theme for a picture
 *
 * @param {Format} format
 * @param {string} view what is seen in the picture, for the file's name
 * @param {Material} material
 * @returns {Promise<{ blob: Blob, name: string }>}
 */
export async function fileOf(format, view, material) {
  const { experiment, table } = material;
  const isPicture = format === 'png' || format === 'svg';
  const name = fileName(table, experiment.parameters, isPicture ? view : '', format === 'python' ? 'py' : format);
  return { blob: await (isPicture ? pictureOf(format, material) : textOf(format, name, material)), name };
}

/** @param {'csv' | 'json' | 'python'} format @param {string} name @param {Material} material */
function textOf(format, name, { engine, experiment, table, duration, link }) {
  const run = runOf(experiment, table, duration);
  if (format === 'json') return new Blob([runJson(run)], { type: 'application/json' });
  if (format === 'csv') return new Blob([csvOf(engine.simulate(run), table)], { type: 'text/csv' });
  const ours = engine.simulate({ ...run, samples: 21 });
  return new Blob([pythonOf(run, table, ours, { file: name, link })], { type: 'text/x-python' });
}

/** @param {'png' | 'svg'} format @param {Material} material */
async function pictureOf(format, { picture, caption, theme }) {
  const ruler = document.createElement('canvas').getContext('2d');
  if (!picture || !caption || !theme || !ruler) throw new Error(`a picture as ${format} needs the view, its caption, its theme and a canvas`);
  const plate = plateOf(picture, caption, theme, ruler);
  return format === 'png' ? pngOf(plate) : new Blob([svgOf(plate, `${caption.title}. ${caption.values}`, ruler)], { type: 'image/svg+xml' });
}
