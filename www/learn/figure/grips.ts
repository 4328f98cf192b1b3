/**
 * Grips on plates. A finger drags a grip; elsewhere it scrolls the page. A tap on a plate moves a grip there: the one
 * that was tapped before, or else the nearest of those that belong to the plate's first handle.
 */
import { markAt } from '../figures/marks';
import type { Place } from '../figures/place';

/** A point on a plate that a handle follows; places are in shares of the plate's width and height. */
interface Gripped {
  readonly key: string;
  readonly plate: number;
  readonly label: string;
  place(): Place;
  move(to: Place, isOver: boolean): void;
  onKey(event: KeyboardEvent): void;
  /** The value of the grip, in words and as a number between limits. */
  said(): { readonly words: string; readonly now: string; readonly from: number; readonly to: number };
  /** Called when the grip is pressed. */
  taken?(): void;
}

/** One grip. Its element lies in a carrier as large as the plate, which moves as a whole, so that the layout stays. */
class Grip {
  readonly of: Gripped;
  readonly element = document.createElement('div');
  private readonly carrier = document.createElement('div');
  private hasMoved = false;

  constructor(of: Gripped, box: HTMLElement, signal: AbortSignal) {
    this.of = of;
    const { element, carrier } = this;
    element.className = `grip grip-${of.key}`;
    // The grip is shown once it has a value.
    element.hidden = true;
    element.tabIndex = 0;
    element.role = 'slider';
    element.ariaLabel = of.label;
    carrier.className = 'grip-carrier';
    carrier.append(element);
    box.append(carrier);
    this.listen(box, signal);
    signal.addEventListener('abort', () => carrier.remove());
  }

  private listen(box: HTMLElement, signal: AbortSignal): void {
    const { element, of } = this;
    const holds = ({ pointerId }: PointerEvent): boolean => element.hasPointerCapture(pointerId);
    element.addEventListener('pointerdown', ({ pointerId }) => this.take(pointerId), { signal });
    element.addEventListener('pointermove', (event) => holds(event) && this.drag(placeOn(box, event)), { signal });
    element.addEventListener('pointerup', (event) => holds(event) && this.hasMoved && of.move(placeOn(box, event), true), { signal });
    element.addEventListener('keydown', (event) => of.onKey(event), { signal });
    element.addEventListener('focus', () => of.taken?.(), { signal });
  }

  private take(pointer: number): void {
    this.hasMoved = false;
    this.element.setPointerCapture(pointer);
    this.of.taken?.();
  }

  private drag(to: Place): void {
    const [x, y] = this.of.place();
    // A finger is never quite still.
    this.hasMoved ||= Math.hypot(to[0] - x, to[1] - y) > 0.01;
    if (this.hasMoved) this.of.move(to, false);
  }

  /** Whether the last touch was a tap. */
  get wasTapped(): boolean {
    return !this.hasMoved;
  }

  show(): void {
    const [x, y] = this.of.place();
    const { words, now, from, to } = this.of.said();
    this.element.hidden = false;
    this.carrier.style.transform = `translate(${100 * x}%, ${100 * y}%)`;
    this.element.ariaValueMin = String(from);
    this.element.ariaValueMax = String(to);
    this.element.ariaValueNow = now;
    this.element.ariaValueText = words;
  }
}

function placeOn(box: HTMLElement, { clientX, clientY }: MouseEvent): Place {
  const { left, top, width, height } = box.getBoundingClientRect();
  return [(clientX - left) / width, (clientY - top) / height];
}

/** All grips of a figure. */
export class Grips {
  private readonly plates = new Map<HTMLElement, Grip[]>();
  private readonly place: HTMLElement;
  private readonly signal: AbortSignal;
  private chosen: Grip | undefined;

  constructor(place: HTMLElement, signal: AbortSignal) {
    [this.place, this.signal] = [place, signal];
  }

  add(gripped: Gripped): void {
    const box = this.place.querySelector<HTMLElement>(`.plate-box[data-plate="${gripped.plate}"]`);
    if (!box) return;
    const grips = this.plates.get(box) ?? [];
    if (!grips.length) box.addEventListener('click', (event) => this.tap(box, grips, event), { signal: this.signal });
    this.plates.set(box, grips);
    grips.push(new Grip(gripped, box, this.signal));
  }

  private tap(box: HTMLElement, grips: readonly Grip[], event: MouseEvent): void {
    const own = grips.find(({ element }) => element === event.target);
    if (own) return this.choose(grips.length > 1 && own.wasTapped && own !== this.chosen ? own : undefined);
    const to = placeOn(box, event);
    const chosen = grips.find((grip) => grip === this.chosen) ?? nearest(grips, to);
    this.choose(undefined);
    chosen?.of.move(to, true);
  }

  /** The grip that the next tap moves. */
  private choose(grip: Grip | undefined): void {
    this.chosen?.element.classList.remove('chosen');
    grip?.element.classList.add('chosen');
    this.chosen = grip;
  }

  show(): void {
    for (const grip of [...this.plates.values()].flat()) grip.show();
  }
}

/** The nearest grip of the first handle. Marks stand in rows, so for them only the vertical distance counts. */
function nearest(grips: readonly Grip[], [x, y]: Place): Grip | undefined {
  const first = grips[0]?.of.key ?? '';
  const areMarks = markAt(first) !== undefined;
  const far = ({ of }: Grip): number => Math.hypot(areMarks ? 0 : of.place()[0] - x, of.place()[1] - y);
  return grips.filter(({ of }) => of.key === first || (areMarks && markAt(of.key) !== undefined)).sort((a, b) => far(a) - far(b))[0];
}
