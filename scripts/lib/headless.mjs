// The page's module in Node: its script runs here as it is.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

/** Milliseconds and packing steps of one slice of work: all at once. */
export const all = /** @type {const} */ ([1e9, 1e9]);

/** @typedef {{ data: Uint8ClampedArray<ArrayBuffer>, width: number, height: number }} Pixels */

/**
 * A module, ready for calls.
 * @param {string} folder where it was built
 * @param {Uint8Array} [bytes] another copy of it
 * @param {string} [copy] a name, for an instance beside the first one
 */
export async function moduleIn(folder, bytes = readFileSync(join(folder, 'bubblestone_bg.wasm')), copy = '') {
  const module = await import(`${pathToFileURL(join(folder, 'bubblestone.js')).href}?${copy}`);
  module.initSync({ module: bytes });
  return module;
}

/** What the module needs of a canvas. */
export class Canvas {
  /** @type {Pixels} */
  pixels = { data: new Uint8ClampedArray(), width: 0, height: 0 };

  /** @param {Pixels} pixels */
  putImageData(pixels) {
    this.pixels = pixels;
  }
}

/** The browser's class of this name; the module hands over a view of its own memory, which does not stay. */
globalThis.ImageData ??= /** @type {any} */ (
  class {
    /** @param {Uint8ClampedArray} data @param {number} width @param {number} height */
    constructor(data, width, height) {
      Object.assign(this, { data: data.slice(), width, height });
    }
  }
);
