/** Choices whose words are shown by small pictures, as in figure 2 of the paper on piles. */
import type { Generator } from '../module/types';
import { make } from '../base/dom';

/** The side of a picture, in CSS pixels. */
const SIDE = '64';

/** The address of the picture of a word; `undefined` if the word has none. */
export type Pictures = (word: string) => string | undefined;

/** The pictures of a choice's words; `undefined` if it has none. The build makes them from the generator's rules. */
export function picturesOf({ word: generator, samples }: Generator, key: string): Pictures | undefined {
  const rules = samples.filter(({ keys }) => keys.includes(key));
  if (!rules.length) return undefined;
  return (word) => {
    const rule = rules.find(({ words, without }) => !without.includes(word) && (!words.length || words.includes(word)));
    return rule && `thumbs/${generator}-${rule.keys[0] ?? key}-${word}.avif`;
  };
}

/** Puts the pictures into a row of buttons, which then scrolls sideways. The chosen one is kept in sight. */
export function withPictures<Parts extends { inputs: HTMLElement[]; show: (value: string, standard: string) => void }>(parts: Parts, pictures: Pictures): Parts {
  const [row] = parts.inputs;
  if (!row) return parts;
  row.classList.add('pictured');
  for (const radio of row.querySelectorAll('input')) {
    const src = pictures(radio.value);
    radio.closest('label')?.classList.toggle('bare', !src);
    if (src) radio.before(make('img', { src, alt: '', loading: 'lazy', decoding: 'async', width: SIDE, height: SIDE }));
  }
  const reveal = (): void => {
    const chosen = row.querySelector(':checked')?.closest('label');
    if (chosen && !row.matches(':focus-within, :hover')) row.scrollLeft = chosen.offsetLeft - (row.clientWidth - chosen.offsetWidth) / 2;
  };
  // The row may be folded away at first, and measuring it at once would force a layout.
  new ResizeObserver(reveal).observe(row);
  let known: string | undefined;
  const { show } = parts;
  return {
    ...parts,
    show: (value, standard) => {
      show(value, standard);
      if (value !== known) requestAnimationFrame(reveal);
      known = value;
    },
  };
}
