// Writes the list of the site's files into dist/sw.js, once all of them exist. The service worker stores these files.
import { createHash } from 'node:crypto';
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join, relative, sep } from 'node:path';
import { digest } from './digest.mjs';

const worker = 'sw.js';

/** All files of a built site except the service worker, by path. @param {string} site @returns {string[]} */
export function filesOf(site) {
  return readdirSync(site, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => relative(site, join(entry.parentPath, entry.name)).split(sep).join('/'))
    .filter((path) => path !== worker)
    .sort();
}

/** The files that the page needs at its start: those named in its HTML, without the modules of other generators. @param {string} site */
export function firstOf(site) {
  const html = readFileSync(join(site, 'index.html'), 'utf8');
  const named = [...html.matchAll(/<(?:link|script|img)\b[^>]* (?:href|src|data-first)="(?:\.\/)?([^"]+)"/g)].map(([, path]) => path);
  return filesOf(site).filter((path) => path === 'index.html' || named.includes(path));
}

/** The path by which a browser asks for a file; for a page it is the path of its folder. @param {string} path */
export const asked = (path) => path.replace(/(^|\/)index\.html$/, '$1');

/** The value of SITE in www/service/sw.ts. @param {string} site */
export function listOf(site) {
  const files = Object.fromEntries(filesOf(site).map((path) => [asked(path), digest([join(site, path)]).slice(0, 32)]));
  const version = createHash('sha256').update(JSON.stringify(files)).digest('hex').slice(0, 16);
  return { version, files, first: firstOf(site).map(asked) };
}

/** The Vite plugin. */
export const offline = {
  name: 'offline',
  /** @param {{ dir?: string }} output */
  writeBundle({ dir = '' }) {
    const file = join(dir, worker);
    writeFileSync(file, `const SITE=${JSON.stringify(listOf(dir))};\n${readFileSync(file, 'utf8')}`);
  },
};
