/**
 * The WebAssembly modules. The first one makes pavements and loads on a first visit. The second one makes everything,
 * including bodies in light, and loads when it is first needed. Each is downloaded compressed, compiled while it is
 * decompressed, and stored decompressed for later visits.
 */
import house from 'virtual:house';
import * as pavements from '../../pkg/bubblestone.js';
import packed from '../../pkg/bubblestone.lzma?url';
import { placeOf } from './generators';
import { Unpacker } from './lzma';
import type { Whole } from './scene';

/** A loaded module. */
export type Module = typeof pavements;

interface Source {
  readonly packed: string;
  readonly bring: () => Promise<Module>;
}

/** The modules, in the order of their indices. */
const FIRST: Source = { packed, bring: () => Promise.resolve(pavements) };
const SOURCES: readonly Source[] = [FIRST, { packed: house.packed, bring: () => script(house.script) }];

/** Bytes that are decompressed at a time: a few milliseconds of work, after which the page can do other things. */
const PIECE = 32_768;

const CACHE = 'bubblestone module';

/** The loaded modules, and those being loaded, by index. */
const ready: (Module | undefined)[] = [];
const coming: (Promise<Module> | undefined)[] = [];

/** The number of users of each module. */
const users = new Map<Module, number>();

/** Whether a loaded module is not stored for the next visit yet. */
let fresh = false;

/**
 * A loaded module that can open this link, if there is one. A later module can do everything that an earlier one can.
 */
export function moduleFor(link: string): Module | undefined {
  return ready
    .slice(placeOf(link))
    .filter((module) => module !== undefined)
    .at(-1);
}

/** Such a module, once it is loaded. Throws the browser's error if WebAssembly is missing or the connection fails. */
export async function loadModule(link: string): Promise<Module> {
  return moduleFor(link) ?? (coming[placeOf(link)] ??= arriving(placeOf(link)));
}

/** The last module, which can make everything, once it is loaded. Throws the same. */
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

/** Counts a user of a module. */
export function useModule(module: Module): void {
  users.set(module, (users.get(module) ?? 0) + 1);
}

/**
 * Ends a use of a module; everything that was made with it has been freed. An unused module is released with all its
 * memory if a later one can replace it.
 */
export function leaveModule(module: Module): void {
  const left = (users.get(module) ?? 1) - 1;
  users.set(module, left);
  const place = ready.indexOf(module);
  if (left > 0 || place < 0 || !ready.slice(place + 1).some((later) => later !== undefined)) return;
  ready[place] = undefined;
  module.release();
}

/**
 * The script of a later module. Some browsers never retry a script whose import has failed, so it is fetched before
 * it is imported.
 */
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
      // The stored copy is broken; it is downloaded again.
      await caches.delete(CACHE);
    }
  }
  await module.default({ module_or_path: await unpacked(packed) });
  return module;
}

/** Stores the loaded modules for the next visit, and deletes those of other builds. */
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
  // The browser still has this file in its cache when the module is stored.
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
