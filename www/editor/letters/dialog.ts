/** The dialog for letters as the outline. It previews them in stones, and names problems and limits. */
import type { Ring } from '../../module/types';
import { t } from '../../words/editor';
import { language } from '../../words/words';
import { make, say } from '../../base/dom';
import { dialogOf } from '../../late/dialog';
import { shape } from '../../late/svg';
import type { Engine } from '../../state/engine';
import { drawn } from '../geometry/figures';
import { LettersQueue } from './queue';
import { FACES, MOST_LETTERS, MOST_POINTS, type Face, type Letters } from './painted';
import { Preview } from './preview';
import '../../styles/late/outline-dialog.css';
import '../../styles/late/letters.css';

/** Cells across a stroke: least, most, step and initial value. */
const ACROSS = { min: 1, max: 8, step: 0.5, first: 3.5 };

/** Sides of the picture, and the largest that is chosen automatically: twice the side is four times the work. */
const SIDES = [512, 1024, 2048];
const LARGEST = 1024;

/** Cells smaller than this, in pixels, hardly look like stones. */
const SMALL = 4;

/** If the outline touches itself, it is made again up to this many times finer. */
const FINEST = 4;

/** The wait after the last change of the text, in milliseconds. */
const SETTLED = 150;

/** The last choices, kept until the visitor leaves the page. */
const last = { text: 'B', face: 'serif' as Face, across: ACROSS.first, follows: true };

type Values = [key: string, text: string][];

interface LettersNeeds {
  readonly engine: Engine;
  /**
   * Takes rings, with lengths in sides of the picture, and parameters as one step. Returns the reason of a refusal,
   * or ''.
   */
  take(rings: Ring[], values: Values): string;
}

export function textDialog(needs: LettersNeeds): void {
  new LettersDialog(needs);
}

class LettersDialog {
  private readonly needs: LettersNeeds;
  private readonly word = make('textarea', { id: 'letters', rows: '2', spellcheck: 'false', 'aria-describedby': 'letters-facts letters-trouble' });
  private readonly face = make('select', { id: 'face' }, ...(Object.keys(FACES) as Face[]).map((key) => make('option', { value: key }, t(`face_${key}`))));
  private readonly follows = make('input', { type: 'checkbox', id: 'letters-follow' });
  private readonly across = make('input', { type: 'range', id: 'letters-across', min: String(ACROSS.min), max: String(ACROSS.max), step: String(ACROSS.step) });
  private readonly acrossNow = make('output', { for: 'letters-across' });
  private readonly side: HTMLSelectElement;
  private readonly path = shape('path');
  private readonly canvas = make('canvas', { role: 'img' });
  private readonly facts = make('p', { class: 'count', id: 'letters-facts', role: 'status' });
  private readonly trouble = make('div', { class: 'letters-trouble', id: 'letters-trouble', role: 'alert' });
  private readonly use = make('button', { type: 'button', id: 'take-letters', class: 'key', title: t('use_text_title') }, t('use_text'));
  private readonly dialog: HTMLDialogElement;
  private readonly preview: Preview;
  private readonly asked = new LettersQueue((letters) => this.came(letters), (reason) => this.broke(reason));
  private timer = 0;
  private finer = 1;
  /** `stale`: the letters do not yet match the fields. `taking`: take the letters as soon as they match. */
  private stale = true;
  private taking = false;
  private now: Letters | undefined;
  /** The visitor has chosen the picture's side. */
  private chosen = false;
  private values: Values = [];
  /** The sentences below the facts: about the letters, and about the stones. */
  private said: string[] = [];

