/**
 * The choice of a generator at the top of the page, as pictures with words. The build writes it into the page if
 * there is more than one generator.
 */
import { generators, makeOf } from '../module/generators';
import { makeIn } from '../words/words';
import { byId } from '../base/dom';
import type { Work } from '../state/work';

/** The choice that was pressed before `offerMakes` was called. */
let pressed = '';

let choose = (word: string): void => {
  pressed = word;
};

/** Listens to presses, also before `offerMakes`. */
export function hearMakes(): void {
  byId('makes').addEventListener('click', ({ target }) => {
    const word = (target as Element).closest<HTMLElement>('.make')?.dataset['make'];
    if (word) choose(word);
  });
}

/** `push` is called before a change that the browser's Back button should undo. */
export function offerMakes(work: Work, push: () => void): void {
  const { store } = work;
  /** The last recipe of each generator, for the way back. */
  const last = new Map<string, string>();
  choose = (word) => {
    const chosen = generators.find((one) => one.word === word);
    if (word === store.state.make) work.stay();
    if (!chosen || word === store.state.make) return;
    push();
    // At the first press, opens the recipe that the small picture shows.
    work.open(last.get(word) ?? chosen.link, { then: () => store.update({ paused: false }) });
  };
  const buttons = [...byId('makes').querySelectorAll<HTMLButtonElement>('.make[data-make]')];
  for (const { dataset, lastElementChild } of buttons) {
    const made = generators.find(({ word }) => word === dataset['make']);
    if (made && lastElementChild) lastElementChild.textContent = makeIn(made.word, made.title);
  }
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
