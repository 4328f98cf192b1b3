/** Zoom and pan by wheel, two fingers, drag, double click and buttons. Handles over the picture keep their size. */
import { byId, say } from '../base/dom';
import type { Store } from '../state/store';
import { inFrame, LIMITS } from '../state/asked-view';
import { WHOLE, type Zoomed } from '../state/viewing';
import { layInFrame } from '../picture/frame';

/** The factor of a button press, and of a double click. */
const STEP = 1.5;
const CLOSER = 3;

/** A pointer that moves less than this many pixels has clicked. */
const SLACK = 4;

/** Elements over the picture that handle pointers themselves. */
const OWN = 'button, input, select, [role=slider], .grip';

/** A place on the sheet or in the picture, in sides of it: x to the right, y down. */
export interface SheetPlace {
  x: number;
  y: number;
}

export class Zoom {
  private readonly sheet: HTMLElement;
  private readonly store: Store;
  private readonly moved: () => void;
  private readonly down = new Map<number, SheetPlace>();
  private begun: SheetPlace | undefined;

  /** `moved` is called after each zoom or pan. All sheets show the same part of their pictures. */
  constructor(store: Store, moved: () => void, sheet = byId('sheet')) {
    this.sheet = sheet;
    this.store = store;
    this.moved = moved;
    store.on(['zoom'], () => this.show());
    if (store.state.zoom !== WHOLE) this.show();
    sheet.addEventListener('wheel', (event) => this.wheel(event), { passive: false });
    sheet.addEventListener('dblclick', (event) => this.twice(event));
    sheet.addEventListener('pointerdown', (event) => this.press(event));
    sheet.addEventListener('pointermove', (event) => this.move(event));
    for (const end of ['pointerup', 'pointercancel'] as const) sheet.addEventListener(end, (event) => this.release(event));
    // The gesture goes on where another element loses the pointer to the sheet.
    sheet.addEventListener('lostpointercapture', (event) => event.target === sheet && this.release(event));
  }

  /** The picture is being moved. */
  get busy(): boolean {
    return 'panning' in this.sheet.dataset;
  }

  private get scale(): number {
    return this.store.state.zoom.scale;
  }

  /** The picture's upper left corner, in sides of the sheet. */
  private get corner(): SheetPlace {
    const { scale, x, y } = this.store.state.zoom;
    return { x: 0.5 - x * scale, y: 0.5 - y * scale };
  }

  /** Zooms in (1), out (-1), or all the way out (0). */
  step(by: number): void {
    this.to(by ? this.scale * STEP ** by : 1, { x: 0.5, y: 0.5 });
  }

  /** Brings a place, in sides of the picture, into view. */
  reveal({ x, y }: SheetPlace): void {
    const inward = (at: number, corner: number): number => {
      const seen = corner + at * this.scale;
      return seen < 0.1 || seen > 0.9 ? 0.5 - at * this.scale : corner;
    };
    this.take(this.scale, { x: inward(x, this.corner.x), y: inward(y, this.corner.y) });
  }

  /** Zooms about a place of the sheet, in its sides, with the picture's corner dragged to `corner`. */
  private to(zoom: number, at: SheetPlace, corner = this.corner): void {
    const [least, most] = LIMITS.zoom;
    const next = Math.min(Math.max(zoom, least), most);
    const ratio = next / this.scale;
    // A zoom just above 1 counts as 1, so that one finger scrolls the page again.
    this.take(next < 1.01 ? 1 : next, { x: at.x - (at.x - corner.x) * ratio, y: at.y - (at.y - corner.y) * ratio });
  }

  private take(scale: number, corner: SheetPlace): void {
    const zoom = inFrame({ scale, x: (0.5 - corner.x) / scale, y: (0.5 - corner.y) / scale });
    if (!isSame(zoom, this.store.state.zoom)) this.store.update({ zoom });
  }

  private show(): void {
    const { scale } = this;
    layInFrame(this.sheet, this.store.state.zoom);
    say(byId('zoom-now'), `${scale < 9.95 ? Number(scale.toFixed(1)) : Math.round(scale)}×`);
    this.moved();
  }

