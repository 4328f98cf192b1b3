/**
 * Scales all lengths with the picture's side: the same design with more pixels, where a larger side alone would give more
 * stones. Only the control does this, and only if the visitor wants it; a link means exactly its values.
 *
 * Lengths are scaled from the visitor's own values, not from values scaled before, until something else changes them.
 * So rounding and limits at one side leave no trace when the first side returns.
 */
import { t } from '../words/words';
import { make } from '../base/dom';
import { notice } from '../base/messages';
import { keep, kept } from '../base/storage';
import { applies, differs, recipeOf } from '../state/rules';
import type { Work } from '../state/work';
import { SIDE } from './control';
import type { Panel } from './panel';

const CHOICE = 'scale';

/** The schema gives the unit of every length but this one, which is in pixels on stones and in skin sizes on skin. */
const ROUGHNESS = 'af';

type Values = readonly (readonly [key: string, text: string])[];

export class Scaling {
  private readonly work: Work;
  private readonly check = make('input', { type: 'checkbox', id: 'scale-all', 'aria-describedby': 'scale-all-help' });
  /** The visitor's own values, and the result of the last scaling. */
  private own: { values: Values; scaled: Values } | undefined;

  constructor(work: Work) {
    this.work = work;
    this.check.checked = kept(CHOICE) !== 'no';
    this.check.addEventListener('change', () => {
      keep(CHOICE, this.check.checked ? 'yes' : 'no');
      this.own = undefined;
    });
  }

  /** Puts the checkbox beside the control of the side. */
  build(panel: Panel): void {
    const words = t('scale_all_title');
    const help = make('span', { class: 'said', id: 'scale-all-help' }, words);
    const label = make('label', { title: words }, this.check, make('span', {}, t('scale_all')));
    for (const [, group] of panel.groupings()) group.querySelector(`[data-key=${SIDE}]`)?.append(make('div', { class: 'option' }, label, help));
  }

  /** Sets a new side; `held` while its slider still moves. */
  set(text: string, held: boolean): void {
    const { engine } = this.work;
    if (!this.check.checked) return this.work.set(SIDE, text, held);
    const now = this.lengths();
    const { own } = this;
    const values = own && isSame(own.scaled, now) ? own.values : now;
    // The side's own limits apply first: the lengths follow the side as it really is.
    engine.set(SIDE, text);
    const ratio = Number(engine.get(SIDE)) / Number(valueOf(values, SIDE));
    const lengths = values.filter(([key]) => key !== SIDE).map(([key, value]) => [key, scaled(value, ratio)] as const);
    // Set everything again with the lengths in place. Notices are then about the side alone.
    notice('value', ...this.work.setAll([...lengths, [SIDE, text]], held));
    this.own = { values, scaled: this.lengths() };
  }

  /** The side, and all lengths in pixels that apply or were changed. */
  private lengths(): Values {
    const { engine } = this.work;
    const recipe = recipeOf(engine);
    const isLength = (key: string, unit: string): boolean => (key === ROUGHNESS ? engine.get('stone') !== 'skin' : unit === 'px');
    const counts = recipe.schema.filter((row) => applies(row, recipe) || differs(row, engine.get(row.key), engine.defaultOf(row)));
    return counts.filter(({ key, unit }) => isLength(key, unit)).map(({ key }) => [key, engine.get(key)] as const);
  }
}

function isSame(a: Values, b: Values): boolean {
  return a.join() === b.join();
}

function valueOf(values: Values, key: string): string | undefined {
  return values.find(([name]) => name === key)?.[1];
}

/** Rounds to thousandths of a pixel: finer than anything visible, and short in a link. */
function scaled(value: string, ratio: number): string {
  return ratio === 1 ? value : String(Math.round(Number(value) * ratio * 1000) / 1000);
}
