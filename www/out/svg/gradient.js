import { svgColor } from './color.js';

/**
 * A gradient made on a drawing's own axes, kept until something is painted with it.
 *
 * @typedef {import('./matrix.js').Matrix} Matrix
 */
export class SvgGradient {
  #tag;
  #geometry;
  /** @type {string[]} */ #stops = [];

  /**
   * @param {'linearGradient' | 'radialGradient'} tag
   * @param {Record<string, number>} geometry its attributes
   */
  constructor(tag, geometry) {
    this.#tag = tag;
    this.#geometry = geometry;
  }

  /** @param {number} offset @param {string} color */
  addColorStop(offset, color) {
    const { color: opaque, opacity } = svgColor(color);
    this.#stops.push(`<stop offset="${offset}" stop-color="${opaque}"${opacity < 1 ? ` stop-opacity="${Number(opacity.toFixed(3))}"` : ''}/>`);
  }

  /**
   * The element, under an id.
   * @param {string} id
   * @param {Matrix} matrix in force where it is painted
   */
  element(id, matrix) {
    const geometry = Object.entries(this.#geometry).map(([name, value]) => ` ${name}="${Number(value.toFixed(3))}"`).join('');
    const turned = `matrix(${matrix.map((value) => Number(value.toPrecision(7))).join(' ')})`;
    return `<${this.#tag} id="${id}" gradientUnits="userSpaceOnUse"${geometry} gradientTransform="${turned}">${this.#stops.join('')}</${this.#tag}>`;
  }
}
