/** The view for a class: one question or one figure fills the screen, and raised hands are counted beside each answer. */
import { make } from '../base/dom';

const HANDS = { en: 'Raised hands', ja: '挙手の数' };

/** Elements that use the arrow keys themselves. */
const OWN_KEYS = 'input, select, textarea, [role=slider], [role=application], summary';

/** Those of them that have no use for the page keys, which presenters send. */
const NO_PAGES = 'input[type=radio], summary';

/** Binds the view for a class. Returns nothing on a page without scenes. */
export function bindClass(language: 'en' | 'ja'): Lesson | undefined {
  const scenes = [...document.querySelectorAll<HTMLElement>('.scene')];
  const button = document.getElementById('class');
  if (!button || !scenes.length) return undefined;
  const lesson = new Lesson(scenes, button);
  button.hidden = false;
  button.addEventListener('click', () => lesson.toggle());
  document.addEventListener('keydown', (event) => lesson.key(event));
  document.addEventListener('opened', ({ target }) => lesson.open(target as Node));
  addEventListener('resize', () => lesson.place());
  // Answers that unfold take room; the event does not bubble.
  document.addEventListener('toggle', () => lesson.fit(), true);
  for (const label of document.querySelectorAll('.ask label')) count(label, HANDS[language]);
  return lesson;
}

/** Adds a box for a number beside an answer. Pupils' hands are counted in class alone. */
function count(label: Element, word: string): void {
  const answer = label.querySelector('span:last-child')?.textContent ?? '';
  const box = make('input', { type: 'number', class: 'hands', min: '0', max: '99', inputmode: 'numeric', 'aria-label': `${word}: ${answer}`, placeholder: '0' });
  label.after(box);
}

const WAYS: Readonly<Record<string, number>> = { ArrowRight: 1, PageDown: 1, ArrowLeft: -1, PageUp: -1 };

/** Whether an element under the focus has a use of its own for a key. */
function usesKey({ key, target }: KeyboardEvent): boolean {
  if (!(target instanceof Element) || !target.closest(OWN_KEYS)) return false;
  return !(key.startsWith('Page') && target.closest(NO_PAGES));
}

/** The content of one screen: a scene's question with its answers and a still picture of its figure, or the figure in full. */
interface Slide {
  readonly scene: HTMLElement;
  readonly part: 'ask' | 'figure';
}

function slidesOf(scene: HTMLElement): Slide[] {
  const hasFigure = scene.querySelector('.figure') !== null;
  const ask: Slide[] = !hasFigure || scene.querySelector('.ask, .marking') ? [{ scene, part: 'ask' }] : [];
  return hasFigure ? [...ask, { scene, part: 'figure' }] : ask;
}

/** Room in letters below a question's picture, and below the text of a figure. */
const BELOW = { ask: 2.5, figure: 0.75 };

/** The least height of a question's picture, in letters; with less room it is left out. */
const LEAST = 11.25;

/** The size of a letter in pixels, which is smaller on a small projector. */
const letter = (): number => parseFloat(getComputedStyle(document.documentElement).fontSize);

/** The least share of their height that a figure's plates keep for its text; with less room the page scrolls. */
const SHARE = 0.7;

/**
 * Scales plates until the lower edge of `end` is as low as the window allows. Returns the height of the plates. `end`
 * is the text below the plates, or the plates themselves.
 */
function fill(plates: HTMLElement, end: HTMLElement, part: Slide['part']): number {
  const { width, height } = plates.getBoundingClientRect();
  const spare = innerHeight - BELOW[part] * letter() - scrollY - end.getBoundingClientRect().bottom;
  if (part === 'ask' || spare > (SHARE - 1) * height) plates.style.maxWidth = `${width * Math.max(0, 1 + spare / height)}px`;
  return height + spare;
}

export class Lesson {
  private readonly slides: readonly Slide[];
  /** Sees texts that take more lines than before. */
  private readonly texts = new ResizeObserver((grown) => this.keep(grown));
  private at = -1;

  constructor(private readonly scenes: readonly HTMLElement[], private readonly button: HTMLElement) {
    this.slides = scenes.flatMap(slidesOf);
  }

  /** Begins class mode at the scene in sight, or ends it. */
  toggle(): void {
    if (this.at >= 0) this.end();
    else this.show(Math.max(0, this.slides.findIndex(({ scene }) => scene.getBoundingClientRect().bottom > innerHeight / 3)));
  }