  private at({ clientX, clientY }: MouseEvent): SheetPlace {
    const box = this.sheet.getBoundingClientRect();
    return { x: (clientX - box.left) / box.width, y: (clientY - box.top) / box.height };
  }

  /** Zooms by the wheel. All the way out, the wheel scrolls the page again. */
  wheel(event: WheelEvent): void {
    const { deltaY, deltaMode, ctrlKey } = event;
    if (deltaY > 0 && this.scale === 1 && !ctrlKey) return;
    event.preventDefault();
    const lines = deltaMode === WheelEvent.DOM_DELTA_LINE ? 30 : 1;
    this.to(this.scale * Math.exp(-deltaY * lines * (ctrlKey ? 0.01 : 0.002)), this.at(event));
  }

  /** A double click zooms in, or all the way out. */
  twice(event: MouseEvent): void {
    if (this.wanted(event) || this.store.state.editing !== undefined) return;
    if (this.scale > 1) this.step(0);
    else this.to(CLOSER, this.at(event));
  }

  /** Whether an element over the picture handles the pointer itself. */
  private wanted({ target }: Event): boolean {
    return !(target instanceof Element) || target.closest(OWN) !== null;
  }

  private press(event: PointerEvent): void {
    const touch = event.pointerType === 'touch';
    const middle = event.button === 1;
    if (this.wanted(event) && !touch) return;
    // While the visitor draws, one pointer draws. The middle button and two fingers still move the picture.
    const drawing = this.store.state.editing !== undefined || this.wanted(event);
    if (!touch && (drawing ? !middle : event.button > 1)) return;
    if (middle) event.preventDefault();
    this.down.set(event.pointerId, this.at(event));
    this.begun = this.down.size === 1 && !(drawing && touch) ? this.at(event) : undefined;
  }

  private move(event: PointerEvent): void {
    const { pointerId, pointerType, buttons } = event;
    // A button that rose outside of the sheet, before it dragged the picture, is not heard there.
    if (pointerType !== 'touch' && !buttons) this.release(event);
    const now = this.at(event);
    const before = this.down.get(pointerId);
    if (!before) {
      // The finger came down before this part was loaded.
      if (pointerType === 'touch' && buttons) this.down.set(pointerId, now);
      return;
    }
    const other = [...this.down].find(([id]) => id !== pointerId)?.[1];
    this.down.set(pointerId, now);
    if (other) return this.pinch(before, now, other);
    if (this.scale === 1 || !this.begun) return;
    const { width } = this.sheet.getBoundingClientRect();
    const far = Math.hypot(now.x - this.begun.x, now.y - this.begun.y) * width > SLACK;
    if (!this.busy && !far) return;
    if (!this.busy) {
      this.sheet.setPointerCapture(pointerId);
      this.sheet.toggleAttribute('data-panning', true);
    }
    this.take(this.scale, { x: this.corner.x + now.x - before.x, y: this.corner.y + now.y - before.y });
  }

  /** Zooms and pans by two fingers: the picture stays under both. */
  private pinch(before: SheetPlace, now: SheetPlace, other: SheetPlace): void {
    this.sheet.toggleAttribute('data-panning', true);
    const apart = (p: SheetPlace): number => Math.max(0.02, Math.hypot(p.x - other.x, p.y - other.y));
    const middle = { x: (before.x + other.x) / 2, y: (before.y + other.y) / 2 };
    const by = { x: (now.x - before.x) / 2, y: (now.y - before.y) / 2 };
    this.to((this.scale * apart(now)) / apart(before), { x: middle.x + by.x, y: middle.y + by.y }, { x: this.corner.x + by.x, y: this.corner.y + by.y });
  }

  private release({ pointerId }: PointerEvent): void {
    if (!this.down.delete(pointerId)) return;
    // A finger that stays down goes on moving the picture.
    this.begun = [...this.down.values()][0];
    if (!this.down.size) this.sheet.toggleAttribute('data-panning', false);
  }
}

function isSame(a: Zoomed, b: Zoomed): boolean {
  return a.scale === b.scale && a.x === b.x && a.y === b.y;
}
