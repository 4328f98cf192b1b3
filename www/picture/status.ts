/** The status of the work: stages with their milliseconds, counts, and the caption. */
import { countedBy, progressOf, type Course } from '../module/stages';
import type { Preset, Status } from '../module/types';
import { partIn, stageIn, t } from '../words/words';
import { byId, make, say } from '../base/dom';
import { notice } from '../base/messages';

/**
 * Milliseconds after which the progress bar appears; later while a visitor watches, since the work is slow on
 * purpose.
 */
const LONG = 400;
const WATCHED = 6000;

/** Milliseconds between two changes of the numbers while work goes on: faster ones cannot be read. */
const READ = 250;

const COUNTS = ['cells', 'steps', 'move', 'added'] as const;

/** The counts of generators whose cells move, come and go. */
const OF_MOVES: readonly string[] = ['move', 'added'];

/** The words of these counts for cells, bodies and blocks. `follow` hides the counts that a generator does not have. */
const WORDS = { cells: COUNTS, bodies: ['bodies', 'turns', 'move', 'removed'], blocks: ['blocks', 'steps', 'move', 'added'] } as const;

export class StatusLine {
  private readonly stages = new Map<string, { item: HTMLElement; time: HTMLElement }>();
  private readonly counts = new Map<string, { value: HTMLElement; name: HTMLElement; box: HTMLElement }>();
  /** Whether bodies are counted. */
  private ofBodies = false;
  private readonly caption = byId('caption');
  private readonly work = byId('work');
  private readonly way = make('span');
  private began: number | undefined;
  /** The text of the caption, with its remarks. */
  private captioned = '';
  /** The stage of the numbers, and the time until which they stay. */
  private shown = '';
  private until = 0;
  private course: Course = { stages: [], begins: [], stepping: '', placing: '', settled: '' };

  constructor() {
    this.work.replaceChildren(this.way);
    const list = byId('counts');
    list.replaceChildren();
    for (const count of COUNTS) {
      const value = make('dd', { id: `count-${count}` }, '–');
      const name = make('dt');
      const box = make('div', {}, name, value);
      list.append(box);
      this.counts.set(count, { value, name, box });
    }
  }

  /** Shows the stages of the present generator. */
  follow(course: Course & { offers: readonly string[] }): void {
    this.course = course;
    const counted = countedBy(course);
    this.nameCounts(counted);
    for (const count of OF_MOVES) {
      const parts = this.counts.get(count);
      if (parts) parts.box.hidden = !course.offers.includes('moves');
    }
    const steps = this.counts.get('steps');
    if (steps) steps.box.hidden = counted === 'blocks';
    this.stages.clear();
    for (const word of course.stages) {
      const time = make('span', { class: 'time' }, '–');
      const item = make('li', { 'data-word': word }, make('span', { class: 'word' }, stageIn(word)), time);
      this.stages.set(word, { item, time });
    }
    byId('pipeline').replaceChildren(...Array.from(this.stages.values(), ({ item }) => item));
  }

  /** Shows the progress and the numbers. While the work `goesOn`, most numbers are left out; returns whether they are shown. */
  show(stage: string, status: Status, { watched, goesOn }: { watched: boolean; goesOn: boolean }): boolean {
    this.progress(stage, status, watched ? WATCHED : LONG);
    const now = performance.now();
    if (goesOn && stage === this.shown && now < this.until) return false;
    [this.shown, this.until] = [stage, now + READ];
    const words = this.course.stages;
    const at = words.indexOf(stage);
    words.forEach((word, index) => {
      const parts = this.stages.get(word);
      if (!parts) return;
      const state = stage === 'done' || index < at ? 'done' : index === at ? 'now' : 'next';
      if (parts.item.dataset['state'] !== state) parts.item.dataset['state'] = state;
      if (state === 'now') parts.item.setAttribute('aria-current', 'step');
      else parts.item.removeAttribute('aria-current');
      const spent = status.ms[word];
      say(parts.time, state === 'next' || spent === undefined ? '–' : `${milliseconds(spent)} ms`);
    });
    // A recipe without a picture has no numbers; those of the engine are of the recipe before.
    const counted = { cells: status.cells, steps: status.steps, move: status.steps ? status.largestMove.toFixed(3) : '–', added: this.ofBodies ? status.removed : `+${status.added} −${status.removed}` };
    for (const name of COUNTS) this.count(name, stage === 'error' ? '–' : String(counted[name]));
    return true;
  }

