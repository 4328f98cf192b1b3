/**
 * The WebAssembly modules. The first one makes pavements and loads on a first visit. The second one makes everything,
 * including bodies in light, and loads when it is first needed. Browsers compile a module while they download it. The
 * page's first script (www/start.js) starts the download of the module that the address needs.
 */
import house from 'virtual:house';
import * as pavements from '../../pkg/bubblestone.js';
import file from '../../pkg/bubblestone_bg.wasm?url';
import { placeOf } from './generators';
import type { Whole } from './scene';

/** A loaded module. */
export type Module = typeof pavements;

interface Source {
  readonly file: string;
  readonly bring: () => Promise<Module>;
}

/** The modules, in the order of their indices. */
const FIRST: Source = { file, bring: () => Promise.resolve(pavements) };
const SOURCES: readonly Source[] = [FIRST, { file: house.file, bring: () => script(house.script) }];

/** The loaded modules, and those being loaded, by index. */
const ready: (Module | undefined)[] = [];
const coming: (Promise<Module> | undefined)[] = [];

/** The number of users of each module. */
const users = new Map<Module, number>();

/**
 * A loaded module that can open this link, if there is one. A later module can do everything that an earlier one can.
 */
export function moduleFor(link: string): Module | undefined {
  return ready
    .slice(placeOf(link))
    .filter((module) => module !== undefined)
    .at(-1);
}

/**
 * Loads a module that can open this link. Throws the browser's error if WebAssembly is missing or the connection fails.
 */
export async function loadModule(link: string): Promise<Module> {
  return moduleFor(link) ?? (coming[placeOf(link)] ??= arriving(placeOf(link)));
}

/** Loads the last module, which can make everything. Throws like `loadModule`. */
export async function loadWhole(): Promise<Whole> {
  const last = SOURCES.length - 1;
  return (ready[last] ?? (await (coming[last] ??= arriving(last)))) as Whole;
}

async function arriving(place: number): Promise<Module> {
  try {
    return (ready[place] = await opened(SOURCES[place] ?? FIRST));
  } finally {
    coming[place] = undefined;
  }
}

/** Counts a user of a module. */
export function useModule(module: Module): void {
  users.set(module, (users.get(module) ?? 0) + 1);
}

/**
 * Ends a use of a module. Everything that was made with it must have been freed. An unused module is released with all
 * its memory if a later one can replace it.
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

/** Downloads the script and the file at the same time. */
async function opened({ file, bring }: Source): Promise<Module> {
  const [module, answer] = await Promise.all([bring(), answerFrom(file)]);
  await module.default({ module_or_path: answer });
  return module;
}

async function answerFrom(address: string): Promise<Response> {
  const answer = await fetch(address);
  if (!answer.ok) throw new Error(`${answer.status}`);
  return answer;
}
