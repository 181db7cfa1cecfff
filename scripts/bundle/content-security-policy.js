// The page's Content-Security-Policy: nothing runs, loads or is sent but what the build put there.
// At build time only, because the development server needs more; written last, when the scripts have their final text.

import { createHash } from 'node:crypto';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

/** What the page needs wherever it lies: its module compiled, the module's text as data:, workers and pictures it makes itself. */
const ALWAYS = {
  'default-src': "'none'",
  'script-src': "'wasm-unsafe-eval'",
  'worker-src': 'blob:',
  'connect-src': 'data:',
  'img-src': 'data: blob:',
  'style-src': "'unsafe-inline'",
  'font-src': 'data:',
  'base-uri': "'none'",
  'form-action': "'none'",
};

/**
 * @param {Partial<Record<keyof typeof ALWAYS | 'manifest-src', string>>} [more]  sources beside those
 * @returns {import('vite').Plugin}
 */
export const contentSecurityPolicy = (more = {}) => ({
  name: 'content-security-policy',
  apply: 'build',
  writeBundle: {
    order: 'post',
    handler({ dir = '' }, bundle) {
      for (const name of Object.keys(bundle).filter((file) => file.endsWith('.html'))) {
        const path = join(dir, name);
        const html = readFileSync(path, 'utf8');
        const meta = `<meta http-equiv="Content-Security-Policy" content="${policy(html, more)}">`;
        if (!html.includes('<head>')) throw new Error(`${name} has no <head> to put its Content-Security-Policy into`);
        writeFileSync(path, html.replace('<head>', () => `<head>\n    ${meta}`));
      }
    },
  },
});

/** @param {string} html @param {Record<string, string>} more */
function policy(html, more) {
  /** @type {Record<string, string>} */
  const directives = { ...ALWAYS };
  for (const [name, sources] of [...Object.entries(more), ['script-src', inlineScripts(html).join(' ')]]) {
    directives[name] = [directives[name], sources].filter(Boolean).join(' ');
  }
  return Object.entries(directives).map((directive) => directive.join(' ')).join('; ');
}

/** The hash of each script that stands in the page itself. @param {string} html */
const inlineScripts = (html) =>
  [...html.matchAll(/<script(?![^>]*\ssrc=)[^>]*>([\s\S]*?)<\/script>/g)].map(
    ([, text]) => `'sha256-${createHash('sha256').update(text).digest('base64')}'`,
  );
