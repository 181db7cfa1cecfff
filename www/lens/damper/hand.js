/**
 * A hand on the piston: it pulls, the piston follows a little later, as a hand is never as rough as a mouse; the engine says with
 * which force the damper resists.
 *
 * @typedef {import('../../run/damper-looks.js').DamperLooks} DamperLooks
 * @typedef {import('../../run/damper-looks.js').Damper} Damper
 * @typedef {ReturnType<DamperLooks['piston']>} Piston
 * @typedef {{ displacement: number, velocity: number, force: number, hysteresis: number, internalDisplacement: number }} Grip
 */

/** How quickly the piston follows, in 1/s: it is a twelfth of a second behind, and never jerks as a mouse does. */
const quickness = 25;
/** A frame that takes longer was none, in s. */
const longestStep = 0.05;
/** So long the way it went is shown, in frames. */
const longestTrail = 240;

export class DamperHand {
  /** Where it is and what the damper does; null before it was touched. @type {Grip | null} */ grip = null;
  /** Where it went, oldest first. @type {Grip[]} */ trail = [];
  isHeld = false;
  /** Where the hand wants it, in m. */ target = 0;
  /** @type {Piston | null} */ #piston = null;
  #last = NaN;
  #velocity = 0;

  /** Takes hold of the piston of a damper. @param {DamperLooks} dampers @param {Damper} damper */
  hold(dampers, damper) {
    this.letBe();
    this.#piston = dampers.piston(damper);
    this.isHeld = true;
    this.target = 0;
    this.#last = NaN;
  }

  /** Another command, under the hand. @param {number} command */
  command(command) {
    this.#piston?.setCommand(command);
  }

  /** Goes on. @param {number} now in ms */
  step(now) {
    const passed = (now - this.#last) / 1000;
    this.#last = now;
    if (!this.#piston || !(passed > 0)) return;
    const interval = Math.min(passed, longestStep);
    const behind = (this.grip?.displacement ?? 0) - this.target;
    // As a mass on a critically damped spring that the hand pulls at.
    const pull = (this.#velocity + quickness * behind) * interval;
    const faded = Math.exp(-quickness * interval);
    this.#velocity = (this.#velocity - quickness * pull) * faded;
    const grip = this.#piston.lead(this.target + (behind + pull) * faded, interval);
    this.grip = grip;
    this.trail.push(grip);
    if (this.trail.length > longestTrail) this.trail.shift();
  }

  /** Whether the piston still follows. */
  get isMoving() {
    return this.isHeld || Math.abs((this.grip?.displacement ?? 0) - this.target) > 1e-5;
  }

  /** Lets go: the piston stays where it is. */
  release() {
    this.isHeld = false;
  }

  /** As if no hand had been there. */
  letBe() {
    this.isHeld = false;
    this.#piston?.free();
    this.#piston = null;
    this.grip = null;
    this.trail = [];
    this.target = 0;
    this.#velocity = 0;
  }
}