  /** The number of the present screen, from 0 on; -1 while there is no class. */
  get screen(): number {
    return this.at;
  }

  /** Begins class mode at a screen of this number, if there is one. */
  begin(at: number): void {
    if (this.slides[at]) this.show(at);
  }

  /** Goes to the screen of a figure that a link has opened. */
  open(figure: Node): void {
    const at = this.slides.findIndex(({ scene, part }) => part === 'figure' && scene.contains(figure));
    if (this.at >= 0 && at >= 0) this.show(at);
  }

  key(event: KeyboardEvent): void {
    if (this.at < 0 || event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === 'Escape') this.end();
    const way = WAYS[event.key];
    if (way === undefined || usesKey(event)) return;
    event.preventDefault();
    this.show(Math.min(this.slides.length - 1, Math.max(0, this.at + way)));
  }

  /** Puts the texts of a screen above its figure or beside it, where the plates can be larger. */
  place(): void {
    const { scene } = this.slides[this.at] ?? {};
    if (!scene) return;
    this.watch(scene);
    const [above = 0, beside = 0] = [false, true].map((isBeside) => {
      scene.toggleAttribute('data-aside', isBeside);
      const width = this.fit();
      return document.documentElement.scrollHeight > innerHeight + 1 ? 0 : width;
    });
    scene.toggleAttribute('data-aside', beside > above);
    this.fit();
  }

  /** Makes the plates as large as the window has room for, with all that stands around them. Returns their width. */
  fit(): number {
    const { scene, part = 'ask' } = this.slides[this.at] ?? {};
    scene?.removeAttribute('data-bare');
    const [plates, told] = ['.plates', '.figure-told'].map((part) => scene?.querySelector<HTMLElement>(part));
    if (!scene || !plates?.checkVisibility() || !told) return 0;
    plates.style.maxWidth = '';
    // Text that stands beside the plates has no lower edge to fit.
    const isBelow = told.getBoundingClientRect().top >= plates.getBoundingClientRect().bottom;
    const end = part === 'figure' && isBelow ? told : plates;
    let height = 0;
    // Titles and notes of smaller plates may each take another line, so the plates are fitted again.
    for (let k = 0; k < 3; k += 1) height = fill(plates, end, part);
    scene.toggleAttribute('data-bare', part === 'ask' && height < LEAST * letter());
    return plates.getBoundingClientRect().width;
  }

  /** A text that was longer keeps its room, so that plates do not jump from step to step. */
  private keep(grown: readonly ResizeObserverEntry[]): void {
    for (const { target } of grown) (target as HTMLElement).style.minHeight = `${target.getBoundingClientRect().height}px`;
    this.fit();
  }

  /** Watches the texts of a screen, and leaves those of the one before. */
  private watch(scene?: HTMLElement): void {
    this.texts.disconnect();
    for (const text of document.querySelectorAll<HTMLElement>('.figure-told')) {
      text.style.minHeight = '';
      if (scene?.contains(text)) this.texts.observe(text);
    }
  }

  private show(at: number): void {
    this.mark(at);
    const scene = this.slides[at]?.scene;
    this.place();
    scene?.setAttribute('tabindex', '-1');
    scene?.focus({ preventScroll: true });
    scrollTo(0, 0);
  }

  private end(): void {
    const scene = this.slides[this.at]?.scene;
    this.mark(-1);
    this.watch();
    for (const plates of document.querySelectorAll<HTMLElement>('.plates')) plates.style.maxWidth = '';
    scene?.scrollIntoView();
    this.button.focus({ preventScroll: true });
  }

  private mark(at: number): void {
    this.at = at;
    const slide = this.slides[at];
    document.documentElement.toggleAttribute('data-class', slide !== undefined);
    document.documentElement.dataset['part'] = slide?.part ?? '';
    this.button.setAttribute('aria-pressed', String(slide !== undefined));
    for (const scene of this.scenes) {
      scene.toggleAttribute('data-now', scene === slide?.scene);
      scene.removeAttribute('data-aside');
      const figure = scene.querySelector<HTMLElement>('.figure');
      if (figure) figure.inert = slide?.part === 'ask';
    }
  }
}
