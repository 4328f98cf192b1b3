/** Gives engines the files that their recipes name. The page and all workers use this. */
import type { Bubblestone } from '../../pkg/bubblestone.js';
import type { RecipeFile } from '../../pkg-house/bubblestone.js';
import type { Module } from './load';
import type { SceneStudio, Whole } from './scene';
import { dropFile, findFile } from './shelf';

/** Bytes of one piece: about a millisecond of work. */
const PIECE = 1 << 20;

/** The bytes of a file, piece by piece. */
export async function* piecesOf(file: Blob): AsyncGenerator<Uint8Array<ArrayBuffer>> {
  for (let at = 0; at < file.size; at += PIECE) yield new Uint8Array(await file.slice(at, at + PIECE).arrayBuffer());
}

/** An engine for a link, with the files that it names, as far as they are available. */
export function studioFor(module: Whole, link: string): Promise<SceneStudio>;
export function studioFor(module: Module, link: string): Promise<Bubblestone>;
export async function studioFor(module: Module | Whole, link: string): Promise<Bubblestone> {
  const studio = new module.Bubblestone(link);
  await supply(studio);
  return studio;
}

/** Gives an engine its missing files. False if one is not available, or if `wanted` returns false meanwhile. */
export async function supply(studio: Bubblestone, wanted: () => boolean = () => true): Promise<boolean> {
  if (!isWhole(studio)) return true;
  for (const missing of studio.missingFiles()) if (missing.digest !== '' && !(await give(studio, missing, wanted))) return false;
  return true;
}

async function give(studio: SceneStudio, { digest, name }: RecipeFile, wanted: () => boolean): Promise<boolean> {
  const file = await findFile(digest);
  if (!file || !wanted()) return false;
  studio.beginFile(name, file.size);
  for await (const piece of piecesOf(file)) {
    if (!wanted()) return false;
    studio.addToFile(piece);
  }
  if (!wanted()) return false;
  if (studio.giveFile() === digest) return true;
  // The bytes of the stored file do not have this digest.
  await dropFile(digest);
  return false;
}

function isWhole(studio: Bubblestone): studio is SceneStudio {
  return 'missingFiles' in studio;
}
