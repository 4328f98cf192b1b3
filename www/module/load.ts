/**
 * The WebAssembly modules: one that makes pavements, which a first visit gets, and one that makes all there is, bodies in
 * light among it, which comes when it is first needed. Each is fetched packed, compiled while it is unpacked, and for
 * later visits kept unpacked.
 */
import house from 'virtual:house';
import * as pavements from '../../pkg/bubblestone.js';
import packed from '../../pkg/bubblestone.lzma?url';
import { placeOf } from './generators';
import { Unpacker } from './lzma';
import type { Whole } from './scene';

/** A module that is ready, for calls. */
export type Module = typeof pavements;

interface Source {
  readonly packed: string;
  readonly bring: () => Promise<Module>;
}

/** By their places. */
const FIRST: Source = { packed, bring: () => Promise.resolve(pavements) };
const SOURCES: readonly Source[] = [FIRST, { packed: house.packed, bring: () => script(house.script) }];

/** Bytes that are unpacked at a time: a few milliseconds of work, after which the page may do other things. */
const PIECE = 32_768;

const CACHE = 'bubblestone module';

/** The modules that are ready, and those on their way, by their places. */
const ready: (Module | undefined)[] = [];
const coming: (Promise<Module> | undefined)[] = [];

/** How many use each. */
const users = new Map<Module, number>();

/** One is ready that is not kept for the next visit yet. */
let fresh = false;

/** The module that a link is to be opened with, where it is ready; the later one has all that the one before it has. */
export function moduleFor(link: string): Module | undefined {
  return ready
    .slice(placeOf(link))
    .filter((module) => module !== undefined)
    .at(-1);
}

/** The same, once it is ready. Throws what a browser without a fitting WebAssembly or a broken connection throws. */
export async function loadModule(link: string): Promise<Module> {
  return moduleFor(link) ?? (coming[placeOf(link)] ??= arriving(placeOf(link)));
}

/** The last module, which has all there is, once it is ready, whatever a link makes. Throws the same. */
export async function loadWhole(): Promise<Whole> {
  const last = SOURCES.length - 1;
  return (ready[last] ?? (await (coming[last] ??= arriving(last)))) as Whole;
}

async function arriving(place: number): Promise<Module> {
  try {
    const module = await opened(SOURCES[place] ?? FIRST);
    fresh = true;
    return (ready[place] = module);
  } finally {
    coming[place] = undefined;
  }
}

/** Somebody begins to use a module. */
export function useModule(module: Module): void {
  users.set(module, (users.get(module) ?? 0) + 1);
}

/** Who used a module has freed all that was made with it: where nobody uses it and another one can do all that it could, it goes, with all its memory. */
export function leaveModule(module: Module): void {
  const left = (users.get(module) ?? 1) - 1;
  users.set(module, left);
  const place = ready.indexOf(module);
  if (left > 0 || place < 0 || !ready.slice(place + 1).some((later) => later !== undefined)) return;
  ready[place] = undefined;
  module.release();
}

/** The script of a later module. Some browsers never ask again for a script whose import has failed: it is imported once it can be had. */
async function script(address: string): Promise<Module> {
  await answerFrom(address);
  return (await import(/* @vite-ignore */ address)) as Module;
}

async function opened({ packed, bring }: Source): Promise<Module> {
  const [module, kept] = await Promise.all([bring(), keptModule(packed)]);
  if (kept) {
    try {
      await module.default({ module_or_path: kept });
      return module;
    } catch {
      // The kept copy is broken: the site has another.
      await caches.delete(CACHE);
    }
  }
  await module.default({ module_or_path: await unpacked(packed) });
  return module;
}

/** Keeps the modules that are ready for the next visit; of other builds nothing stays. */
export async function keepModules(): Promise<void> {
  if (!fresh) return;
  fresh = false;
  const cache = await caches.open(CACHE);
  const ours = SOURCES.map(({ packed }) => new URL(nameOf(packed), location.href).href);
  const there = (await cache.keys()).map(({ url }) => url);
  await Promise.all(there.filter((url) => !ours.includes(url)).map((url) => cache.delete(url)));
  for (const [place, { packed }] of SOURCES.entries()) {
    if (ready[place] && !there.includes(ours[place] ?? '')) await cache.put(nameOf(packed), await unpacked(packed));
  }
}

function nameOf(packed: string): string {
  return `${packed}.wasm`;
}

async function keptModule(packed: string): Promise<Response | undefined> {
  try {
    return await caches.match(nameOf(packed), { cacheName: CACHE });
  } catch {
    // Some browsers have no cache, or forbid it.
    return undefined;
  }
}

async function unpacked(packed: string): Promise<Response> {
  // When it is to be kept, the browser still has it from the first time.
  const answer = await answerFrom(packed, { cache: 'force-cache' });
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

async function answerFrom(address: string, how?: RequestInit): Promise<Response> {
  const answer = await fetch(address, how);
  if (!answer.ok) throw new Error(`${answer.status}`);
  return answer;
}
