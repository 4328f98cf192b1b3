/** The canvas: its size, and what it shows. */
import { byIdAs, make } from './dom';
import type { Engine } from './engine';
import type { Store } from './store';
import { t } from './words';

/** The views in the order of their keys 0 to 9, and whether there is a sentence about what they show. */
export const VIEWS = [
  { word: 'auto', note: undefined },
  { word: 'picture', note: undefined },
  { word: 'packed', note: 'note_packed' },
  { word: 'cells', note: 'note_cells' },
  { word: 'mesh', note: 'note_mesh' },
  { word: 'direction', note: 'note_direction' },
  { word: 'height', note: undefined },
  { word: 'normals', note: undefined },
  { word: 'ids', note: undefined },
  { word: 'potential', note: 'note_potential' },
] as const;

export class View {
  readonly canvas = byIdAs('canvas', HTMLCanvasElement);
  private readonly select = byIdAs('view', HTMLSelectElement);
  private readonly context: CanvasRenderingContext2D;
  private readonly engine: Engine;
  private readonly store: Store;

  constructor(engine: Engine, store: Store) {
    this.engine = engine;
    this.store = store;
    const context = this.canvas.getContext('2d');
    if (!context) throw new Error('This browser gives no canvas to draw on.');
    this.context = context;
    this.select.replaceChildren(...VIEWS.map(({ word }) => make('option', { value: word }, t(`view_${word}`))));
    this.select.addEventListener('change', () => store.update({ view: this.select.value }));
    store.on(['view'], ({ view }) => (this.select.value = view));
  }

  /** What a drawing shows, in a sentence; '' for pictures. */
  get note(): string {
    const note = VIEWS.find(({ word }) => word === this.store.state.view)?.note;
    return note ? t(note) : '';
  }

  draw(): void {
    const side = this.engine.side();
    if (this.canvas.width !== side) {
      this.canvas.width = side;
      this.canvas.height = side;
    }
    const { view, overlays } = this.store.state;
    this.engine.draw(this.context, [view, ...overlays].join('+'));
  }
}
