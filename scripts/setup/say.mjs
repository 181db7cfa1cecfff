// What the set-up says: one line a step, and one clear sentence where it cannot go on.

const color = process.stdout.isTTY && !process.env.NO_COLOR;

/** @param {string} code @param {string} text */
const paint = (code, text) => (color ? `\x1b[${code}m${text}\x1b[0m` : text);

/** @param {string} step @param {string} text */
export const found = (step, text) => console.log(`${paint('32', '✓')} ${step}: ${text}`);

/** @param {string} step @param {string} text */
export const busy = (step, text) => console.log(`${paint('33', '…')} ${step}: ${text}`);

/** @param {string} step @param {string} text */
export const failed = (step, text) => console.error(`${paint('31', '✗')} ${step}: ${text}`);

/** A piece is not there and cannot be had from here; the message names it and how to get it. */
export class Missing extends Error {}

/** The end of a program's talk: where it says what went wrong. @param {string} text */
export const tail = (text, lines = 15) => text.split('\n').slice(-lines).join('\n');