  constructor(needs: LettersNeeds) {
    this.needs = needs;
    const { engine } = needs;
    const own = engine.side();
    this.side = make('select', { id: 'letters-side' }, ...[...new Set([own, ...SIDES.filter((side) => side > own)])].map((side) => make('option', { value: String(side) }, t('text_px', { n: number(side) }))));
    this.canvas.hidden = true;
    this.word.value = last.text;
    this.face.value = last.face;
    this.across.value = String(last.across);
    this.across.style.setProperty('--default', String(placeOf(ACROSS.first)));
    this.follows.checked = last.follows;
    this.preview = new Preview(this.canvas, engine.link(), (problem, done) => this.worked(problem, done), () => this.broke(t('text_no_preview')));
    const close = make('button', { type: 'button', id: 'leave-letters', class: 'key' }, t('cancel'));
    const sheet = shape('svg', { viewBox: '0 0 1 1', 'aria-hidden': 'true' }, this.path);
    const label = (to: string, text: string): HTMLElement => make('label', { for: to }, text);
    const fields = make(
      'div',
      { class: 'fields' },
      ...[label('letters', t('text_word')), this.word, label('face', t('text_face')), this.face],
      make('label', { class: 'check' }, this.follows, make('span', {}, t('text_follow'))),
      ...[label('letters-across', t('text_across')), make('div', { class: 'across' }, this.across, this.acrossNow)],
      ...[label('letters-side', t('text_side')), this.side],
    );
    this.dialog = dialogOf(
      'text-dialog',
      'outline-dialog letters-dialog',
      t('text_title'),
      make('figure', {}, sheet, this.canvas),
      make('div', { class: 'letters-side' }, fields, this.facts, this.trouble, make('div', { class: 'row' }, this.use, close)),
    );
    close.addEventListener('click', () => this.dialog.close());
    this.listen();
    this.word.select();
    this.ask();
  }

  private listen(): void {
    const { dialog, word, face, follows, across, side, use } = this;
    word.addEventListener('input', () => {
      this.age();
      this.timer = window.setTimeout(() => this.ask(), SETTLED);
    });
    face.addEventListener('change', () => this.ask());
    follows.addEventListener('change', () => this.fit());
    across.addEventListener('input', () => this.fit());
    side.addEventListener('change', () => {
      this.chosen = true;
      this.fit();
    });
    use.addEventListener('click', () => this.take());
    dialog.addEventListener('keydown', (event) => {
      if (event.key !== 'Enter' || event.isComposing || !(event.ctrlKey || event.metaKey)) return;
      event.preventDefault();
      this.take();
    });
    dialog.addEventListener('close', () => {
      clearTimeout(this.timer);
      this.asked.end();
      this.preview.end();
    });
  }

  private age(): void {
    clearTimeout(this.timer);
    this.stale = true;
    delete this.dialog.dataset['stage'];
  }

  /** The text or its typeface changed. */
  private ask(finer = 1): void {
    this.age();
    last.text = this.word.value;
    last.face = this.face.value as Face;
    this.finer = finer;
    if (last.text.trim() === '') {
      this.asked.forget();
      return this.nothing(t('text_none'));
    }
    this.asked.ask({ text: last.text, face: last.face, finer });
  }

  private came(letters: Letters): void {
    if (this.word.value !== last.text) return;
    this.stale = false;
    this.now = letters;
    const points = letters.rings.flat().length;
    if (!points) return this.nothing(t('text_unseen'));
    this.canvas.setAttribute('aria-label', t('text_preview', { lines: letters.lines.join(' / ') }));
    this.path.setAttribute('d', letters.rings.map((ring) => drawn('ring', ring)).join(''));
    if (points > MOST_POINTS) return this.refuse([t('text_many', { n: number(points), most: number(MOST_POINTS) }), ...this.remarks(letters)]);
    this.fit();
  }

