/** The generators of the site. The build gets this list from their modules. */
import made, { unknown } from 'virtual:generators';
import type { Notice } from './types';

/** The generators in the order of the page. A link that names none uses the first. */
export const generators = made;

/** The word of the generator that a link names, or of the first one if it names no known generator. */
export function makeOf(link: string): string {
  const pairs = link.replace(/^[^#]*#/, '').split('&').map((pair) => pair.split('='));
  const given = pairs.filter(([key]) => key?.trim().toLowerCase() === 'make').map(([, word = '']) => decoded(word).trim().toLowerCase());
  const known = given.filter((word) => generators.some((one) => one.word === word));
  return known.at(-1) ?? generators[0]?.word ?? '';
}

/** The index of the first module that has the generator of a link. */
export function placeOf(link: string): number {
  return named(link)?.module ?? 0;
}

/** Whether the generator of a link offers a part of the page. Its module need not be loaded. */
export function isOffered(link: string, part: string): boolean {
  return named(link)?.offers.includes(part) === true;
}

/**
 * The notice about an unknown generator, changed to name all generators of the page: a module names only its own. The
 * sentence is from the same table.
 */
export function knowingAll(notice: Notice): Notice {
  if (notice.code !== 'bad_make') return notice;
  const args = { ...notice.args, known: generators.map(({ word }) => word) };
  const text = unknown.replace(/\{(\w+)\}/g, (place, name: string) => {
    const arg = notice.args[name];
    return typeof arg === 'string' ? arg : place;
  });
  return { ...notice, args, text };
}

function named(link: string): (typeof generators)[number] | undefined {
  const word = makeOf(link);
  return generators.find((one) => one.word === word);
}

function decoded(word: string): string {
  try {
    return decodeURIComponent(word);
  } catch {
    return word;
  }
}
