/** The canvas: its size, what it shows, and saving it. */
import { byIdAs, make } from './dom';
import { offer } from './download';
import type { Engine } from './engine';

/** The views in the order of their keys 0 to 9, those of drawings with what they show. */
export const VIEWS: readonly { word: string; label: string; note?: string }[] = [
  { word: 'auto', label: 'As it forms' },
  { word: 'picture', label: 'Picture' },
  { word: 'packed', label: 'Packing', note: 'The cells as they are packed: warmer where neighbours press into them, bluer where there is room beside them.' },
  { word: 'cells', label: 'Cells', note: 'One polygon for each cell; together they fill the outline.' },
  { word: 'mesh', label: 'Mesh', note: 'The mesh that joins neighbours: quadrilaterals for cells with corners, triangles for round ones; lone triangles in orange.' },
  { word: 'direction', label: 'Fields', note: 'Directions (crosses as long as cells), lines, strokes in green, spots as rings; points where rows meet, with their index.' },
  { word: 'height', label: 'Height' },
  { word: 'normals', label: 'Normals' },
  { word: 'ids', label: 'Cell ids' },
  { word: 'potential', label: 'Potential', note: 'What a neighbour feels around one cell: it rolls off the red hill and comes to rest in the blue, where dots are.' },
];

export class View {
  readonly canvas = byIdAs('canvas', HTMLCanvasElement);
  private readonly select = byIdAs('view', HTMLSelectElement);
  private readonly context: CanvasRenderingContext2D;
  private readonly engine: Engine;

  constructor(engine: Engine, changed: () => void) {
    this.engine = engine;
    const context = this.canvas.getContext('2d');
    if (!context) throw new Error('This browser gives no canvas to draw on.');
    this.context = context;
    this.select.replaceChildren(...VIEWS.map(({ word, label }) => make('option', { value: word }, label)));
    this.select.addEventListener('change', changed);
  }

  get word(): string {
    return this.select.value;
  }

  set word(word: string) {
    this.select.value = word;
    this.select.dispatchEvent(new Event('change'));
  }

  /** What a drawing shows, in a sentence; '' for pictures. */
  get note(): string {
    return VIEWS.find(({ word }) => word === this.word)?.note ?? '';
  }

  draw(): void {
    const side = this.engine.side();
    if (this.canvas.width !== side) {
      this.canvas.width = side;
      this.canvas.height = side;
    }
    this.engine.draw(this.context, this.word);
  }

  /** Hands what is shown to the visitor as a PNG file; false where the browser cannot. */
  async save(name: string): Promise<boolean> {
    const blob = await new Promise<Blob | null>((resolve) => this.canvas.toBlob(resolve, 'image/png'));
    if (!blob) return false;
    offer(blob, `${name}.png`);
    return true;
  }
}
