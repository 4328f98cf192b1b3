/** The canvas: its size and its content. */
import { said, t, viewIn } from '../words/words';
import { byIdAs, make } from '../base/dom';
import type { Engine } from '../state/engine';
import type { Store } from '../state/store';

/** Views that have a sentence about their content. */
const DRAWINGS = ['packed', 'cells', 'mesh', 'direction', 'height', 'normals', 'ids', 'potential', 'albedo', 'roughness', 'ao', 'paper'] as const;

export class View {
  readonly canvas = byIdAs('canvas', HTMLCanvasElement);
  private readonly select = byIdAs('view', HTMLSelectElement);
  private readonly engine: Engine;
  private readonly store: Store;
  private readonly followers: (() => void)[] = [];
  /** Returns the note of a view that is shown as frames. */
  noted: ((view: string) => string) | undefined;

  constructor(engine: Engine, store: Store) {
    this.engine = engine;
    this.store = store;
    this.select.addEventListener('change', () => store.update({ view: this.select.value }));
    store.on(['view'], ({ view }) => (this.select.value = view));
  }

  /** The views of the present generator; the first ten have the keys 0 to 9. */
  get bases(): readonly string[] {
    return this.engine.generator.bases;
  }

  /** The overlays, in the order of drawing. */
  get overlays(): readonly string[] {
    return this.engine.generator.overlays;
  }

  /** Updates the views for another generator; a view or overlay that it does not have is no longer shown. */
  follow(): void {
    const { view, overlays } = this.store.state;
    this.select.replaceChildren(...this.bases.map((word) => make('option', { value: word }, viewIn(word))));
    this.store.update({ view: this.bases.includes(view) ? view : 'auto', overlays: overlays.filter((word) => this.overlays.includes(word)) });
    this.select.value = this.store.state.view;
  }

  /** A sentence on the content of a drawing; '' for pictures. */
  get note(): string {
    if (this.engine.offers('frames')) return this.noted?.(this.store.state.view) ?? '';
    const drawing = DRAWINGS.find((word) => word === this.store.state.view);
    return drawing ? t(`note_${drawing}`, { n: this.engine.heightRange().toFixed(1) }) : '';
  }

  /**
   * The parts of the view that show nothing, by word, with a sentence on the reason. Empty while work goes on,
   * because they may still come.
   */
  absences(): Map<string, string> {
    const { stage, paused } = this.store.state;
    const found = stage === 'done' || paused ? this.engine.absences(this.words) : [];
    return new Map([...found].map(([word, why]) => [word, t(`absent_${why}`)]));
  }

  /** The remarks of the engine, once the packing has begun. */
  remarks(stage: string): string[] {
    const { stages, stepping } = this.engine.generator;
    return stage === 'done' || stages.indexOf(stage) >= stages.indexOf(stepping) ? this.engine.remarks().map(said) : [];
  }

  /** To be called after each drawing of the canvas. */
  redrawn(): void {
    for (const follow of this.followers) follow();
  }

  /** The view and overlays in the words of the module. */
  get words(): string {
    const { view, overlays } = this.store.state;
    return [view, ...overlays].join('+');
  }

  /** `follow` is called after each drawing of the canvas. */
  drawn(follow: () => void): void {
    this.followers.push(follow);
  }
}
