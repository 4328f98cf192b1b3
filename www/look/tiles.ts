/** Shows the picture two or three times side by side, as a seamless tile repeats. */
import { byId, make } from '../base/dom';
import type { Store } from '../state/store';
import type { View } from '../picture/view';
import '../styles/late/look.css';

/** Most pixels along the side of all copies together. */
const MOST = 3072;

export class Tiles {
  private readonly store: Store;
  private readonly view: View;
  private readonly canvas = make('canvas', { class: 'tiles', 'aria-hidden': 'true' });

  constructor(store: Store, view: View) {
    this.store = store;
    this.view = view;
    this.canvas.hidden = true;
    view.canvas.after(this.canvas);
    view.drawn(() => this.draw());
    store.on(['editing', 'compare'], () => this.follow());
  }

  follow(): void {
    const { repeat, editing, compare } = this.store.state;
    if (repeat > 1 && (editing !== undefined || compare)) return this.store.update({ repeat: 1 });
    this.canvas.hidden = repeat === 1;
    this.draw();
    byId('sheet').toggleAttribute('data-tiled', repeat > 1);
  }

  private draw(): void {
    const { canvas } = this;
    if (canvas.hidden) return;
    const { repeat } = this.store.state;
    const from = this.view.canvas;
    const side = Math.min(from.width * repeat, MOST);
    if (canvas.width !== side) canvas.width = canvas.height = side;
    const context = canvas.getContext('2d');
    if (!context) return;
    context.imageSmoothingQuality = 'high';
    const at = (k: number): number => Math.round((k * side) / repeat);
    for (let k = 0; k < repeat * repeat; k += 1) {
      const [column, row] = [k % repeat, Math.floor(k / repeat)];
      context.drawImage(from, at(column), at(row), at(column + 1) - at(column), at(row + 1) - at(row));
    }
  }
}
