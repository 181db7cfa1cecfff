import { Panel } from '../stability/panel.js';
import { gearOf, rollNow } from './gear.js';

/** What the views of many landings share: the set of them, which the lens keeps. */
export class SetPanel extends Panel {
  static properties = { ...Panel.properties, rolls: { attribute: false } };

  constructor() {
    super();
    /** @type {import('./roll-set.js').RollSet | null} */ this.rolls = null;
  }

  disconnectedCallback() {
    this.rolls?.stop();
    super.disconnectedCallback();
  }

  get roll() {
    return rollNow(this.scene, this.settings);
  }

  /** @param {import('../../run/scene.js').Scene} scene @param {import('../../style/theme.js').Theme} theme */
  draw(scene, theme) {
    super.draw(scene, theme);
    if (this.isVeiled || !this.rolls) return;
    this.rolls.onChange = () => this.requestUpdate();
    this.rolls.look(gearOf(scene), this.roll);
  }

  updated() {
    super.updated();
    if (this.scene && this.theme) this.draw(this.scene, this.theme);
  }

  /** Whether the gear on the stage is that of a landing. @param {import('./cases.js').Case} spec */
  isNow({ dampingConstant, current }) {
    const { scene } = this;
    return scene !== null && scene.parameters.dampingConstant === dampingConstant && scene.parameters['damper.command'] === current;
  }
}
