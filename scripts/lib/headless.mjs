// The page's module in Node.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

/** Milliseconds and packing steps of one slice that does all the work. */
export const all = /** @type {const} */ ([1e9, 1e9]);

/** @typedef {{ data: Uint8ClampedArray<ArrayBuffer>, width: number, height: number }} Pixels */

/**
 * Loads a module.
 * @param {string} folder where it was built
 * @param {Uint8Array} [bytes] another copy of it
 * @param {string} [copy] a name, for an instance beside the first one
 */
export async function moduleIn(folder, bytes = readFileSync(join(folder, 'bubblestone_bg.wasm')), copy = '') {
  const module = await import(`${pathToFileURL(join(folder, 'bubblestone.js')).href}?${copy}`);
  module.initSync({ module: bytes });
  return module;
}

/** The part of a canvas that the module uses. */
export class Canvas {
  /** @type {Pixels} */
  pixels = { data: new Uint8ClampedArray(), width: 0, height: 0 };

  /** @param {Pixels} pixels */
  putImageData(pixels) {
    this.pixels = pixels;
  }
}

/** Replaces the browser's class. It copies the data, as the module passes a view of its own memory. */
globalThis.ImageData ??= /** @type {any} */ (
  class {
    /** @param {Uint8ClampedArray} data @param {number} width @param {number} height */
    constructor(data, width, height) {
      Object.assign(this, { data: data.slice(), width, height });
    }
  }
);
