/** The choice of a generator at the top of the page, by picture and word; hidden where there is only one. */
import { generators, makeOf } from '../module/generators';
import { makeIn } from '../words/words';
import { byId, make } from '../base/dom';
import { withValues } from '../state/link';
import type { Work } from '../state/work';

/** What was pressed before there was anything to choose with. */
let pressed = '';

/** Puts the buttons there: before anything is painted, so that nothing moves later. What is pressed until then is kept. */
export function showMakes(choose: (word: string) => void = (word) => (pressed = word)): HTMLButtonElement[] {
  const nav = byId('makes');
  nav.hidden = generators.length < 2;
  if (nav.hidden) return [];
  const buttons = generators.map(({ word, title, preset }) => {
    const picture = make('img', { src: `thumbs/${preset}.avif`, alt: '', width: '28', height: '28', decoding: 'async' });
    const button = make('button', { type: 'button', class: 'make', 'data-make': word }, picture, make('span', {}, makeIn(word, title)));
    button.addEventListener('click', () => choose(word));
    return button;
  });
  nav.replaceChildren(...buttons);
  return buttons;
}

/** `push` is called before a change that the browser's Back button shall take back. */
export function offerMakes(work: Work, push: () => void): void {
  const { engine, store } = work;
  /** The last recipe of each, for the way back. */
  const last = new Map<string, string>();
  const choose = (word: string): void => {
    const chosen = generators.find((one) => one.word === word);
    if (word === store.state.make) work.stay();
    if (!chosen || word === store.state.make) return;
    const values = chosen.carried.map((key) => [key, engine.get(key)] as const).filter(([, text]) => text !== '');
    push();
    work.open(withValues(last.get(word) ?? (chosen === generators[0] ? 'v=1' : `v=1&make=${word}`), values), { then: () => store.update({ paused: false }) });
  };
  const buttons = showMakes(choose);
  if (!buttons.length) return;
  const mark = (): void => {
    const { make: word, coming } = store.state;
    for (const button of buttons) {
      if (button.dataset['make'] === word) button.setAttribute('aria-current', 'true');
      else button.removeAttribute('aria-current');
      button.setAttribute('aria-busy', String(coming !== '' && makeOf(coming) === button.dataset['make']));
    }
  };
  mark();
  store.on(['make', 'coming'], mark);
  store.on(['recipe', 'held'], ({ recipe, held, make: word }) => {
    if (!held) last.set(word, recipe);
  });
  last.set(store.state.make, store.state.recipe);
  if (pressed) choose(pressed);
}
