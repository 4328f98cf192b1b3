/**
 * The bar of the model that is open: its name, its size in cells, and what can be done with it. If there are several
 * models, the bar shows the first one.
 */
import type { ModelFacts } from '../../pkg-house/bubblestone.js';
import type { Parameter } from '../module/types';
import { t } from '../words/space';
import { byId, make, say } from '../base/dom';
import { filesOf } from '../state/rules';
import type { Work } from '../state/work';
import { moved, moveOf, readingOf } from './roles';
import { isOther, otherSide, SIDE } from './sides';

export class ModelBar {
  private readonly work: Work;
  private readonly name = make('strong', { id: 'model-name' });
  private readonly size = make('span', { id: 'model-size', role: 'status' });
  private readonly side = make('button', { type: 'button', class: 'key', id: 'model-side' }, t('other_side'));
  private readonly move = make('button', { type: 'button', class: 'key', id: 'model-move' });
  private readonly up = make('div', { class: 'segments', role: 'radiogroup', 'aria-label': t('up') });
  private readonly unit = make('select', { id: 'model-unit' });
  private readonly root: HTMLElement;
  /** The role of the file. */
  private role = '';
  /** The axis that the bar was built for, with its choices. */
  private axes = '';

  /** `choose` opens the browser's dialog for a file of this role. */
  constructor(work: Work, choose: (role: string) => void) {
    this.work = work;
    const another = make('button', { type: 'button', class: 'key', id: 'model-other' }, t('open_another'));
    another.addEventListener('click', () => choose(this.role));
    this.side.addEventListener('click', () => this.turn());
    this.unit.addEventListener('change', () => work.set(this.unit.name, this.unit.value));
    this.move.addEventListener('click', () => work.open(moved(work.engine.link(), work.engine.schema, this.role), { own: true, then: () => work.store.update({ paused: false }) }));
    this.root = make('div', { class: 'model', id: 'model', role: 'group', 'aria-label': t('your_model'), hidden: '' }, this.name, this.size, another, this.move, this.side, this.unit, this.up);
    byId('makes').append(this.root);
  }

  /** Shows the file of the present recipe, or hides the bar if there is none. */
  follow(): void {
    const { engine } = this.work;
    const [file] = filesOf(engine).length ? engine.files() : [];
    const { root } = this;
    root.hidden = file === undefined;
    const button = byId('your-model');
    if (file) button.setAttribute('aria-current', 'true');
    else button.removeAttribute('aria-current');
    if (!file) return;
    this.role = file.role;
    say(this.name, file.name);
    this.name.title = file.name;
    this.measure(engine.askWhole((studio) => studio.modelFacts(), undefined));
    const rows = engine.schema;
    // Without cells there is no such size.
    this.side.hidden = this.size.hidden = !rows.some(({ key }) => key === SIDE);
    this.offerMove(moveOf(rows, file.role));
    const { up, unit } = readingOf(rows, file);
    this.axis(up);
    this.measured(unit);
  }

  private measure(facts: ModelFacts | undefined): void {
    // While the surface is made again, the last size stays.
    if (!facts) return;
    const [width, height, depth] = facts.cells.map((n) => (n < 9.95 ? n.toFixed(1) : n.toFixed(0))) as [string, string, string];
    say(this.size, t('size', { width, height, depth }));
    this.size.title = t('size_title');
    this.side.disabled = !facts.open;
    this.side.title = t(facts.open ? 'other_side_title' : 'one_side');
    this.side.setAttribute('aria-pressed', String(isOther(this.work.engine.get(SIDE))));
  }

  private offerMove(word: ReturnType<typeof moveOf>): void {
    this.move.hidden = word === undefined;
    if (!word) return;
    say(this.move, t(word));
    this.move.title = t(`${word}_title`);
  }

  private axis(row: Parameter | undefined): void {
    this.up.hidden = row === undefined;
    this.root.toggleAttribute('data-up', row !== undefined);
    if (!row) return;
    const now = this.work.engine.get(row.key);
    const axes = [row.key, ...row.choices.map(({ label }) => label)].join();
    if (axes !== this.axes) {
      this.axes = axes;
      this.up.title = row.help;
      this.up.replaceChildren(...row.choices.map(({ word, label }) => this.choice(row.key, word, label)));
    }
    for (const radio of this.up.querySelectorAll('input')) radio.checked = radio.value === now;
  }

  private choice(key: string, word: string, label: string): HTMLElement {
    const radio = make('input', { type: 'radio', name: 'model-up', value: word });
    radio.addEventListener('change', () => this.work.set(key, word));
    return make('label', {}, radio, make('span', {}, t('up_axis', { axis: label })));
  }

  /** Shows the unit of the file. */
  private measured(row: Parameter | undefined): void {
    const { unit } = this;
    unit.hidden = row === undefined;
    if (!row) return;
    // The names are those of the language in force.
    if (unit.title !== row.help) {
      [unit.title, unit.name] = [row.help, row.key];
      unit.setAttribute('aria-label', row.name);
      unit.replaceChildren(...row.choices.map(({ word, label }) => make('option', { value: word }, label)));
    }
    unit.value = this.work.engine.get(row.key);
  }

  private turn(): void {
    const { engine } = this.work;
    const codes = engine.remarks().map(({ code }) => code);
    this.work.set(SIDE, otherSide(engine.get(SIDE), codes));
  }
}
