/** Another recipe under the one that is shown, up to a divider; it is made by an engine of its own in idle moments. */
import { isEnd } from '../module/stages';
import { t } from '../words/look';
import { byId, idle, make, say } from '../base/dom';
import { notice } from '../base/messages';
import { Arrivals } from '../state/arrivals';
import { Engine } from '../state/engine';
import type { Store } from '../state/store';
import type { Work } from '../state/work';
import type { View } from '../picture/view';
import '../styles/late/compare.css';
import '../styles/late/look.css';

/** Milliseconds of work in one idle slice, and between two drawings of work in progress. */
const SLICE = 6;
const DRAWINGS = 150;

/** What the shown recipe is compared with: itself with one value changed. */
const VARIANTS = { voronoi: ['cells', 'voronoi'], lloyd: ['cells', 'lloyd'], packed: ['cells', 'packed'], quadtree: ['start', 'quadtree'] } as const;
const CHOICES = ['voronoi', 'lloyd', 'packed', 'quadtree', 'before', 'link'] as const;

export class Compare {
  private readonly work: Work;
  private readonly store: Store;
  private readonly view: View;
  private readonly sheet = byId('sheet');
  private readonly canvas = make('canvas', { class: 'other', 'aria-hidden': 'true' });
  private readonly divider = make('input', { type: 'range', id: 'divider', min: '0', max: '100', step: '1', value: '50', 'aria-label': t('compare_divider') });
  private readonly choice = make('select', { id: 'compare-with', 'aria-label': t('compare_with') });
  private readonly link = make('input', { type: 'text', id: 'compare-link', 'aria-label': t('compare_link_label'), placeholder: t('compare_link_label'), autocomplete: 'off', spellcheck: 'false' });
  private readonly progress = make('span', { class: 'compare-progress', role: 'status' });
  private readonly tools: HTMLElement[];
  /** The recipe when the comparison began. */
  private before = '';
  private engine: Engine | undefined;
  private readonly arrivals = new Arrivals();
  /** What the other engine works on. */
  private wanted = '';
  private waiting = false;
  /** A drawing is made in pieces, before there is more work. */
  private owed = false;
  private drawn = 0;

  constructor(work: Work, view: View) {
    this.work = work;
    this.store = work.store;
    this.view = view;
    this.choice.append(...CHOICES.map((word) => make('option', { value: word }, t(`compare_${word}`))));
    const end = make('button', { type: 'button', class: 'key', id: 'compare-end', 'aria-label': t('compare_end'), title: t('compare_end') }, '×');
    end.addEventListener('click', () => this.end());
    const left = make('div', { class: 'compare-left' }, this.choice, this.link, this.progress);
    const right = make('div', { class: 'compare-right' }, make('span', { class: 'compare-name' }, t('compare_own')), end);
    this.tools = [left, right, make('div', { class: 'compare-line' }), this.divider];
    byId('cells').before(this.canvas);
    this.sheet.append(...this.tools);
    this.divider.addEventListener('input', () => this.slide());
    this.choice.addEventListener('change', () => this.choose());
    this.link.addEventListener('change', () => this.follow());
    this.sheet.addEventListener('keydown', ({ key }) => key === 'Escape' && this.store.state.compare && this.end());
    this.store.on(['recipe', 'held'], () => this.follow());
    this.store.on(['view', 'overlays'], () => this.paint());
    this.store.on(['stage', 'paused'], () => this.wake());
    document.addEventListener('visibilitychange', () => this.wake());
    this.slide();
  }

  show(on: boolean): void {
    for (const element of [this.canvas, ...this.tools]) element.hidden = !on;
    this.sheet.toggleAttribute('data-comparing', on);
    if (on) {
      this.before = this.store.state.recipe;
      if (this.store.state.repeat > 1) this.store.update({ repeat: 1 });
      this.choose();
      this.divider.focus({ preventScroll: true });
    } else this.stop();
  }

  private end(): void {
    this.store.update({ compare: false });
    byId('compare-button').focus();
  }

  private stop(): void {
    this.arrivals.cancel();
    this.engine?.free();
    this.engine = undefined;
    this.wanted = '';
  }

  private choose(): void {
    this.link.hidden = this.choice.value !== 'link';
    if (!this.link.hidden && this.link.value === '') return this.link.focus();
    this.follow();
  }

  private slide(): void {
    const at = this.divider.valueAsNumber;
    this.sheet.style.setProperty('--divider', String(at / 100));
    this.divider.setAttribute('aria-valuetext', t('compare_said', { n: at }));
  }

  /** The other recipe as it should be now; what is in the hand is waited for. */
  private follow(): void {
    const { compare, held, recipe } = this.store.state;
    if (!compare || held) return;
    const word = this.choice.value as (typeof CHOICES)[number];
    const base = word === 'before' ? this.before : word === 'link' ? this.link.value.replace(/^[^#]*#/, '').trim() : recipe;
    const variant = word === 'before' || word === 'link' ? undefined : VARIANTS[word];
    const wanted = [base, ...(variant ?? [])].join(' ');
    if (wanted === this.wanted) return;
    this.wanted = wanted;
    this.arrivals.reach(base, () => {
      this.engine ??= new Engine(base, () => this.failed());
      const said = this.engine.open(base);
      if (variant) this.engine.set(variant[0], variant[1]);
      if (word === 'link') notice('link', ...said);
      this.drawn = 0;
      this.wake();
    });
  }

  /** The other engine failed; what is shown goes on. */
  private failed(): void {
    this.engine = undefined;
    say(this.progress, t('compare_failed'));
  }

  /** Goes on in an idle moment. */
  private wake(): void {
    const { engine } = this;
    if (!engine) return;
    if (!isEnd(engine.stage())) say(this.progress, t('compare_working'));
    if (this.waiting) return;
    this.waiting = true;
    void idle(50).then(() => {
      this.waiting = false;
      this.goOn();
    });
  }

  /** Works as long as the shown picture needs no work and the page is seen; what is finished is drawn before it is said to be. */
  private goOn(): void {
    const { engine } = this;
    if (!engine || document.hidden) return;
    const works = !isEnd(engine.stage());
    if (works && !this.resting()) return;
    if (works && !this.owed) engine.tick(SLICE, 100_000);
    // Its failure was told.
    if (this.engine !== engine) return;
    const ended = isEnd(engine.stage());
    const due = ended || performance.now() >= this.drawn;
    this.owed = due && !engine.prepare(this.view.words, SLICE);
    if (due && !this.owed) this.paint();
    if (ended && !this.owed) say(this.progress, engine.problem());
    else this.wake();
  }

  private resting(): boolean {
    return this.store.state.paused || isEnd(this.work.engine.stage());
  }

  private paint(): void {
    const { engine, canvas } = this;
    const context = engine && canvas.getContext('2d');
    if (!context) return;
    const side = engine.side();
    if (canvas.width !== side) canvas.width = canvas.height = side;
    engine.draw(context, this.view.words);
    this.drawn = performance.now() + DRAWINGS;
  }
}
