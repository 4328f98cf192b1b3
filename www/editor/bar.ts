/** The buttons for the figures that are edited over the canvas. They replace the caption. */
import { t } from '../words/editor';
import { make, say } from '../base/dom';
import { onSlide } from '../base/slide';
import type { Figure, FigureValue, Sort } from './geometry/figures';

interface BarNeeds {
  choose(word: string): void;
  addFigure(): void;
  addPoint(): void;
  remove(): void;
  turnOver(): void;
  /** `last` is false while the slider still moves. */
  value(value: number, last: boolean): void;
  /** Ends the figure being drawn as it is, or cancels it. */
  finish(): void;
  cancel(): void;
  close(): void;
}

interface BarState {
  marked: Figure | undefined;
  /** The line is smooth at the marked point. */
  smooth: boolean;
  removable: boolean;
  drawing: boolean;
  /** The next drag draws a hole. */
  armed: boolean;
}

const button = (id: string, text = '', title?: string): HTMLButtonElement => make('button', { type: 'button', id, title }, text);

export class EditorBar {
  private readonly bar: HTMLElement;
  private readonly what = make('select', { id: 'edit-what', 'aria-label': t('edited') });
  private readonly addFigure = button('add-figure');
  private readonly addPoint = button('add-point', t('add_point'), t('add_point_title'));
  private readonly turnOver = button('turn-point', '', t('turn_title'));
  private readonly remove = button('remove-point', '', t('remove_title'));
  private readonly name = make('label', { for: 'figure-value' });
  private readonly number = make('input', { type: 'number', id: 'figure-value', inputmode: 'decimal' });
  private readonly slide = make('input', { type: 'range', id: 'figure-slide' });
  private readonly kinds = make('select', { id: 'figure-kind' });
  private readonly tip = make('p', { class: 'tip' });
  private readonly finish = button('draw-finish', t('finish'), t('finish_title'));
  private readonly cancel = button('draw-cancel', t('cancel'), t('cancel_title'));
  private readonly done = button('edit-done', t('done'), t('done_title'));

  constructor(bar: HTMLElement, needs: BarNeeds) {
    this.bar = bar;
    this.what.addEventListener('change', () => needs.choose(this.what.value));
    this.addFigure.addEventListener('click', () => needs.addFigure());
    this.addPoint.addEventListener('click', () => needs.addPoint());
    this.turnOver.addEventListener('click', () => needs.turnOver());
    this.remove.addEventListener('click', () => needs.remove());
    this.number.addEventListener('change', () => needs.value(this.number.valueAsNumber, true));
    onSlide(this.slide, (last) => needs.value(this.slide.valueAsNumber, last));
    this.kinds.addEventListener('change', () => needs.value(this.kinds.selectedIndex, true));
    this.finish.addEventListener('click', () => needs.finish());
    this.cancel.addEventListener('click', () => needs.cancel());
    this.done.addEventListener('click', () => needs.close());
    const { what, tip, addFigure, addPoint, turnOver, kinds, name, number, slide, remove, finish, cancel, done } = this;
    bar.replaceChildren(what, tip, addFigure, addPoint, turnOver, kinds, name, number, slide, remove, finish, cancel, done);
  }

  hide(): void {
    this.bar.hidden = true;
    document.documentElement.toggleAttribute('data-editing', false);
  }

  /** Moves the keyboard focus to the button that adds a figure, or to the choice of sorts. */
  focus(): void {
    (this.addFigure.hidden ? this.what : this.addFigure).focus({ preventScroll: true });
  }

  /** Shows the buttons that fit the sort, and the value of the marked figure. */
  show(sorts: Sort[], sort: Sort, { marked, smooth, removable, drawing, armed }: BarState): void {
    this.bar.hidden = false;
    document.documentElement.toggleAttribute('data-editing', true);
    const words = sorts.map(({ word }) => word).join();
    if (this.what.dataset['words'] !== words) {
      this.what.replaceChildren(...sorts.map(({ word, label }) => make('option', { value: word }, label)));
      this.what.dataset['words'] = words;
    }
    this.what.value = sort.word;
    const busy = drawing || armed;
    const pointwise = sort.form === 'ring' || sort.form === 'line';
    say(this.tip, drawing ? t('tip_drawing') : sort.tip);
    this.tip.hidden = marked !== undefined && !busy;
    this.addFigure.hidden = drawing;
    say(this.addFigure, t('add_figure', { figure: sort.figure }));
    this.addPoint.hidden = !pointwise || busy || !marked;
    this.turnOver.hidden = sort.form !== 'ring' || busy || !marked;
    this.bar.toggleAttribute('data-turns', !this.turnOver.hidden);
    say(this.turnOver, t(smooth ? 'make_corner' : 'make_smooth'));
    const last = !pointwise || (removable && marked !== undefined && marked.points.length <= sort.least);
    say(this.remove, last ? t('remove_figure', { figure: sort.figure }) : t('remove_point'));
    this.remove.hidden = busy || !marked;
    this.remove.disabled = !removable;
    this.finish.hidden = !drawing;
    this.cancel.hidden = !busy;
    this.done.hidden = busy;
    this.showValue(busy ? undefined : sort.value, marked);
  }

  private showValue(value: FigureValue | undefined, marked: Figure | undefined): void {
    const words = value?.words;
    this.kinds.hidden = !words || !marked;
    this.number.hidden = !value || words !== undefined || !marked;
    this.name.hidden = this.slide.hidden = this.number.hidden;
    if (!value || !marked) return;
    say(this.name, value.brief ?? '');
    for (const field of words ? [this.kinds] : [this.number, this.slide]) {
      if (field !== this.number) field.setAttribute('aria-label', value.label);
      field.title = value.label;
    }
    if (words) {
      if (this.kinds.options.length !== words.length) this.kinds.replaceChildren(...words.map((word) => make('option', {}, word)));
      this.kinds.selectedIndex = marked.value;
      return;
    }
    for (const field of [this.number, this.slide]) {
      field.min = String(value.min);
      field.max = String(value.max);
      field.step = String(value.step);
    }
    this.slide.style.setProperty('--place', String((marked.value - value.min) / (value.max - value.min)));
    const text = String(Number(marked.value.toFixed(value.step < 1 ? 3 : 0)));
    if (this.number.value !== text) this.number.value = text;
    if (this.slide.value !== text) this.slide.value = text;
  }
}
