/** Dragging the points of a free outline, over the canvas, by mouse, touch and keyboard. */
import { make } from './dom';
import { toSegment } from './simplify';
import type { Point, Ring } from './types';

const SVG = 'http://www.w3.org/2000/svg';

/** Picture units that an arrow key moves a point; with Shift ten times as many. */
const NUDGE = 1;

interface Place {
  ring: number;
  index: number;
}

export interface EditorNeeds {
  side(): number;
  /** Takes the outline over, or says why it cannot and answers false. */
  change(rings: Ring[]): boolean;
  closed(): void;
}

export class Editor {
  private readonly layer: HTMLElement;
  private readonly bar: HTMLElement;
  private readonly needs: EditorNeeds;
  private readonly lines = document.createElementNS(SVG, 'svg');
  private readonly edge = document.createElementNS(SVG, 'path');
  private readonly grip = document.createElementNS(SVG, 'path');
  private readonly handles = make('div', { class: 'handles' });
  private readonly remove = make('button', { type: 'button', title: 'Remove the marked point (Delete)' }, 'Remove point');
  private rings: Ring[] = [];
  private marked: Place = { ring: 0, index: 0 };
  private frame = 0;

  /** The layer lies over the canvas; the bar takes the buttons for the marked point. */
  constructor(layer: HTMLElement, bar: HTMLElement, needs: EditorNeeds) {
    this.layer = layer;
    this.bar = bar;
    this.needs = needs;
    this.edge.classList.add('edge');
    this.grip.classList.add('grip');
    this.lines.setAttribute('aria-hidden', 'true');
    this.lines.append(this.edge, this.grip);
    this.grip.addEventListener('dblclick', (event) => this.split(this.at(event)));
    layer.replaceChildren(this.lines, this.handles);
    this.fillBar();
    layer.addEventListener('keydown', (event) => {
      if (event.key === 'Escape') this.close();
    });
  }

  get active(): boolean {
    return !this.layer.hidden;
  }

  /** Shows handles on these rings. */
  open(rings: Ring[]): void {
    this.rings = rings.map((ring) => ring.map(([x, y]): Point => [x, y]));
    this.marked = { ring: 0, index: 0 };
    this.layer.hidden = false;
    this.bar.hidden = false;
    this.layer.classList.remove('bad');
    this.rebuild();
  }

  /** Puts the keyboard on the marked point. */
  focus(): void {
    const before = this.rings.slice(0, this.marked.ring).reduce((total, ring) => total + ring.length, 0);
    const handle = this.handles.children[before + this.marked.index];
    if (handle instanceof HTMLElement) handle.focus({ preventScroll: true });
  }

  close(): void {
    if (!this.active) return;
    this.layer.hidden = true;
    this.bar.hidden = true;
    this.needs.closed();
  }

  private fillBar(): void {
    const add = make('button', { type: 'button', title: 'Add a point after the marked one (Insert, or double click on an edge)' }, 'Add point');
    const done = make('button', { type: 'button', title: 'Leave the outline (Escape)' }, 'Done');
    add.addEventListener('click', () => this.addAfter(this.marked));
    this.remove.addEventListener('click', () => this.take(this.marked));
    done.addEventListener('click', () => this.close());
    this.bar.replaceChildren(add, this.remove, done);
  }

  private rebuild(): void {
    this.handles.replaceChildren();
    this.rings.forEach((ring, r) =>
      ring.forEach((_, index) => this.handles.append(this.handle({ ring: r, index }))),
    );
    this.place();
  }

  private handle(place: Place): HTMLButtonElement {
    const handle = make('button', { type: 'button', class: 'handle' });
    handle.addEventListener('focus', () => this.mark(place));
    handle.addEventListener('keydown', (event) => this.key(event, place));
    handle.addEventListener('pointerdown', (event) => {
      handle.setPointerCapture(event.pointerId);
      this.mark(place);
    });
    handle.addEventListener('pointermove', (event) => {
      if (handle.hasPointerCapture(event.pointerId)) this.move(place, this.at(event));
    });
    return handle;
  }

