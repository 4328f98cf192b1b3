/**
 * `<bubble-stone link="...">`: an element that shows how a picture forms.
 *
 * It loads the module when it first comes near the window, and works only while it is visible. After its removal it frees
 * all its memory. Attributes: `link`, `view`, `paused`, `label`. Events: `done`, `error`.
 */
import { Bubblestone, drawWhole, isEnd, load, type Status } from './index.js';

/** Milliseconds and packing steps per frame: few steps, so that the viewer sees bubbles settle. */
const SLICE = 8;
const STEPS = 3;
const ALL_STEPS = 100_000;

/** The distance to the window at which the element loads the module. */
const NEAR = '25%';

/** The detail of the event `done`. */
export interface Done {
  /** The recipe, complete and without '#'. */
  link: string;
  /** The digest of the planes. */
  digest: string;
  status: Status;
  /** Sentences about parts of the link that were mended or left out. */
  notices: string[];
}

/** The detail of the event `error`. */
export interface Failure {
  /** A sentence, which the element shows as well. */
  message: string;
}

interface Events {
  done: CustomEvent<Done>;
  error: CustomEvent<Failure>;
}

/** There are no elements outside documents, as in Node. Importing this file there must not fail. */
const { HTMLElement: Native, customElements: registry } = globalThis as Partial<typeof globalThis>;
const Base = Native ?? (Object as unknown as typeof HTMLElement);

const LOOK = `
  :host { display: inline-block; position: relative; width: 100%; max-width: 32rem; aspect-ratio: 1; contain: content; }
  :host([hidden]) { display: none; }
  canvas { display: block; width: 100%; height: 100%; }
  p { position: absolute; inset: auto 0 0; margin: 0; padding: 0.75em; background: Canvas; color: CanvasText; font: 1rem/1.4 system-ui, sans-serif; }
  p:empty { display: none; }
`;

export class BubbleStone extends Base {
  static readonly observedAttributes = ['link', 'view', 'paused', 'label'];

  readonly #canvas: HTMLCanvasElement;
  readonly #message: HTMLElement;
  readonly #sight: IntersectionObserver;
  readonly #still = matchMedia('(prefers-reduced-motion: reduce)');
  #studio: Bubblestone | undefined;
  #notices: string[] = [];
  #seen = false;
  #coming = false;
  #frame = 0;
  /** The canvas is out of date. */
  #due = false;
  /** The event `done` or `error` of this picture has been sent. */
  #told = false;

  constructor() {
    super();
    const root = this.attachShadow({ mode: 'open' });
    const look = new CSSStyleSheet();
    look.replaceSync(LOOK);
    root.adoptedStyleSheets = [look];
    this.#canvas = document.createElement('canvas');
    this.#canvas.setAttribute('part', 'picture');
    this.#message = document.createElement('p');
    this.#message.setAttribute('role', 'alert');
    this.#message.setAttribute('part', 'message');
    root.append(this.#canvas, this.#message);
    this.#sight = new IntersectionObserver((seen) => this.#sighted(seen.at(-1)?.isIntersecting ?? false), { rootMargin: NEAR });
    this.#name();
  }

  /** The recipe: an address, a fragment, or nothing for the default one. */
  get link(): string {
    return this.getAttribute('link') ?? '';
  }

  set link(link: string) {
    this.setAttribute('link', link);
  }

  /** The words of a view, joined by '+', as for `Bubblestone.draw`; 'auto' shows how the picture forms. */
  get view(): string {
    return this.getAttribute('view') ?? 'auto';
  }

  set view(view: string) {
    this.setAttribute('view', view);
  }

  /** While paused, the element does no work. */
  get paused(): boolean {
    return this.hasAttribute('paused');
  }

  set paused(on: boolean) {
    this.toggleAttribute('paused', on);
  }

  /** The text for screen readers; '' for an ornament. */
  get label(): string {
    return this.getAttribute('label') ?? 'A picture of stones';
  }

  set label(label: string) {
    this.setAttribute('label', label);
  }

  /**
   * The element's studio. Read from it, but neither free nor keep it. Undefined before the element is first visible and
   * after its removal.
   */
  get studio(): Bubblestone | undefined {
    return this.#studio;
  }

  /** Makes the picture again, from the beginning. */
  restart(): void {
    this.#guarded((studio) => studio.restart());
    this.#anew();
  }

  connectedCallback(): void {
    this.#sight.observe(this);
    this.#still.addEventListener('change', this.#wake);
  }

  disconnectedCallback(): void {
    // An element that was only moved is connected again by then.
    queueMicrotask(() => {
      if (!this.isConnected) this.#leave();
    });
  }

  attributeChangedCallback(name: string, before: string | null, now: string | null): void {
    if (before === now) return;
    if (name === 'label') return this.#name();
    if (name === 'link') {
      this.#guarded((studio) => this.#open(studio));
      this.#anew();
      // A failed load is tried again.
      if (this.#seen) void this.#begin();
      return;
    }
    this.#due = true;
    this.#wake();
  }

  override addEventListener<K extends keyof Events>(kind: K, listener: (this: BubbleStone, event: Events[K]) => unknown, options?: boolean | AddEventListenerOptions): void;
  override addEventListener(kind: string, listener: EventListenerOrEventListenerObject, options?: boolean | AddEventListenerOptions): void;
  override addEventListener(kind: string, listener: EventListenerOrEventListenerObject, options?: boolean | AddEventListenerOptions): void {
    super.addEventListener(kind, listener, options);
  }

  #name(): void {
    this.#canvas.role = this.label ? 'img' : 'presentation';
    this.#canvas.ariaLabel = this.label || null;
  }

  #sighted(seen: boolean): void {
    this.#seen = seen;
    if (seen) void this.#begin();
    this.#wake();
  }

