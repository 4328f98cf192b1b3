/** The WebAssembly module: fetched packed, compiled while it is unpacked; for later visits it is kept unpacked. */
import init from '../../pkg/bubblestone.js';
import packed from '../../pkg/bubblestone.lzma?url';
import { Unpacker } from './lzma';

/** Bytes that are unpacked between two breaths of the page: a few milliseconds of work. */
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
      // What was kept is broken: the site has it, too.
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
    // Not every place has a storage.
    return undefined;
  }
}

async function unpacked(): Promise<Response> {
  // The second time, to keep it, the browser still has it.
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
