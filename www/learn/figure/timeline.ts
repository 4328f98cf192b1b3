/** The timeline of a figure: again, back, play, on, a slider with marks at the stops, the stops by name, and the speed. */
import { LAST, markedAt } from '../draw/picture';
import { icon, stepWords, TOOL_WORDS } from '../draw/tools';
import type { Figure, Language } from '../figures/figure';

/** Actions that the timeline takes on its figure. */
export interface Timed {
  readonly figure: Figure;
  readonly language: Language;
  again(): void;
  play(): void;
  /** Goes some steps forwards, or back if the number is negative. */
  by(steps: number): void;
  seek(step: number): void;
}

interface Stopped {
  readonly key: string;
  readonly step: number;
}

export class Timeline {
  private readonly of: Timed;
  /** The slider; a figure without steps has none. */
  private readonly range: HTMLInputElement | null;
  private readonly place: HTMLElement;
  private stops: readonly Stopped[] = [];
  private isPlaying: boolean | undefined;
  /** The last step there is. */
  private last = 0;
  /** The stops that are marked, in words. */
  private marked = '';

  constructor(of: Timed, place: HTMLElement, signal: AbortSignal) {
    [this.of, this.place] = [of, place];
    this.range = place.querySelector('input.time');
    const acts: Record<string, () => void> = { again: () => of.again(), play: () => of.play(), back: () => of.by(-1), on: () => of.by(1) };
    place.querySelectorAll<HTMLElement>('[data-do]').forEach((button) => button.addEventListener('click', () => acts[button.dataset.do ?? '']?.(), { signal }));
    place.querySelectorAll<HTMLElement>('[data-stop]').forEach((button) => button.addEventListener('click', () => this.go(button.dataset.stop ?? ''), { signal }));
    const { range } = this;
    range?.addEventListener('input', () => of.seek(range.valueAsNumber), { signal });
    range?.addEventListener('keydown', (event) => this.onKey(event, range.valueAsNumber), { signal });
  }

  /** The factor of the speed. */
  get speed(): number {
    return Number(this.place.querySelector<HTMLSelectElement>('select.speed')?.value ?? 1);
  }

  private go(key: string): void {
    const step = this.stepOf(this.stops, key);
    if (step !== undefined) this.of.seek(step);
  }

  /**
   * The step of a stop on offer. The last step always is: the slider leads there, too, and it gives nothing away. It is
   * no stop of its own where another stop falls on it, or where the run was not yet seen to its end.
   */
  private stepOf(stops: readonly Stopped[], key = ''): number | undefined {
    return key === LAST ? this.last : stops.find((one) => one.key === key)?.step;
  }

  /** Page keys go from stop to stop. */
  private onKey(event: KeyboardEvent, now: number): void {
    const steps = this.stops.map(({ step }) => step);
    const next = event.key === 'PageUp' ? steps.find((step) => step > now) : event.key === 'PageDown' ? steps.findLast((step) => step < now) : undefined;
    if (next === undefined) return;
    event.preventDefault();
    this.of.seek(next);
  }

  show(step: number, last: number, isPlaying: boolean, stops: readonly Stopped[]): void {
    const { of: { figure, language }, range } = this;
    if (!range) return;
    this.last = last;
    this.mark(stops, last);
    const said = stepWords(figure, step, last, language);
    range.max = String(last);
    range.value = String(step);
    range.setAttribute('aria-valuetext', said);
    range.style.setProperty('--share', String(step / (last || 1)));
    (this.place.querySelector('.time-said') as HTMLElement).textContent = said;
    const marked = markedAt(stops, step, last);
    this.place.querySelectorAll<HTMLElement>('[data-stop]').forEach((button) => (button.ariaCurrent = button.dataset.stop === marked ? 'step' : null));
    if (isPlaying !== this.isPlaying) this.name(isPlaying);
  }

  private name(isPlaying: boolean): void {
    this.isPlaying = isPlaying;
    const button = this.place.querySelector('[data-do="play"]') as HTMLElement;
    const name = isPlaying ? 'pause' : 'play';
    button.innerHTML = `${icon(name)}<span>${TOOL_WORDS[name][this.of.language]}</span>`;
  }

  private mark(stops: readonly Stopped[], last: number): void {
    const words = `${last}: ${stops.map(({ key, step }) => `${key} ${step}`).join(' ')}`;
    if (words === this.marked) return;
    this.marked = words;
    this.stops = stops;
    const marks = stops.map(({ step }) => {
      const mark = document.createElement('span');
      mark.style.setProperty('--share', String(step / (last || 1)));
      return mark;
    });
    (this.place.querySelector('.time-marks') as HTMLElement).replaceChildren(...marks);
    this.place.querySelectorAll<HTMLButtonElement>('[data-stop]').forEach((button) => (button.disabled = this.stepOf(stops, button.dataset.stop) === undefined));
  }
}
