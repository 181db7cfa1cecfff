import { atlas } from './atlas.js';
import { controls } from './controls.js';
import { cycles } from './cycles.js';
import { damper } from './damper.js';
import { fittings } from './fittings.js';
import { landing } from './landing.js';
import { lens } from './lens.js';
import { out } from './out.js';
import { page } from './page.js';
import { plots } from './plots.js';
import { present } from './present.js';
import { presets } from './presets.js';
import { stability } from './stability.js';
import { stage } from './stage.js';
import { story } from './story.js';

/** Every string of the page in Turkish. @type {typeof import('../en/index.js').en} */
export const tr = {
  ...atlas, ...controls, ...cycles, ...damper, ...fittings, ...landing, ...lens, ...out, ...page, ...plots, ...present, ...presets, ...stability, ...stage, ...story,
};
