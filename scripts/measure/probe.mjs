/**
 * What is put into the page before its first script: it times each frame's scripts and notes when the wheel moves, when
 * a drawing that an input has asked for is done, and how large the module's memory is.
 *
 * @typedef {{
 *   frames: { at: number, script: number }[],
 *   answers: { at: number, hand: number, input: number }[],
 *   movingAt: number | null,
 *   wasmBytes: () => number,
 *   clear: () => void,
 * }} Probe `at` and `movingAt` in ms since the navigation began, all else in ms. `answers`: drawings that an input has asked for,
 *   to the end of all that its frame draws: from when the hand had moved, and from the event that tells the page of it, which
 *   the browser keeps until it is about to draw.
 */

/**
 * Runs in the page.
 * @param {string} gear the selector of the gear's canvas
 */
export function probe(gear) {
  /** @type {WebAssembly.Memory[]} */
  const memories = [];
  /** @type {Probe} */
  const seen = {
    frames: [],
    answers: [],
    movingAt: null,
    wasmBytes: () => memories.reduce((sum, { buffer }) => sum + buffer.byteLength, 0),
    clear: () => {
      seen.frames.length = 0;
      seen.answers.length = 0;
    },
  };
  Object.assign(window, { shimmyProbe: seen });

  // Elements render in microtasks after the callback: hops behind them find the end.
  const hops = 40;
  let movedAt = 0;
  /** @typedef {{ movedAt: number, toldAt: number }} Input */
  /** The oldest input that no drawing has answered yet. @type {Input | null} */
  let asked = null;
  /** What the frame that is being drawn answers. @type {Input | null} */
  let answered = null;
  const draw = window.requestAnimationFrame.bind(window);
  window.requestAnimationFrame = (callback) => draw(async (now) => {
    const began = performance.now();
    callback(now);
    for (let hop = 0; hop < hops; hop++) await null;
    const ended = performance.now();
    const last = seen.frames.at(-1);
    if (last?.at === now) last.script += ended - began;
    else {
      seen.frames.push({ at: now, script: ended - began });
      answered = asked;
      asked = null;
      if (answered) seen.answers.push({ at: now, hand: 0, input: 0 });
    }
    if (answered) Object.assign(/** @type {object} */ (seen.answers.at(-1)), { hand: ended - answered.movedAt, input: ended - answered.toldAt });
    look(ended);
  });
  window.addEventListener('pointermove', ({ timeStamp }) => {
    movedAt = timeStamp;
  }, { capture: true });
  window.addEventListener('input', ({ timeStamp }) => {
    asked ??= { movedAt, toldAt: timeStamp };
  }, { capture: true });

  // The gear's drawing as one number a frame: all that its paths and turns are made of.
  let sum = 0;
  /** @type {number[]} */
  const drawings = [];
  /** @type {Element | null} */
  let canvas = null;
  const { rotate, lineTo } = CanvasRenderingContext2D.prototype;
  const restore = () => Object.assign(CanvasRenderingContext2D.prototype, { rotate, lineTo });
  CanvasRenderingContext2D.prototype.rotate = function (angle) {
    if (this.canvas === canvas) sum = (sum * 31 + angle) % 1e9;
    rotate.call(this, angle);
  };
  CanvasRenderingContext2D.prototype.lineTo = function (x, y) {
    if (this.canvas === canvas) sum = (sum * 31 + x + 7 * y) % 1e9;
    lineTo.call(this, x, y);
  };

  /** The wheel moves at the second of two frames that each differ from the one before. @param {number} now */
  function look(now) {
    if (seen.movingAt !== null) return;
    canvas ??= document.querySelector(gear);
    if (sum !== 0) drawings.push(sum);
    sum = 0;
    const [before, one, other] = drawings.slice(-3);
    if (other === undefined || before === one || one === other) return;
    seen.movingAt = now;
    // From here on the drawing runs as it does without us.
    restore();
  }

  const { instantiate } = WebAssembly;
  WebAssembly.instantiate = async (/** @type {any} */ source, /** @type {any} */ imports) => {
    const result = /** @type {any} */ (await instantiate(source, imports));
    const { memory } = (result.instance ?? result).exports;
    if (memory) memories.push(memory);
    return result;
  };
}
