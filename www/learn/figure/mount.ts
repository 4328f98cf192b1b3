/**
 * Puts the figures of a page to work: each near the window, with the module that the first of them loads. One that is far
 * away is freed and keeps its picture and its state.
 */
import { figureOf } from '../figures/figures';
import type { Language } from '../figures/figure';
import type { Bubbles } from '../draw/studio';
import { Link } from '../../state/link';
import { opening, stateIn, stateWords, type State } from './address';
import { Live } from './live';
import { Turns } from './turns';
import './figure.css';
import './population.css';
import './squares.css';

/** How far from the window a figure begins to work, and how far away it is freed, in screens. */
const NEAR = '50%';
const FAR = '200%';

class Place {
  private readonly element: HTMLElement;
  private readonly name: string;
  private readonly page: Page;
  private live: Live | undefined;
  private state: State | undefined;
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
  open(state: State): void {
    this.leave();
    this.state = state;
    this.element.scrollIntoView({ block: 'center' });
    if (this.isNear) void this.begin();
  }

  private async begin(): Promise<void> {
    const figure = figureOf(this.name);
    if (!figure) return;
    const module = await this.page.module();
    // Another call may have begun meanwhile, and the reader may have gone on.
    if (this.live || !this.isNear || !module) return;
    const state = this.state ?? opening(figure);
    const first = { now: true };
    this.live = new Live(this.element, figure, this.page.language, module, state, this.page.turns, (now) => {
      this.state = now;
      this.follow(now, first.now);
      first.now = false;
    });
    this.live.sight(this.isInSight);
    this.element.dataset.live = '';
  }

  /** The address and the link into the studio have the present state. The state that a figure opens with is not written. */
  private follow(state: State, isFirst: boolean): void {
    if (!isFirst) this.page.write(stateWords(this.name, state));
    this.element.dataset.hash = this.live?.hash ?? '';
    for (const link of document.querySelectorAll<HTMLAnchorElement>(`a.into-studio[data-figure="${this.name}"]`)) {
      link.hash = `${state.recipe}&view=packed&step=${state.step}`;
    }
  }

  private leave(): void {
    this.state = this.live?.state ?? this.state;
    this.live?.end();
    this.live = undefined;
    delete this.element.dataset.live;
  }
}

class Page {
  readonly language: Language;
  readonly turns = new Turns();
  private readonly places: Place[];
  private readonly link: Link;
  private loading: Promise<Bubbles | undefined> | undefined;

  constructor(root: ParentNode, language: Language) {
    this.language = language;
    this.link = new Link((fragment) => this.open(fragment));
    this.places = [...root.querySelectorAll<HTMLElement>('figure[data-figure]')].map((element) => new Place(element, this));
    this.open(location.hash.slice(1));
  }

  write(state: string): void {
    this.link.write(state);
  }

  /** The module, once; without it the figures stay pictures. */
  module(): Promise<Bubbles | undefined> {
    return (this.loading ??= import('../../module/first').then(({ loadFirst }) => loadFirst()).catch(() => undefined));
  }

  private open(fragment: string): void {
    const asked = stateIn(fragment);
    if (asked) this.places.find((place) => place.is(asked.figure.name))?.open(asked.state);
  }
}

/** Puts all figures of a page to work as they come near the window. */
export function mountFigures(root: ParentNode, language: Language): void {
  new Page(root, language);
}
