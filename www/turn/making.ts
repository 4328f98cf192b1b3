/** How one body is made: a strip under the frame that steps through it. */
import { t } from '../words/turn';
import { make, say } from '../base/dom';
import { shape } from '../late/svg';
import { areOfBlock, areOfMap, ownNote, stepName, stepNote } from './told';
import type { BodyInfo } from '../picture/frames/source';

/** The connection of the strip to the turntable. */
export interface Steps {
  /** The value of a parameter of the recipe. */
  get(key: string): string;
  /** Shows the chosen step. */
  show(): void;
  /** Shows all bodies again. */
  end(): void;
}

export class Making {
  readonly strip = make('section', { class: 'turn-making', 'aria-labelledby': 'turn-making-title' });
  private readonly steps: Steps;
  private readonly title = make('h2', { id: 'turn-making-title' });
  private readonly name = make('strong');
  private readonly count = make('span');
  private readonly note = make('p', { class: 'turn-note', 'aria-live': 'polite' });
  private readonly dots = make('div', { class: 'turn-dots' });
  private readonly back = arrow('turn-back', t('back'), 'M12.600 4.200 6.800 10l5.800 5.800 1.400-1.400L9.600 10 14 5.600z');
  private readonly on = arrow('turn-on', t('on'), 'M7.400 4.200 13.200 10l-5.800 5.800L6 14.400 10.400 10 6 5.600z');
  private body: BodyInfo | undefined;
  private at = 0;

  constructor(steps: Steps) {
    this.steps = steps;
    const all = make('button', { type: 'button', class: 'key', id: 'turn-all' }, t('all'));
    all.addEventListener('click', () => steps.end());
    this.back.addEventListener('click', () => this.go(-1));
    this.on.addEventListener('click', () => this.go(1));
    this.strip.append(
      make('div', { class: 'turn-head' }, this.title, all),
      make('div', { class: 'turn-ways' }, this.back, make('div', {}, make('p', { class: 'turn-step' }, this.name, ' ', this.count), this.dots), this.on),
      this.note,
    );
    this.strip.hidden = true;
    this.strip.addEventListener('keydown', (event) => this.key(event));
    // Events here are not for the picture below.
    for (const sign of ['click', 'dblclick', 'pointerdown', 'pointermove', 'touchstart']) this.strip.addEventListener(sign, (event) => event.stopPropagation());
  }

  /** The subject of the frame: `ID:STEP`; '' while all bodies are shown. */
  get subject(): string {
    return this.body ? `${this.body.id}:${this.at}` : '';
  }

  /** The shown step in a sentence. */
  get seen(): string {
    const step = this.body?.steps[this.at] ?? '';
    return t('seen_one', { what: this.called, n: this.at + 1, all: this.body?.steps.length ?? 0, step: stepName(step) });
  }

  /** Shows a step of a body. */
  begin(body: BodyInfo, step: number): void {
    this.body = body;
    this.at = step;
    const dots = body.steps.map((step, k) => {
      const dot = make('button', { type: 'button', class: 'turn-dot', 'aria-label': stepName(step), title: stepName(step) });
      dot.addEventListener('click', () => this.go(k - this.at));
      return dot;
    });
    this.dots.replaceChildren(...dots);
    say(this.title, t(this.titled(body.steps), { id: body.id }));
    this.strip.hidden = false;
    this.tell();
    this.on.focus({ preventScroll: true });
  }

  end(): void {
    this.body = undefined;
    this.strip.hidden = true;
  }

  /** Goes a number of steps forward or back. */
  go(by: number): void {
    const last = (this.body?.steps.length ?? 1) - 1;
    const next = Math.min(last, Math.max(0, this.at + by));
    if (next === this.at) return;
    this.at = next;
    this.tell();
  }

  /** Handles the keys of the steps; true if `key` is one of them. */
  step(key: string): boolean {
    if (!this.body || (key !== ',' && key !== '.')) return false;
    this.go(key === ',' ? -1 : 1);
    return true;
  }

  private titled(steps: readonly string[]): 'made_map' | 'made_block' | 'made_scale' | 'made_stone' {
    if (areOfMap(steps)) return 'made_map';
    if (areOfBlock(steps)) return 'made_block';
    return this.steps.get('stone') === 'skin' ? 'made_scale' : 'made_stone';
  }

  private get called(): string {
    const steps = this.body?.steps ?? [];
    if (areOfMap(steps)) return t('map');
    if (areOfBlock(steps)) return t('block', { id: this.body?.id ?? '' });
    return t(this.steps.get('stone') === 'skin' ? 'scale' : 'stone', { id: this.body?.id ?? '' });
  }

  private tell(): void {
    const { body, at } = this;
    if (!body) return;
    const step = body.steps[at] ?? '';
    const skin = this.steps.get('stone') === 'skin';
    say(this.name, stepName(step));
    say(this.count, t('at', { n: at + 1, all: body.steps.length }));
    const own = ownNote(step, body.steps);
    say(this.note, own || t('cited', { note: stepNote(step, (key) => this.steps.get(key)), paper: t(skin ? 'paper_skin' : 'paper_stone') }));
    [...this.dots.children].forEach((dot, k) => {
      if (k === at) dot.setAttribute('aria-current', 'step');
      else dot.removeAttribute('aria-current');
    });
    // A disabled button would lose the focus; these only announce that they are disabled.
    this.back.setAttribute('aria-disabled', String(at === 0));
    this.on.setAttribute('aria-disabled', String(at === body.steps.length - 1));
    this.steps.show();
  }

  private key(event: KeyboardEvent): void {
    const { key, ctrlKey, metaKey, altKey } = event;
    if (ctrlKey || metaKey || altKey) return;
    if (key === 'ArrowLeft' || key === 'ArrowRight') this.go(key === 'ArrowLeft' ? -1 : 1);
    else if (key === 'Escape') this.steps.end();
    else if (!this.step(key)) return;
    event.preventDefault();
  }
}

function arrow(id: string, name: string, d: string): HTMLButtonElement {
  return make('button', { type: 'button', class: 'key', id, 'aria-label': name, title: name }, shape('svg', { viewBox: '0 0 20 20', 'aria-hidden': 'true' }, shape('path', { d })));
}
