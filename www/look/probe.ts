/** The probe: outlines the cell under the pointer, or the one that arrow keys reached, and shows its numbers. */
import type { Point, Probe } from '../module/types';
import { t } from '../words/look';
import { byId, make, say } from '../base/dom';
import { ARROWS } from '../late/arrows';
import { cellNumbers, cellRows } from '../late/cell';
import { shape } from '../late/svg';
import type { Engine } from '../state/engine';
import type { Store } from '../state/store';
import type { Work } from '../state/work';
import type { View } from '../picture/view';

/** A pointer rests for this many milliseconds before the first cell is shown. */
const REST = 120;

/** Arrow keys search for the next cell in steps of this many cell sizes. */
const STRIDE = 0.2;

/** The part of the zoom that the probe uses. */
interface Sight {
  busy(): boolean;
  reveal(place: { x: number; y: number }): void;
}

/** A place in one of the copies that stand side by side: `point` in units of the picture, `tile` as column and row. */
interface TiledPlace {
  point: Point;
  tile: Point;
}

export class CellProbe {
  private readonly engine: Engine;
  private readonly store: Store;
  private readonly sight: Sight;
  private readonly sheet = byId('sheet');
  private readonly layer = byId('cells');
  private readonly card = make('div', { class: 'cell-card', 'aria-hidden': 'true' });
  private readonly outline = [shape('path'), shape('path')];
  private readonly svg = shape('svg', { 'aria-hidden': 'true' }, ...this.outline);
  /** The place where the pointer rests, or that keys reached. */
  private place: TiledPlace | undefined;
  private cell: Probe | undefined;
  private pointer: { x: number; y: number } | undefined;
  private timer = 0;

  constructor(work: Work, view: View, sight: Sight) {
    this.engine = work.engine;
    this.store = work.store;
    this.sight = sight;
    this.card.hidden = true;
    this.layer.append(this.svg);
    this.sheet.append(this.card);
    this.sheet.addEventListener('pointermove', (event) => event.pointerType === 'mouse' && this.over(event));
    this.sheet.addEventListener('pointerleave', (event) => event.pointerType === 'mouse' && this.hide());
    this.layer.addEventListener('keydown', (event) => this.key(event));
    this.layer.addEventListener('blur', () => this.hide());
    view.drawn(() => this.place && this.tell());
    const follow = (): void => {
      const { editing, compare } = this.store.state;
      this.layer.hidden = editing !== undefined || compare || !this.engine.generator.offers.includes('probe');
      this.hide();
    };
    this.store.on(['make', 'editing', 'compare', 'repeat', 'view'], follow);
    follow();
  }

  /** The picture moved away from under a pointer. A cell that keys reached stays marked. */
  moved(): void {
    if (this.pointer) this.hide();
    else this.put();
  }

  hide(): void {
    clearTimeout(this.timer);
    this.timer = 0;
    this.place = undefined;
    this.cell = undefined;
    this.card.hidden = true;
    for (const path of this.outline) path.setAttribute('d', '');
  }

  /** The probe rests while the visitor draws, compares or moves the picture, and where the view shows no cells. */
  private get rests(): boolean {
    return this.layer.hidden !== false || this.sight.busy() || this.store.state.view === 'potential';
  }

  private over(event: PointerEvent): void {
    if (this.rests || !(event.target instanceof Node) || (event.target !== this.sheet && !byId('pane').contains(event.target))) return this.hide();
    this.pointer = { x: event.clientX, y: event.clientY };
    if (this.place) this.toPointer();
    else if (!this.timer) this.timer = window.setTimeout(() => this.toPointer(), REST);
  }

  /** A tap of a finger, or a click. */
  tap(event: MouseEvent): void {
    if (this.rests || !(event.target instanceof Node) || !this.layer.contains(event.target)) return;
    this.pointer = { x: event.clientX, y: event.clientY };
    this.toPointer();
  }

  private toPointer(): void {
    this.timer = 0;
    if (!this.pointer) return;
    const box = this.layer.getBoundingClientRect();
    const { repeat } = this.store.state;
    const along = [(this.pointer.x - box.left) / box.width, (this.pointer.y - box.top) / box.height].map((v) => v * repeat);
    const [x = 0, y = 0] = along;
    const tile: Point = [Math.floor(x), Math.floor(y)];
    const side = this.engine.side();
    this.place = { point: [(x - tile[0]) * side, (y - tile[1]) * side], tile };
    this.tell();
  }

