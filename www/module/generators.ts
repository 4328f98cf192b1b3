/** The generators of the site, which the build has asked their modules for. */
import made from 'virtual:generators';

/** In the order of the page; the first one is that of links that name none. */
export const generators = made;

/** The word of the generator that a link names; that of the first where it names none that is known. */
export function makeOf(link: string): string {
  const pairs = link.replace(/^[^#]*#/, '').split('&').map((pair) => pair.split('='));
  const given = pairs.filter(([key]) => key?.trim().toLowerCase() === 'make').map(([, word = '']) => decoded(word).trim().toLowerCase());
  const known = given.filter((word) => generators.some((one) => one.word === word));
  return known.at(-1) ?? generators[0]?.word ?? '';
}

/** The place of the first module that has the generator of a link. */
export function placeOf(link: string): number {
  const word = makeOf(link);
  return generators.find((one) => one.word === word)?.module ?? 0;
}

function decoded(word: string): string {
  try {
    return decodeURIComponent(word);
  } catch {
    return word;
  }
}