  private nameCounts(counted: keyof typeof WORDS): void {
    this.ofBodies = counted === 'bodies';
    COUNTS.forEach((count, k) => {
      const parts = this.counts.get(count);
      const word = WORDS[counted][k] ?? count;
      if (!parts) return;
      say(parts.name, t(`count_${word}`));
      parts.box.title = t(`count_${word}_title`);
    });
  }

  /**
   * Writes the caption. It is `note` if there is one (for drawings, and recipes without a name), else the preset's
   * name, with the times printed in the papers beside ours. Then follow the reasons why parts are `absent`, and a
   * button for the remarks.
   */
  name(note: string, [absent, remarks]: [absent: Iterable<string>, remarks: readonly string[]], preset: Preset | undefined, changed: boolean, stage: string, status: Status): void {
    const parts = note || !preset ? [note] : this.named(preset, changed, stage, status);
    for (const sentence of new Set(absent)) parts.push(' – ', make('span', { class: 'absent' }, sentence));
    if (remarks.length) parts.push(' ', remarked(remarks));
    const text = [...parts.map((part) => (typeof part === 'string' ? part : part.textContent)), ...remarks].join('');
    if (this.captioned !== text) this.caption.replaceChildren(...parts);
    this.captioned = text;
  }

  private named(preset: Preset, changed: boolean, stage: string, status: Status): (string | HTMLElement)[] {
    const name = preset.figure || preset.title;
    if (changed) return [t('after', { name })];
    const parts: (string | HTMLElement)[] = [make('strong', {}, preset.note ? t('titled', { name }) : t('titled_only', { name })), ...(preset.note ? [` ${preset.note}`] : [])];
    if (preset.timing) {
      const { machine, parts: timed, bodies } = preset.timing;
      const among = (n: number): string => (bodies ? t('among_bodies', { n }) : '');
      const what = capital(timed.map(({ name }) => partIn(name)).join(t('and')));
      const theirs = timed.map((part) => `${part.seconds} s`).join(t('and')) + among(bodies);
      const ours = stage === 'done' ? timed.map((part) => ourSeconds(part.stages, status)).join(t('and')) + among(status.cells) : '…';
      parts.push(make('span', { class: 'seconds', title: t('timing_title', { what, machine }) }, t(stage === 'done' ? 'timing' : 'timing_open', { what, theirs, ours })));
    }
    return parts;
  }

  /** The progress bar under the canvas, while work takes long. */
  private progress(stage: string, status: Status, long: number): void {
    const word = this.course.stages.includes(stage) ? stage : undefined;
    const now = performance.now();
    this.began = word === undefined ? undefined : (this.began ?? now);
    // A bar that is shown stays, also if a press makes the visitor one who watches.
    this.work.hidden = this.began === undefined || (this.work.hidden && now - this.began < long);
    if (!word || this.work.hidden) return;
    const done = progressOf(this.course, word, status);
    const n = Math.round(100 * done);
    this.way.style.transform = `scaleX(${done})`;
    this.work.setAttribute('aria-valuenow', String(n));
    this.work.setAttribute('aria-valuetext', t('work_stage', { stage: stageIn(word), n }));
  }

  private count(name: (typeof COUNTS)[number], text: string): void {
    const parts = this.counts.get(name);
    if (parts) say(parts.value, text);
  }
}

/** A button that shows the remarks over the picture. */
function remarked(remarks: readonly string[]): HTMLElement {
  const button = make('button', { type: 'button', class: 'remarks' }, t('remarks', { n: remarks.length }));
  button.addEventListener('click', () => notice('remarks', ...remarks));
  return button;
}

function milliseconds(spent: number): string {
  return spent < 9.95 ? spent.toFixed(1) : spent.toFixed(0);
}

function capital(words: string): string {
  return words.charAt(0).toUpperCase() + words.slice(1);
}

/** The time of some stages with two significant digits; the papers print one or two as well. */
function ourSeconds(stages: string[], status: Status): string {
  const spent = stages.reduce((total, word) => total + (status.ms[word] ?? 0), 0);
  return `${spent < 1 ? t('below') : Number((spent / 1000).toPrecision(2))} s`;
}