  /** Shows the present cell at the place. */
  private tell(): void {
    if (!this.place) return;
    const { point, tile } = this.place;
    this.cell = this.engine.probe(point);
    const { cell } = this;
    this.card.hidden = !cell;
    const side = this.engine.side();
    const { repeat } = this.store.state;
    this.svg.setAttribute('viewBox', `0 0 ${side * repeat} ${side * repeat}`);
    const d = cell ? ring(cell.outline, tile[0] * side, tile[1] * side) : '';
    for (const path of this.outline) path.setAttribute('d', d);
    if (!cell) return;
    const rows = cellRows(cell);
    this.card.replaceChildren(...rows);
    this.put();
  }

  /** Puts the card beside the pointer, or beside the cell, within the sheet. */
  private put(): void {
    const { card, cell, place } = this;
    if (!cell || !place) return;
    const box = this.sheet.getBoundingClientRect();
    const pane = this.layer.getBoundingClientRect();
    const scale = pane.width / this.engine.side() / this.store.state.repeat;
    const at = this.pointer ?? { x: pane.left + cell.x * scale, y: pane.top + cell.y * scale };
    const gap = this.pointer ? 18 : 18 + (cell.size * scale) / 2;
    const along = (p: number, from: number, room: number, own: number): number => {
      const after = p - from + gap;
      return Math.max(0, after + own <= room ? after : Math.max(p - from - gap - own, 0));
    };
    card.style.left = `${along(at.x, box.left, box.width, card.offsetWidth)}px`;
    card.style.top = `${along(at.y, box.top, box.height, card.offsetHeight)}px`;
  }

  /** Arrow keys go to the next cell in their direction; the first press goes to the cell in the middle. */
  private key(event: KeyboardEvent): void {
    if (event.key === 'Escape') return this.hide();
    const way = ARROWS[event.key];
    if (!way || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    const side = this.engine.side();
    this.pointer = undefined;
    const point = this.cell ? this.beyond(this.cell, way, side) : this.nearest([side / 2, side / 2], side);
    if (!point) return say(byId('cell-said'), t('cell_none'));
    this.place = { point, tile: [0, 0] };
    this.tell();
    if (!this.cell) return;
    const { repeat } = this.store.state;
    this.sight.reveal({ x: point[0] / side / repeat, y: point[1] / side / repeat });
    say(byId('cell-said'), cellNumbers(this.cell).map((row) => row.join(' ')).join(', '));
  }

  /** The next cell straight ahead, or else one to either side of that direction. */
  private beyond(from: Probe, [dx, dy]: readonly [number, number], side: number): Point | undefined {
    const stride = STRIDE * from.size;
    for (const aside of [0, 0.5, -0.5, 1, -1]) {
      const [x, y] = [from.x - dy * aside * from.size, from.y + dx * aside * from.size];
      for (let far = 2; far * stride < side; far += 1) {
        const at: Point = [x + dx * far * stride, y + dy * far * stride];
        if (at.some((v) => v < 0 || v > side)) break;
        const found = this.engine.probe(at);
        if (found && found.cell !== from.cell && (found.x - from.x) * dx + (found.y - from.y) * dy > 0.1 * from.size) return at;
      }
    }
    return undefined;
  }

  /** A place in the cell nearest to this place, searched for in rings around it. */
  private nearest([x, y]: Point, side: number): Point | undefined {
    for (let far = 0; far < side / 2; far += side / 64) {
      for (let k = 0; k < 12; k += 1) {
        const at: Point = [x + far * Math.cos((k * Math.PI) / 6), y + far * Math.sin((k * Math.PI) / 6)];
        if (this.engine.probe(at)) return at;
      }
    }
    return undefined;
  }
}

function ring(numbers: Float64Array, dx: number, dy: number): string {
  const points: string[] = [];
  for (let k = 0; k + 1 < numbers.length; k += 2) points.push(`${((numbers[k] ?? 0) + dx).toFixed(2)} ${((numbers[k + 1] ?? 0) + dy).toFixed(2)}`);
  return points.length ? `M${points.join('L')}Z` : '';
}
