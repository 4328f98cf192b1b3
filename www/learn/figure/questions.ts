/** The questions of a figure: when its numbers show what was asked, a sentence says it beside the prediction. */
import { make } from '../../base/dom';
import type { Ask, Figure, Language, Seen } from '../figures/figure';
import { expected } from '../figures/words';

export class Questions {
  private readonly figure: Figure;
  private readonly language: Language;
  private readonly found: Set<Ask>;

  /** The answered questions of `found` stay answered. */
  constructor(figure: Figure, language: Language, found: Set<Ask>) {
    [this.figure, this.language, this.found] = [figure, language, found];
  }

  /** Whether a question is answered after which the place where the potential is 0 is shown. */
  get showsZero(): boolean {
    return [...this.found].some((ask) => ask.showsZero);
  }

  get answered(): ReadonlySet<string> {
    return new Set([...this.found].map(({ key }) => key));
  }

  /** Looks at the numbers; true if a question was answered for the first time. */
  look(seen: Seen): boolean {
    let isNew = false;
    for (const ask of this.figure.asks) {
      const sentence = ask.seen(seen, this.language);
      if (sentence === undefined) continue;
      isNew ||= !this.found.has(ask);
      this.found.add(ask);
      this.tell(ask, sentence);
    }
    return isNew;
  }

  private tell(ask: Ask, sentence: string): void {
    const place = document.querySelector<HTMLElement>(`[data-seen="${ask.key}"]`);
    if (!place) return;
    const chosen = document.querySelector<HTMLInputElement>(`[data-ask="${ask.key}"] input:checked`)?.value ?? '';
    const prediction = expected(ask, chosen, this.language);
    if (place.textContent === `${prediction}${sentence}` && !place.hidden) return;
    place.setAttribute('aria-live', 'polite');
    place.hidden = false;
    place.replaceChildren(make('span', { class: 'expected' }, prediction), sentence);
  }
}
