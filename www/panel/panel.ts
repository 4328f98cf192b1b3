/**
 * The panel: every parameter of the schema as a control, in groups in the order of the pipeline.
 *
 * It is built a few controls per frame while the first cells move. Its layout then has a frame of its own.
 */
import { groupIn, t } from '../words/words';
import { byId, byIdAs, frame, make, say } from '../base/dom';
import { keep, kept } from '../base/storage';
import type { Engine } from '../state/engine';
import { applies, differs, recipeOf, type Recipe } from '../state/rules';
import type { Parameter } from '../module/types';
import { makeControl, SIDE, TYPED, type Change, type Control, type Edit } from './control';
import { picturesOf } from './pictured';

/** Parameters that have their own place on the page. */
const ELSEWHERE = ['seed', 'poly'];

/** Lists of these kinds have tools on the picture: lines are painted there, and blocks are clicked. */
const PAINTED: readonly Parameter['item'][] = ['trace', 'patch', 'feature'];

/** The visitor's choice of how much of the panel is shown. */
const EXTENT = 'panel';

/** Groups that are open at first on a large screen. On a small screen only the panel's first group is. */
const OPEN_AT_FIRST = ['Outline', 'Shape', 'Cells', 'Size', 'Direction', 'Relief'];

/** Milliseconds of building in a frame. */
const SLICE = 8;

interface PanelGroup {
  readonly box: HTMLElement;
  readonly details: HTMLDetailsElement;
  readonly badge: HTMLElement;
  readonly controls: Control[];
  /** Whether it is open while all groups are shown. */
  open: boolean;
}

export class Panel {
  private readonly groups = new Map<string, PanelGroup>();
  /** Which groups were open before the panel was built again. */
  private before = new Map<string, boolean>();
  private readonly form = byIdAs('controls', HTMLFormElement);
  private readonly engine: Engine;
  private recipe: Recipe;
  private readonly rest = byIdAs('rest', HTMLButtonElement);
  private readonly extents = [...byId('extent').querySelectorAll('input')];
  private simple = kept(EXTENT) !== 'all';

  constructor(engine: Engine, private readonly change: Change, private readonly edit: Edit) {
    this.engine = engine;
    this.recipe = recipeOf(engine);
    this.form.addEventListener('submit', (event) => event.preventDefault());
    hintFrom(this.form);
    this.bindExtent();
    for (const radio of this.extents) radio.checked = this.simple === (radio.value === 'simple');
  }

  /**
   * Builds the controls of the present generator, a few per frame, because they take long and the cells move
   * meanwhile.
   */
  async build(): Promise<void> {
    let begin = performance.now();
    this.before = new Map(Array.from(this.groups, ([name, { details, open }]) => [name, this.simple ? open : details.open]));
    this.groups.clear();
    this.recipe = recipeOf(this.engine);
    // Frames have as many pixels as the screen allows, so the side has no control.
    const elsewhere = this.engine.offers('frames') ? [...ELSEWHERE, SIDE] : ELSEWHERE;
    const { generator } = this.engine;
    for (const parameter of this.recipe.schema) {
      if (elsewhere.includes(parameter.key) || PAINTED.includes(parameter.item)) continue;
      const control = makeControl(parameter, this.change, this.edit, picturesOf(generator, parameter.key));
      const group = this.group(parameter.group);
      group.controls.push(control);
      group.details.append(control.element);
      if (performance.now() - begin < SLICE) continue;
      await frame();
      begin = performance.now();
    }
  }

  /** Puts the controls on the page, once all of them are complete. */
  attach(): void {
    this.form.replaceChildren(...Array.from(this.groups.values(), ({ box }) => box));
  }

  private bindExtent(): void {
    const take = (extent: string): void => {
      keep(EXTENT, extent);
      this.simple = extent === 'simple';
      for (const group of this.groups.values()) {
        if (this.simple) group.open = group.details.open;
        group.details.open = this.simple || group.open;
      }
      this.refresh();
    };
    for (const radio of this.extents) radio.addEventListener('change', () => take(radio.value));
    this.rest.addEventListener('click', () => {
      const all = this.extents.find(({ value }) => value === 'all');
      all?.click();
      all?.focus();
    });
  }

  /** Appends an element to a group. */
  append(group: string, element: HTMLElement): void {
    this.groups.get(group)?.details.append(element);
  }

  /** The groups' names with the elements that hold them. */
  *groupings(): Iterable<[name: string, element: HTMLElement]> {
    for (const [name, { box }] of this.groups) yield [name, box];
  }

  /** Shows the engine's values, which controls apply, and how many differ from the default. */
  refresh(): void {
    let apart = 0;
    for (const { box, controls, badge, details } of this.groups.values()) {
      let changed = 0;
      for (const control of controls) {
        const { parameter, element } = control;
        const value = this.valueOf(parameter);
        const standard = this.recipe.defaultOf(parameter);
        control.show(value, standard);
        const active = applies(parameter, this.recipe);
        const shown = !this.simple || parameter.main;
        element.hidden = !active || !shown;
        if (!active || !differs(parameter, value, standard)) continue;
        changed += 1;
        if (!shown) apart += 1;
      }
      say(badge, changed ? t('changed', { n: changed }) : '');
      details.hidden = controls.every(({ element }) => element.hidden);
      box.toggleAttribute('data-empty', details.hidden);
    }
    this.rest.hidden = !this.simple;
    say(this.rest, apart ? t('rest_changed', { n: apart }) : t('rest'));
    byId('panel').dataset['extent'] = this.simple ? 'simple' : 'all';
  }

  /** A parameter's value as its control shows it: lists that are typed in numbers. */
  private valueOf({ key, item }: Parameter): string {
    return TYPED.includes(item) ? this.engine.list(key).map((row) => row.join()).join(';') : this.engine.get(key);
  }

  private group(name: string): PanelGroup {
    const known = this.groups.get(name);
    if (known) return known;
    const badge = make('span', { class: 'badge' });
    const details = make('details', { class: 'group' }, make('summary', {}, make('span', {}, groupIn(name)), badge));
    const narrow = matchMedia('(max-width: 60rem)').matches;
    const open = this.before.get(name) ?? (narrow ? this.groups.size === 0 : OPEN_AT_FIRST.includes(name));
    details.open = this.simple || open;
    const group = { box: make('div', { class: 'grouping' }, details), details, badge, controls: [], open };
    this.groups.set(name, group);
    return group;
  }
}

/** Shows the help of the control under the pointer or the keyboard, in one line at the panel's foot. */
function hintFrom(form: HTMLFormElement): void {
  const hint = byId('hint');
  const show = (event: Event): void => {
    const control = event.target instanceof Element ? event.target.closest('.option, .control') : null;
    say(hint, control?.querySelector('[id$="-help"]')?.textContent ?? '');
  };
  form.addEventListener('pointerover', show);
  form.addEventListener('focusin', (event) => {
    show(event);
    // Not every browser scrolls to an element that is covered by the help.
    if (event.target instanceof Element && event.target.matches(':focus-visible')) event.target.scrollIntoView({ block: 'nearest' });
  });
  form.addEventListener('pointerleave', () => say(hint, ''));
  form.addEventListener('focusout', () => say(hint, ''));
}
