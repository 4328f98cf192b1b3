/** The generators of the site. The build gets this list from their modules. */
import made from 'virtual:generators';
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

/** Whether the generator of a link offers a part of the page, told before its module is here. */
export function isOffered(link: string, part: string): boolean {
  return named(link)?.offers.includes(part) === true;
}

/** A module names its own generators to a link that has an unknown one. This names all that the page has. */
export function knowingAll(notice: Notice): Notice {
  const own = notice.args['known'];
  if (notice.code !== 'bad_make' || !Array.isArray(own)) return notice;
  const all = generators.map(({ word }) => word);
  return { ...notice, args: { ...notice.args, known: all }, text: notice.text.replace(listed(own), listed(all)) };
}

/** Words as the module lists them in English. */
function listed(words: unknown[]): string {
  return words.length > 1 ? `${words.slice(0, -1).join(', ')} or ${String(words.at(-1))}` : words.join();
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
