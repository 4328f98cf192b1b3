/** The WebAssembly module: fetched packed, compiled while it is unpacked. */
import init from '../pkg/bubblestone.js';
import packed from '../pkg/bubblestone.lzma?url';
import { Unpacker } from './lzma';

/** Bytes that are unpacked between two breaths of the page: a few milliseconds of work. */
const PIECE = 32_768;

/** Throws what a browser without a fitting WebAssembly or a broken connection throws. */
export async function loadModule(): Promise<void> {
  const answer = await fetch(packed);
  if (!answer.ok) throw new Error(`${answer.status}`);
  const unpacker = new Unpacker(new Uint8Array(await answer.arrayBuffer()));
  const pieces = new ReadableStream({
    pull: (controller) => {
      const piece = unpacker.next(PIECE);
      if (piece.length) controller.enqueue(piece);
      else controller.close();
    },
  });
  await init({ module_or_path: new Response(pieces, { headers: { 'content-type': 'application/wasm' } }) });
}