  /** Sets the size of the cells, and shows the outline filled with stones. */
  private fit(): void {
    const { now } = this;
    last.across = this.across.valueAsNumber;
    last.follows = this.follows.checked;
    this.across.disabled = !last.follows;
    this.across.style.setProperty('--place', String(placeOf(last.across)));
    this.across.setAttribute('aria-valuetext', t('text_cells', { n: number(last.across) }));
    say(this.acrossNow, number(last.across));
    if (!now?.rings.length || now.rings.flat().length > MOST_POINTS) return;
    if (!this.chosen) this.side.value = String(this.roomFor(now.stroke));
    const side = Number(this.side.value);
    const wanted = (now.stroke * side) / last.across;
    this.values = [['size', String(side)], ['cs', last.follows ? rounded(wanted) : this.needs.engine.get('cs')]];
    delete this.dialog.dataset['stage'];
    const { refused, sentences } = this.preview.show(now.rings, this.values);
    if (refused && this.finer < FINEST) return this.ask(2 * this.finer);
    if (refused) return this.refuse([...sentences, t('text_refused')]);
    const { cells, count, isCoarse } = this.preview;
    const coarse = isCoarse ? [t('text_coarse', { n: number(Number(count.toPrecision(2))) })] : [];
    const facts = { points: number(now.rings.flat().length), stroke: number(now.stroke * side), cells: number(cells), across: number((now.stroke * side) / cells) };
    this.show(t('text_facts', facts), [...sentences, ...this.remarks(now), ...this.small(cells, wanted), ...coarse]);
    this.use.disabled = false;
    if (this.taking) this.take();
  }

  /** The least side of a picture in which cells are large enough for stones. */
  private roomFor(stroke: number): number {
    const own = this.needs.engine.side();
    const sides = [own, ...SIDES.filter((side) => side > own && side <= LARGEST)];
    const fits = (side: number): boolean => (stroke * side) / last.across >= SMALL;
    return (last.follows ? (sides.find(fits) ?? sides.at(-1)) : own) ?? own;
  }

  /** Sentences on letters that were left out or cut off. */
  private remarks({ given, specks }: Letters): string[] {
    const cut = given > MOST_LETTERS ? [t('text_cut', { most: number(MOST_LETTERS), n: number(given) })] : [];
    return [...cut, ...(specks ? [t(specks === 1 ? 'text_speck' : 'text_specks', { n: number(specks) })] : [])];
  }

  private small(cells: number, wanted: number): string[] {
    if (last.follows && wanted < cells * 0.95 && wanted < SMALL) return [t('text_least', { n: number(cells) }), ...this.larger()];
    return cells < SMALL ? [t('text_small', { n: number(SMALL) }), ...this.larger()] : [];
  }

  /** A sentence that offers a larger picture. */
  private larger(): string[] {
    return [this.side.selectedIndex + 1 < this.side.options.length ? t('text_larger') : t('text_fewer')];
  }

  /** Shows that there is no outline, and why. */
  private nothing(sentence: string): void {
    this.taking = false;
    this.now = undefined;
    this.path.setAttribute('d', '');
    this.canvas.hidden = true;
    this.use.disabled = true;
    this.show(sentence, []);
  }

  private refuse(sentences: string[]): void {
    this.taking = false;
    this.canvas.hidden = true;
    this.use.disabled = true;
    this.show('', sentences);
  }

  /** The preview has done a slice of work. */
  private worked(problem: string, done: boolean): void {
    if (done) this.dialog.dataset['stage'] = problem ? 'error' : 'done';
    if (problem && !this.said.includes(problem)) this.show(this.facts.textContent, [problem, ...this.said]);
  }

  private broke(reason: string): void {
    this.show(this.facts.textContent, [reason]);
  }

  private show(facts: string, said: string[]): void {
    say(this.facts, facts);
    if (said.join() !== this.said.join()) this.trouble.replaceChildren(...said.map((sentence) => make('p', {}, sentence)));
    this.said = said;
  }

  private take(): void {
    const { now, use } = this;
    this.taking = this.stale;
    if (this.stale) return this.ask();
    if (use.disabled || !now) return;
    const why = this.needs.take(now.rings, this.values);
    if (why) this.refuse([why, t('text_refused')]);
    else this.dialog.close();
  }
}

/** The text of a cell size. */
function rounded(size: number): string {
  return size.toFixed(size < 10 ? 1 : 0);
}

/** The place of a number of cells on its slider. */
function placeOf(across: number): number {
  return (across - ACROSS.min) / (ACROSS.max - ACROSS.min);
}

/** The number in the page's language, with one decimal if it is small. */
function number(value: number): string {
  return value.toLocaleString(language(), { maximumFractionDigits: value < 20 ? 1 : 0 });
}
