/**
 * Puts the figures of a page to work: each near the window, with the module that the first of them loads. A figure that
 * is far away is freed, but keeps its picture and its state.
 */
import type { Language } from '../figures/figure';
import type { Bubbles } from '../draw/studio';
import { Link } from '../../state/link';
import { shownIn, type Shown } from '../draw/picture';
import { figureIn, opening, stateIn, stateWords, studioWords, type State } from './address';
import { drawingsOf } from './chapters';
import { Live } from './live';
import { Past } from './past';
import { Turns } from './turns';
import './figure.css';
import './mesh.css';
import './population.css';
import './squares.css';
import './ways.css';
import './letters.css';

/** How far from the window a figure begins to work, and how far away it is freed, in screens. */
const NEAR = '50%';
const FAR = '200%';

class PlacedFigure {
  private readonly element: HTMLElement;
  private readonly name: string;
  private readonly page: Page;
  private live: Live | undefined;
  private state: State | undefined;
  private past = new Past();
  /** A fragment of the address that is to be opened. */
  private asked: string | undefined;
  private isNear = false;
  private isInSight = false;

  constructor(element: HTMLElement, page: Page) {
    [this.element, this.page, this.name] = [element, page, element.dataset.figure ?? ''];
    const watch = (rootMargin: string, seen: (isSeen: boolean) => void): void =>
      new IntersectionObserver((all) => seen(all.at(-1)?.isIntersecting ?? false), { rootMargin: `${rootMargin} 0px` }).observe(element);
    watch(FAR, (isSeen) => isSeen || this.leave());
    watch(NEAR, (isSeen) => {
      this.isNear = isSeen;
      if (isSeen) void this.begin();
    });
    watch('0%', (isSeen) => {
      this.isInSight = isSeen;
      this.live?.sight(isSeen);
    });
  }

  is(name: string): boolean {
    return this.name === name;
  }

  /** Opens a state of the address, and shows the figure. */
  open(fragment: string): void {
    this.leave();
    this.past = new Past();
    this.asked = fragment;
    // Class mode goes to the figure's screen.
    this.element.dispatchEvent(new Event('opened', { bubbles: true }));
    // The plates of a figure that is higher than the window come first.
    this.element.scrollIntoView({ block: this.element.offsetHeight > innerHeight ? 'start' : 'center' });
    if (this.isNear) void this.begin();
  }

  private async begin(): Promise<void> {
    const [shown, module] = await Promise.all([this.shown(), this.page.module()]);
    // Another call may have begun meanwhile, and the reader may have gone on.
    if (this.live || !this.isNear || !module || !shown) return;
    const state = this.asked === undefined ? (this.state ?? opening(shown.figure)) : stateIn(this.asked, shown.figure);
    this.asked = undefined;
    const first = { now: true };
    this.live = new Live(this.element, shown, this.page.language, module, state, this.past, this.page.turns, (now) => {
      this.state = now;
      this.follow(now, first.now);
      first.now = false;
    });
    this.live.sight(this.isInSight);
    this.element.dataset.live = '';
  }

  private async shown(): Promise<Shown | undefined> {
    const chapter = this.element.querySelector<HTMLElement>('[data-chapter]')?.dataset.chapter ?? '';
    const drawings = await drawingsOf(chapter);
    return drawings && shownIn(drawings, this.name);
  }

  /** The address and the link into the studio have the present state. The state that a figure opens with is not written. */
  private follow(state: State, isFirst: boolean): void {
    if (!isFirst) this.page.write(stateWords(this.name, state));
    if (!this.live) return;
    this.element.dataset.hash = this.live.hash;
    const words = studioWords(this.live.figure, state);
    for (const link of document.querySelectorAll<HTMLAnchorElement>(`a.into-studio[data-figure="${this.name}"]`)) link.hash = words;
  }

  private leave(): void {
    this.state = this.live?.state ?? this.state;
    this.live?.end();
    this.live = undefined;
    delete this.element.dataset.live;
    delete this.element.dataset.hash;
    delete this.element.dataset.step;
  }
}

class Page {
  readonly language: Language;
  readonly turns = new Turns();
  private readonly places: PlacedFigure[];
  private readonly link: Link;
  private loading: Promise<Bubbles | undefined> | undefined;

  constructor(root: ParentNode, language: Language) {
    this.language = language;
    this.link = new Link((fragment) => this.open(fragment));
    this.places = [...root.querySelectorAll<HTMLElement>('figure[data-figure]')].map((element) => new PlacedFigure(element, this));
    this.open(location.hash.slice(1));
  }

  write(state: string): void {
    this.link.write(state);
  }

  /** The module, once; without it the figures stay pictures, and the next one that comes near asks again. */
  module(): Promise<Bubbles | undefined> {
    return (this.loading ??= import('../../module/first').then(({ loadFirst }) => loadFirst()).catch(() => (this.loading = undefined)));
  }

  private open(fragment: string): void {
    this.places.find((place) => place.is(figureIn(fragment)))?.open(fragment);
  }
}

/** Puts all figures of a page to work as they come near the window. */
export function mountFigures(root: ParentNode, language: Language): void {
  new Page(root, language);
}
