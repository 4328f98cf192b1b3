/** The rail of presets: the program's own and the papers' figures, each with a small picture. */
import type { Preset } from '../module/types';
import { groupIn, t } from '../words/words';
import { byId, make } from '../base/dom';
import { FIRST } from '../state/first';

/** The side of the small pictures (thumbs/NAME.avif, made by the build), in CSS pixels. */
const THUMB = '72';

/** The presets that a chapter explains, with its number and its page (www/learn). */
const EXPLAINED: Readonly<Record<string, readonly [number: number, page: string]>> = {
  bubbles: [1, 'two-bubbles'],
  packed: [2, 'many-bubbles'],
  voronoi: [3, 'mesh'],
  lloyd: [3, 'mesh'],
  whirl: [4, 'squares'],
  'fig15-a': [5, 'which-way'],
  'fig16-b': [5, 'which-way'],
  eye: [6, 'how-many'],
};

interface PresetGroup {
  readonly heading: HTMLButtonElement;
  readonly list: HTMLUListElement;
}

/** One group of presets is open at a time. */
export class Presets {
  private groups: PresetGroup[] = [];
  private readonly buttons = new Map<string, HTMLButtonElement>();
  /** Each writes the words of a preset or of a group. */
  private words: (() => void)[] = [];
  private marked: string | undefined;
  private placed: ResizeObserver | undefined;
  /** Loads pictures that come into sight. The browsers' own lazy loading fetches far more of a list than is visible. */
  private readonly inSight = new IntersectionObserver((entries) => {
    for (const { isIntersecting, target } of entries) {
      if (!isIntersecting || !(target instanceof HTMLImageElement)) continue;
      target.src = `thumbs/${target.dataset['name'] ?? ''}.avif`;
      this.inSight.unobserve(target);
    }
  });

  constructor(private readonly chosen: (preset: Preset) => void) {}

  /** Lists the presets of the present generator. The one with which the page opens is the first. */
  build(all: Preset[]): void {
    const presets = [...all.filter(({ link }) => link === FIRST), ...all.filter(({ link }) => link !== FIRST)];
    const rail = byId('rail');
    rail.replaceChildren();
    this.inSight.disconnect();
    this.groups = [];
    this.words = [];
    this.buttons.clear();
    for (const title of new Set(presets.map(({ group }) => group))) {
      const id = `presets-${this.groups.length}`;
      const list = make('ul', { id });
      const own = presets.filter(({ group }) => group === title);
      for (const preset of own) {
        const isAlone = own.filter(({ figure }) => figure === preset.figure).length === 1;
        const [number, page = ''] = EXPLAINED[preset.name] ?? [];
        const chapter = number ? [make('a', { href: t('chapter_page', { page }) }, t('chapter', { n: number }))] : [];
        list.append(make('li', {}, this.button(preset, isAlone), ...chapter));
      }
      const heading = make('button', { type: 'button', 'aria-controls': id });
      const write = (): void => {
        heading.textContent = list.ariaLabel = groupIn(title);
      };
      write();
      this.words.push(write);
      const group = { heading, list };
      heading.addEventListener('click', () => this.unfold(group));
      this.groups.push(group);
      rail.append(make('h2', {}, heading), list);
    }
    const [first] = this.groups;
    if (first) this.unfold(first);
  }

  /** Marks the shown preset, and scrolls to it when it changed. */
  mark(name: string | undefined): void {
    for (const [key, button] of this.buttons) {
      if (key === name) button.setAttribute('aria-current', 'true');
      else button.removeAttribute('aria-current');
    }
    const button = name !== undefined && name !== this.marked && this.buttons.get(name);
    this.marked = name;
    if (button) this.reveal(button);
  }

  private unfold(group: PresetGroup): void {
    for (const each of this.groups) {
      each.list.hidden = each !== group;
      each.heading.setAttribute('aria-expanded', String(each === group));
    }
  }

  /** Scrolls only the list, never the page. */
  private reveal(button: HTMLButtonElement): void {
    const group = this.groups.find(({ list }) => list.contains(button));
    if (!group) return;
    if (group.list.hidden) this.unfold(group);
    // Measuring now would force a layout while the page still changes.
    this.placed?.disconnect();
    this.placed = new ResizeObserver(() => {
      this.placed?.disconnect();
      scrollInto(group.list, button);
    });
    this.placed.observe(button);
  }

  /**
   * Writes the words again after a change of the language. A title may look like another word, as "Steps" does, and then
   * its text alone does not tell its translation.
   */
  retell(): void {
    for (const write of this.words) write();
  }

  /** A preset's button. It shows the number of its figure if the figure `isAlone` in its group. */
  private button(preset: Preset, isAlone: boolean): HTMLButtonElement {
    const picture = make('img', { decoding: 'async', width: THUMB, height: THUMB, alt: '', 'data-name': preset.name });
    this.inSight.observe(picture);
    const word = make('span');
    const button = make('button', { type: 'button', 'data-preset': preset.name }, picture, word);
    const write = (): void => {
      const figure = isAlone ? preset.figure : '';
      button.title = preset.note ? `${figure || preset.title}: ${preset.note}` : preset.title;
      word.textContent = figure ? short(figure) : preset.title;
      if (figure) button.setAttribute('aria-label', figure);
    };
    write();
    this.words.push(write);
    button.addEventListener('click', () => this.chosen(preset));
    this.buttons.set(preset.name, button);
    return button;
  }
}

/** Scrolls no farther than needed, so that a list begins with its first presets as long as the item is visible there. */
function scrollInto(list: HTMLElement, item: HTMLElement): void {
  const [box, frame] = [item.getBoundingClientRect(), list.getBoundingClientRect()];
  list.scrollTop += way(box.top - frame.top, box.bottom - frame.bottom);
  list.scrollLeft += way(box.left - frame.left, box.right - frame.right);
}

/** How far a list scrolls to show an item that lies `before` beyond its first edge and `after` beyond its last one. */
function way(before: number, after: number): number {
  return before < 0 ? before : Math.max(0, after);
}

/** A figure's number, to stand under a small picture: "Fig. 13 (1b) of 2000, Fig. 12 (1b) of 2001" gives "13 (1b)". */
function short(figure: string): string {
  return /(?:Fig\. |図)(\d+\s*(\(\w+\))?)/.exec(figure)?.[1] ?? figure;
}