  async #begin(): Promise<void> {
    if (this.#studio || this.#coming) return;
    this.#coming = true;
    try {
      await load();
      if (this.isConnected) this.#studio = new Bubblestone(this.link);
      this.#notices = this.#studio?.notices().map(({ text }) => text) ?? [];
      this.#anew();
    } catch (error) {
      this.#failed(error instanceof Error ? error.message : String(error));
    } finally {
      this.#coming = false;
    }
  }

  #open(studio: Bubblestone): void {
    this.#notices = studio.open(this.link).map(({ text }) => text);
  }

  /** Starts another picture. */
  #anew(): void {
    this.#told = false;
    this.#due = true;
    this.#message.textContent = '';
    this.#wake();
  }

  #leave(): void {
    this.#sight.disconnect();
    this.#still.removeEventListener('change', this.#wake);
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    this.#seen = false;
    this.#guarded((studio) => studio.free());
    this.#studio = undefined;
  }

  /** Continues in the next frame, if the element is visible and there is something to do. */
  readonly #wake = (): void => {
    if (this.#frame || !this.#seen || !this.#studio) return;
    this.#frame = requestAnimationFrame(() => {
      this.#frame = 0;
      this.#guarded((studio) => this.#goOn(studio));
    });
  };

  #goOn(studio: Bubblestone): void {
    // A drawing that was begun is finished before further work.
    if (!this.#due && !this.paused && !isEnd(studio)) this.#due = studio.tick(SLICE, this.#still.matches ? ALL_STEPS : STEPS);
    const ended = isEnd(studio);
    // Visitors who prefer reduced motion see finished pictures only.
    const shown = ended || this.paused || !this.#still.matches;
    if (!shown) this.#due = false;
    if (this.#due && studio.prepare(this.view, SLICE)) this.#draw(studio);
    if (ended && !this.#due && !this.#told) this.#tell(studio);
    if (this.#due || !(ended || this.paused)) this.#wake();
  }

  #draw(studio: Bubblestone): void {
    const canvas = this.#canvas;
    const context = canvas.getContext('2d');
    if (context) drawWhole(studio, canvas, context, this.view);
    this.#due = false;
  }

  #tell(studio: Bubblestone): void {
    this.#told = true;
    const problem = studio.problem();
    if (problem) return this.#failed(problem.text);
    const detail: Done = { link: studio.link(), digest: studio.digest(), status: studio.status(), notices: this.#notices };
    this.dispatchEvent(new CustomEvent('done', { detail }));
  }

  #failed(message: string): void {
    this.#message.textContent = message;
    this.dispatchEvent(new CustomEvent<Failure>('error', { detail: { message } }));
  }

  /** Calls the module, but never again after a call has failed. */
  #guarded(act: (studio: Bubblestone) => void): void {
    if (!this.#studio) return;
    try {
      act(this.#studio);
    } catch {
      this.#studio = undefined;
      this.#failed('Bubblestone has stopped after an error; load the page again.');
    }
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'bubble-stone': BubbleStone;
  }
}

// Two copies of this file on one page define the element once.
if (registry && !registry.get('bubble-stone')) registry.define('bubble-stone', BubbleStone);
