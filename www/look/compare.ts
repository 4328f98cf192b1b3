/** Compares another recipe with the page's own: under a divider, or side by side. */
import { t } from '../words/look';
import { groupIn } from '../words/words';
import { byId, make, say } from '../base/dom';
import { notice } from '../base/messages';
import { shape } from '../late/svg';
import { Arrivals } from '../state/arrivals';
import type { Engine } from '../state/engine';
import type { Store } from '../state/store';
import type { Work } from '../state/work';
import type { Loop } from '../picture/loop';
import { PictureHost } from '../picture/host';
import type { View } from '../picture/view';
import { Beside } from './beside';
import { Under } from './under';
import type { Way } from './way';
import '../styles/late/compare.css';
import '../styles/late/look.css';

/** Variants of the page's recipe: each changes one value. */
const VARIANTS = { voronoi: ['cells', 'voronoi'], lloyd: ['cells', 'lloyd'], packed: ['cells', 'packed'], quadtree: ['start', 'quadtree'] } as const;
type Variant = keyof typeof VARIANTS;
const THIS = ['voronoi', 'lloyd', 'packed', 'quadtree', 'before'] as const;

/** Marks the name of a preset in the list. */
const PRESET = 'preset:';

/** Elements where Escape has another meaning. */
const NOT_HERE = 'dialog, select, [type=text], #layers, #layers-button, .light-layer, .light-kinds, .edit-tools';

export class Compare {
  private readonly work: Work;
  private readonly store: Store;
  private readonly view: View;
  private readonly under: Under;
  private readonly beside: Beside;
  private readonly sheet = byId('sheet');
  private readonly choice = make('select', { id: 'compare-with', 'aria-label': t('compare_with') });
  private readonly link = make('input', { type: 'text', id: 'compare-link', 'aria-label': t('compare_link_label'), placeholder: t('compare_link_label'), autocomplete: 'off', spellcheck: 'false' });
  private readonly progress = make('span', { class: 'compare-progress', role: 'status' });
  private readonly way = make('button', { type: 'button', class: 'key', id: 'compare-beside', 'aria-pressed': 'false', 'aria-label': t('compare_beside'), title: t('compare_beside') });
  private readonly left = make('div', { class: 'compare-left' }, this.choice, this.link, this.progress);
  private readonly right = make('div', { class: 'compare-right' });
  /** The page's recipe when the comparison began. */
  private before = '';
  private readonly canvas = make('canvas', { class: 'other' });
  private host: PictureHost | undefined;
  private readonly arrivals = new Arrivals();
  /** The choice and the recipe that the second engine works on. */
  private wanted = '';
  /** The generator whose presets are listed. */
  private listed = '';

  constructor(work: Work, view: View, loop: Loop) {
    this.work = work;
    this.store = work.store;
    this.view = view;
    const end = make('button', { type: 'button', class: 'key', id: 'compare-end', 'aria-label': t('compare_end'), title: t('compare_end') }, '×');
    end.addEventListener('click', () => this.end());
    this.way.append(shape('svg', { viewBox: '0 0 20 20', 'aria-hidden': 'true' }, shape('path', { 'fill-rule': 'evenodd', d: 'M2 4.500h7v11H2zm1.700 1.700v7.600h3.600V6.200zM11 4.500h7v11h-7zm1.700 1.700v7.600h3.600V6.200z' })));
    this.way.addEventListener('click', () => this.store.update({ beside: !this.store.state.beside }));
    this.right.append(make('span', { class: 'compare-name' }, t('compare_own')), this.way, end);
    this.under = new Under(work, this.canvas, this.progress);
    this.beside = new Beside(work, view, loop, this.canvas);
    this.sheet.append(this.left, this.right);
    this.choice.addEventListener('change', () => this.choose());
    this.link.addEventListener('change', () => this.follow(true));
    document.addEventListener('keydown', (event) => this.key(event));
    this.store.on(['recipe', 'held'], () => this.follow());
    this.store.on(['recipe', 'held', 'camera', 'cut'], () => this.host?.moved());
    this.store.on(['view', 'overlays'], () => this.host?.loop.redraw());
    this.store.on(['beside'], () => this.store.state.compare && this.lay());
  }

  show(on: boolean): void {
    for (const element of [this.canvas, this.left, this.right]) element.hidden = !on;
    if (!on) return this.stop();
    this.before = this.store.state.recipe;
    if (this.store.state.repeat > 1) this.store.update({ repeat: 1 });
    this.list();
    this.lay();
    if (this.store.state.beside) this.choice.focus({ preventScroll: true });
  }

  private end(): void {
    this.store.update({ compare: false });
    byId('compare-button').focus();
  }

  private stop(): void {
    this.arrivals.cancel();
    this.sheet.toggleAttribute('data-comparing', false);
    this.under.show(false);
    this.beside.show(false);
    this.sheet.append(this.left);
    this.host?.free();
    this.host = undefined;
    this.wanted = '';
  }

