/**
 * The clock of the bench: the piston goes round its cycle in a time in which one can follow it, whatever its frequency, as long as
 * the page's clock runs.
 */
export class Bench {
  /** So long a cycle takes here, in s. */
  secondsACycle = 4;
  /** Where in its cycle the piston is, 0 … 1. */
  phase = 0.08;
  #last = NaN;
  #time = NaN;

  /**
   * @param {{ time: number }} scene whose time goes on where the page's clock runs
   * @param {number} now in ms
   */
  follow({ time }, now) {
    const isRunning = time !== this.#time && !Number.isNaN(this.#time);
    const passed = now - this.#last;
    this.#time = time;
    this.#last = now;
    // A page that was hidden goes on where it stood.
    if (isRunning && passed < 250) this.phase = (this.phase + passed / 1000 / this.secondsACycle) % 1;
  }
}
