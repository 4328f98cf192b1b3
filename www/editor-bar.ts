/** The buttons for what is edited over the canvas; they stand in the caption's place. */
import { make, say } from './dom';
import type { Figure, Sort } from './types';

export interface BarNeeds {
  choose(word: string): void;
  addFigure(): void;
  addPoint(): void;
  remove(): void;
  value(value: number): void;
  close(): void;
}

export class EditorBar {
  private readonly bar: HTMLElement;
  private readonly what = make('select', { id: 'edit-what', 'aria-label': 'What is edited' });
  private readonly addFigure = make('button', { type: 'button', id: 'add-figure' });
  private readonly addPoint = make('button', { type: 'button', id: 'add-point', title: 'Add a point after the marked one (Insert, or double click on a line)' }, 'Add point');
  private readonly remove = make('button', { type: 'button', id: 'remove-point', title: 'Remove what is marked (Delete)' });
  private readonly number = make('input', { type: 'number', id: 'figure-value', inputmode: 'decimal' });
  private readonly kinds = make('select', { id: 'figure-kind' });

  constructor(bar: HTMLElement, needs: BarNeeds) {
    this.bar = bar;
    const done = make('button', { type: 'button', id: 'edit-done', title: 'Leave the points (Escape)' }, 'Done');
    this.what.addEventListener('change', () => needs.choose(this.what.value));
    this.addFigure.addEventListener('click', () => needs.addFigure());
    this.addPoint.addEventListener('click', () => needs.addPoint());
    this.remove.addEventListener('click', () => needs.remove());
    this.number.addEventListener('change', () => needs.value(this.number.valueAsNumber));
    this.kinds.addEventListener('change', () => needs.value(this.kinds.selectedIndex));
    done.addEventListener('click', () => needs.close());
    bar.replaceChildren(this.what, this.addFigure, this.addPoint, this.kinds, this.number, this.remove, done);
  }

  hide(): void {
    this.bar.hidden = true;
  }

  /** The keyboard goes where figures are added, or to the choice of sorts. */
  focus(): void {
    (this.addFigure.hidden ? this.what : this.addFigure).focus({ preventScroll: true });
  }

  /** Shows what fits the sort, and the marked figure's value. */
  show(sorts: Sort[], sort: Sort, marked: Figure | undefined, removable: boolean): void {
    this.bar.hidden = false;
    const words = sorts.map(({ word }) => word).join();
    if (this.what.dataset['words'] !== words) {
      this.what.replaceChildren(...sorts.map(({ word, label }) => make('option', { value: word }, label)));
      this.what.dataset['words'] = words;
    }
    this.what.value = sort.word;
    this.addFigure.hidden = sort.form === 'ring';
    say(this.addFigure, `Add ${sort.figure}`);
    const pointwise = sort.form === 'ring' || sort.form === 'line';
    this.addPoint.hidden = !pointwise;
    this.addPoint.disabled = !marked;
    const last = !pointwise || (sort.form === 'line' && marked !== undefined && marked.points.length <= sort.least);
    say(this.remove, `Remove ${last ? sort.figure : 'point'}`);
    this.remove.disabled = !removable;
    this.showValue(sort, marked);
  }

  private showValue({ value }: Sort, marked: Figure | undefined): void {
    const words = value?.words;
    this.kinds.hidden = !words;
    this.kinds.disabled = !marked;
    this.number.hidden = !value || words !== undefined;
    this.number.disabled = !marked;
    if (!value) return;
    const field = words ? this.kinds : this.number;
    field.setAttribute('aria-label', value.label);
    field.title = value.label;
    if (words) {
      if (this.kinds.options.length !== words.length) this.kinds.replaceChildren(...words.map((word) => make('option', {}, word)));
      this.kinds.selectedIndex = marked ? marked.value : -1;
      return;
    }
    this.number.min = String(value.min);
    this.number.max = String(value.max);
    this.number.step = '0.1';
    const text = marked ? String(Number(marked.value.toFixed(3))) : '';
    if (this.number.value !== text) this.number.value = text;
  }
}