  /** Lays the comparison out in the chosen way and starts the chosen recipe anew. */
  private lay(): void {
    const { beside } = this.store.state;
    this.way.setAttribute('aria-pressed', String(beside));
    this.sheet.toggleAttribute('data-comparing', !beside);
    this.under.show(!beside);
    this.beside.show(beside);
    (beside ? this.beside.sheet : this.sheet).append(this.left);
    say(this.progress, '');
    this.wanted = '';
    this.choose();
  }

  /** Fills the list: variants of the page's recipe, a link, and the presets in their groups. */
  private list(): void {
    const { generator, presets } = this.work.engine;
    if (this.listed === generator.word) return;
    this.listed = generator.word;
    const option = (value: string, name: string): HTMLElement => make('option', { value }, name);
    const groups = [...new Set(presets.map(({ group }) => group))].map((title) =>
      make('optgroup', { label: groupIn(title) }, ...presets.filter(({ group }) => group === title).map(({ name, title, figure }) => option(`${PRESET}${name}`, figure || title))),
    );
    // Only variants by parameters of this generator.
    const rows = this.work.engine.schema;
    const has = (word: string): boolean => !(word in VARIANTS) || rows.some(({ key, choices }) => key === VARIANTS[word as Variant][0] && choices.some((choice) => choice.word === VARIANTS[word as Variant][1]));
    const own = THIS.filter(has).map((word) => option(word, t(`compare_${word}`)));
    this.choice.replaceChildren(make('optgroup', { label: t('compare_this') }, ...own), option('link', t('compare_link')), ...groups);
    // A preset is not compared with itself.
    const { preset } = this.store.state;
    const other = own.length > 1 ? undefined : presets.find(({ name }) => name !== preset?.shown.name);
    if (other) this.choice.value = `${PRESET}${other.name}`;
  }

  private choose(): void {
    this.link.hidden = this.choice.value !== 'link';
    if (!this.link.hidden && this.link.value === '') return this.link.focus();
    this.follow(true);
  }

  private key({ key, target, defaultPrevented }: KeyboardEvent): void {
    const { compare, beside, editing } = this.store.state;
    if (key !== 'Escape' || !compare || editing !== undefined || defaultPrevented || !(target instanceof Element)) return;
    // Escape on the picture ends a comparison under a divider; Escape anywhere ends one side by side.
    if (beside ? !target.closest(NOT_HERE) : this.sheet.contains(target)) this.end();
  }

  /** Updates the second recipe. It waits for the end of a drag; side by side, the second picture follows changes by itself. */
  private follow(chosen = false): void {
    const { compare, beside, held, recipe } = this.store.state;
    if (!compare || held) return;
    const { value } = this.choice;
    const variant = value in VARIANTS ? VARIANTS[value as Variant] : undefined;
    const base = this.baseOf(value) ?? (beside && !chosen ? undefined : recipe);
    if (base === undefined) return;
    const wanted = [value, base].join(' ');
    if (wanted === this.wanted) return;
    this.wanted = wanted;
    this.arrivals.reach(base, () => {
      const host = (this.host ??= this.hostOf(base));
      const said = host.open(base);
      if (variant) host.engine.set(variant[0], variant[1]);
      host.changed();
      if (value === 'link') notice('link', ...said);
      this.chosen.take(host, this.titleOf(value, host.engine));
    });
  }

  private hostOf(link: string): PictureHost {
    this.canvas.hidden = false;
    return new PictureHost(link, {
      canvas: this.canvas,
      view: () => this.view.words,
      camera: () => this.store.state.camera,
      cut: () => this.store.state.cut,
      held: () => this.store.state.held,
      worked: (stage) => this.chosen.worked(stage),
      crashed: () => this.failed(),
    });
  }

  private get chosen(): Way {
    return this.store.state.beside ? this.beside : this.under;
  }

  /** The chosen recipe; undefined for a variant of the page's recipe. */
  private baseOf(value: string): string | undefined {
    if (value === 'before') return this.before;
    if (value === 'link') return this.link.value.replace(/^[^#]*#/, '').trim();
    return this.work.engine.presets.find(({ name }) => value === `${PRESET}${name}`)?.link.replace(/^#/, '');
  }

  private titleOf(value: string, engine: Engine): string {
    if (value !== 'link') return this.choice.selectedOptions[0]?.text ?? '';
    const known = engine.presets.find(({ link }) => link.replace(/^#/, '') === engine.link());
    return known ? known.figure || known.title : t('compare_theirs');
  }

  /** The second engine failed; the page's own picture goes on. */
  private failed(): void {
    this.host?.free();
    this.host = undefined;
    this.canvas.hidden = true;
    this.under.show(false);
    this.beside.show(false);
    this.sheet.append(this.left);
    this.sheet.toggleAttribute('data-comparing', true);
    say(this.progress, t('compare_failed'));
  }
}
