// A canvas context that draws nothing and remembers everything: each call with its arguments, the style in force and
// the transform, so that a test can ask where a point came to lie.

/**
 * @typedef {{
 *   name: string, args: any[], style: Record<string, any>, at: (x: number, y: number) => [number, number],
 * }} Call `at`: where a point of the call's own coordinates lies on the canvas
 */

/** @typedef {[number, number, number, number, number, number]} Matrix */

/** @param {Matrix} m @param {Matrix} n @returns {Matrix} */
const times = ([a, b, c, d, e, f], [g, h, i, j, k, l]) =>
  [a * g + c * h, b * g + d * h, a * i + c * j, b * i + d * j, a * k + c * l + e, b * k + d * l + f];

/** @returns {{ context: CanvasRenderingContext2D, calls: Call[], named: (...names: string[]) => Call[] }} */
export function recordingContext() {
  /** @type {Call[]} */
  const calls = [];
  /** @type {Record<string, any>} */
  let style = { globalAlpha: 1, lineWidth: 1, fillStyle: '#000000', strokeStyle: '#000000', font: '10px sans-serif', dash: [] };
  /** @type {Matrix} */
  let matrix = [1, 0, 0, 1, 0, 0];
  /** @type {[Record<string, any>, Matrix][]} */
  const saved = [];

  /** @type {Record<string, (...args: any[]) => unknown>} */
  const special = {
    save: () => saved.push([{ ...style }, matrix]),
    restore: () => { [style, matrix] = saved.pop() ?? [style, matrix]; },
    translate: (x, y) => { matrix = times(matrix, [1, 0, 0, 1, x, y]); },
    rotate: (angle) => { matrix = times(matrix, [Math.cos(angle), Math.sin(angle), -Math.sin(angle), Math.cos(angle), 0, 0]); },
    scale: (x, y) => { matrix = times(matrix, [x, 0, 0, y, 0, 0]); },
    transform: (...m) => { matrix = times(matrix, /** @type {Matrix} */ (m)); },
    setTransform: (...m) => { matrix = /** @type {Matrix} */ (m.length === 6 ? m : [1, 0, 0, 1, 0, 0]); },
    setLineDash: (dash) => { style.dash = [...dash]; },
    getLineDash: () => [...style.dash],
    // Half of the type's size a letter: near enough for where labels go.
    measureText: (text) => ({ width: text.length * 0.5 * parseFloat(/([\d.]+)px/.exec(style.font)?.[1] ?? '10') }),
    createLinearGradient: () => ({ addColorStop() {} }),
    createRadialGradient: () => ({ addColorStop() {} }),
  };

  const context = new Proxy({}, {
    get: (_, name) => {
      if (typeof name === 'symbol') return undefined;
      if (name in style) return style[name];
      return (/** @type {any[]} */ ...args) => {
        const [a, b, c, d, e, f] = matrix;
        calls.push({ name, args, style: { ...style }, at: (x, y) => [a * x + c * y + e, b * x + d * y + f] });
        return special[name]?.(...args);
      };
    },
    set: (_, name, value) => {
      style[String(name)] = value;
      return true;
    },
  });
  return {
    context: /** @type {CanvasRenderingContext2D} */ (context),
    calls,
    named: (...names) => calls.filter(({ name }) => names.includes(name)),
  };
}

/** Every number that was drawn with. @param {Call[]} calls */
export const numbersOf = (calls) => calls.flatMap(({ args }) => args.flat(2).filter((value) => typeof value === 'number'));

/** The words of text calls. @param {Call[]} calls @returns {string[]} */
export const written = (calls) => calls.map(({ args }) => args[0]);
