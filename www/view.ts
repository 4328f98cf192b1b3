/** The canvas: its size, what it shows, and saving it. */
import { byIdAs, make } from './dom';
import type { Engine } from './engine';

/** The views in the order of their keys 0 to 8. */
export const VIEWS: readonly { word: string; label: string }[] = [
  { word: 'auto', label: 'As it forms' },
  { word: 'picture', label: 'Picture' },
  { word: 'packed', label: 'Packing' },
  { word: 'cells', label: 'Cells' },
  { word: 'mesh', label: 'Mesh' },
  { word: 'direction', label: 'Directions' },
  { word: 'height', label: 'Height' },
  { word: 'normals', label: 'Normals' },
  { word: 'ids', label: 'Cell ids' },
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
    const url = URL.createObjectURL(blob);
    const anchor = make('a', { href: url, download: `${name}.png` });
    anchor.click();
    setTimeout(() => URL.revokeObjectURL(url), 60_000);
    return true;
  }
}
