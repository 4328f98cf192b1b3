/** The WebAssembly module: fetched packed, compiled while it is unpacked; for later visits it is kept unpacked. */
import init from '../../pkg/bubblestone.js';
import packed from '../../pkg/bubblestone.lzma?url';
import { Unpacker } from './lzma';

/** Bytes that are unpacked at a time: a few milliseconds of work, after which the page may do other things. */
const PIECE = 32_768;

const CACHE = 'bubblestone module';
const KEPT = `${packed}.wasm`;

/** Throws what a browser without a fitting WebAssembly or a broken connection throws. */
export async function loadModule(): Promise<void> {
  const kept = await keptModule();
  if (kept) {
    try {
      await init({ module_or_path: kept });
      return;
    } catch {
      // The kept copy is broken: the site has another.
      await caches.delete(CACHE);
    }
  }
  await init({ module_or_path: await unpacked() });
}

/** Keeps the module for the next visit; of other builds nothing stays. */
export async function keepModule(): Promise<void> {
  if (await keptModule()) return;
  await caches.delete(CACHE);
  const cache = await caches.open(CACHE);
  await cache.put(KEPT, await unpacked());
}

async function keptModule(): Promise<Response | undefined> {
  try {
    return await caches.match(KEPT, { cacheName: CACHE });
  } catch {
    // Some browsers have no cache, or forbid it.
    return undefined;
  }
}

async function unpacked(): Promise<Response> {
  // When it is to be kept, the browser still has it from the first time.
  const answer = await fetch(packed, { cache: 'force-cache' });
  if (!answer.ok) throw new Error(`${answer.status}`);
  const unpacker = new Unpacker(new Uint8Array(await answer.arrayBuffer()));
  const pieces = new ReadableStream({
    pull: (controller) => {
      const piece = unpacker.next(PIECE);
      if (piece.length) controller.enqueue(piece);
      else controller.close();
    },
  });
  return new Response(pieces, { headers: { 'content-type': 'application/wasm' } });
}