  /** Puts lines and handles where the points are. */
  private place(): void {
    const side = this.needs.side();
    this.lines.setAttribute('viewBox', `0 0 ${side} ${side}`);
    const path = this.rings.map((ring) => `M${ring.map(([x, y]) => `${x} ${y}`).join('L')}Z`).join('');
    this.edge.setAttribute('d', path);
    this.grip.setAttribute('d', path);
    let at = 0;
    this.rings.forEach((ring, r) =>
      ring.forEach(([x, y], index) => {
        const handle = this.handles.children[at++] as HTMLButtonElement;
        handle.style.left = `${(100 * x) / side}%`;
        handle.style.top = `${(100 * y) / side}%`;
        handle.setAttribute('aria-label', `Point ${index + 1} of ${ring.length}, ${ringName(r)}, at ${Math.round(x)}, ${Math.round(y)}`);
        handle.toggleAttribute('data-marked', this.marked.ring === r && this.marked.index === index);
      }),
    );
    this.remove.disabled = this.marked.ring === 0 && (this.rings[0]?.length ?? 0) <= 3;
  }

  private mark(place: Place): void {
    this.marked = place;
    this.place();
  }

  /** The picture's place under a pointer. */
  private at(event: MouseEvent): Point {
    const box = this.layer.getBoundingClientRect();
    const side = this.needs.side();
    return [((event.clientX - box.left) / box.width) * side, ((event.clientY - box.top) / box.height) * side];
  }

  private move({ ring, index }: Place, [x, y]: Point): void {
    const side = this.needs.side();
    const points = this.rings[ring];
    if (!points) return;
    points[index] = [Math.min(side, Math.max(0, x)), Math.min(side, Math.max(0, y))];
    this.changed();
  }

  private key(event: KeyboardEvent, place: Place): void {
    const point = this.rings[place.ring]?.[place.index];
    if (!point) return;
    const step = NUDGE * (event.shiftKey ? 10 : 1);
    const [x, y] = point;
    const moves: Record<string, () => void> = {
      ArrowLeft: () => this.move(place, [x - step, y]),
      ArrowRight: () => this.move(place, [x + step, y]),
      ArrowUp: () => this.move(place, [x, y - step]),
      ArrowDown: () => this.move(place, [x, y + step]),
      Delete: () => this.take(place),
      Backspace: () => this.take(place),
      Insert: () => this.addAfter(place),
    };
    const act = moves[event.key];
    if (!act) return;
    event.preventDefault();
    act();
  }

  private addAfter({ ring, index }: Place): void {
    const points = this.rings[ring];
    const here = points?.[index];
    const next = points?.[(index + 1) % points.length];
    if (!points || !here || !next) return;
    points.splice(index + 1, 0, [(here[0] + next[0]) / 2, (here[1] + next[1]) / 2]);
    this.restructured({ ring, index: index + 1 });
  }

  /** Adds a point on the edge nearest to this place. */
  private split(point: Point): void {
    let nearest = { ring: 0, index: 0, distance: Infinity };
    this.rings.forEach((ring, r) =>
      ring.forEach((from, index) => {
        const to = ring[(index + 1) % ring.length] ?? from;
        const distance = toSegment(point, from, to);
        if (distance < nearest.distance) nearest = { ring: r, index, distance };
      }),
    );
    this.rings[nearest.ring]?.splice(nearest.index + 1, 0, point);
    this.restructured({ ring: nearest.ring, index: nearest.index + 1 });
  }

  /** Takes a point away; the last three of a hole go together, those of the outer ring stay. */
  private take({ ring, index }: Place): void {
    const points = this.rings[ring];
    if (!points) return;
    if (points.length > 3) points.splice(index, 1);
    else if (ring > 0) this.rings.splice(ring, 1);
    else return;
    const left = this.rings[ring];
    this.restructured(left ? { ring, index: Math.min(index, left.length - 1) } : { ring: 0, index: 0 });
  }

  private restructured(marked: Place): void {
    this.marked = marked;
    this.rebuild();
    this.focus();
    this.changed();
  }

  /** Hands the outline over once a frame; a bad one stays drawn here, so that it can be mended. */
  private changed(): void {
    this.place();
    if (this.frame) return;
    this.frame = requestAnimationFrame(() => {
      this.frame = 0;
      this.layer.classList.toggle('bad', !this.needs.change(this.rings));
    });
  }
}

function ringName(ring: number): string {
  return ring === 0 ? 'outer ring' : `hole ${ring}`;
}
