/** The handles of a figure: a slider with a number box, buttons of a choice, points with two number boxes, and grips on plates. */
import { fixed, nameOf, pointName, rowsFor, shownOf } from '../draw/tools';
import type { Figure, Handle, Language, NumberHandle, PointHandle } from '../figures/figure';
import type { Place } from '../figures/place';
import { number } from '../figures/words';
import { Grips } from './grips';
import { afterKey, pointAfterKey, within } from './strides';

/** Parts of the figure that handles use. */
export interface Handled {
  readonly figure: Figure;
  readonly language: Language;
  /** The present value of a handle. */
  value(key: string): string;
  /** Sets a handle's value; `isOver` is false while a drag goes on. */
  change(key: string, text: string, isOver: boolean): void;
  /** The present points of a handle, in shares of the picture's side. */
  points(handle: PointHandle): readonly Place[];
  move(handle: PointHandle, row: number, to: Place, isOver: boolean): void;
  /** The place of a grip, in shares of its plate, and the numbers of a handle there. */
  gripAt(plate: number, key: string, numbers: readonly number[]): Place;
  numbersAt(plate: number, key: string, place: Place): readonly number[];
}

export class Handles {
  private readonly of: Handled;
  private readonly place: HTMLElement;
  private readonly grips: Grips;

  constructor(of: Handled, place: HTMLElement, signal: AbortSignal) {
    [this.of, this.place, this.grips] = [of, place, new Grips(place, signal)];
    for (const handle of this.all) {
      const box = this.boxOf(handle);
      if (!box) continue;
      if (handle.kind === 'choice') box.addEventListener('change', (event) => of.change(handle.key, (event.target as HTMLInputElement).value, true), { signal });
      else if (handle.kind === 'number') this.listen(handle, box, signal);
      else this.listenToPoint(handle, box, signal);
    }
  }

  private get all(): readonly Handle[] {
    return [...this.of.figure.handles, ...this.of.figure.more];
  }

  private boxOf({ key }: Handle): HTMLElement | null {
    return this.place.querySelector(`.handle[data-key="${key}"]`);
  }

  private listen(handle: NumberHandle, box: HTMLElement, signal: AbortSignal): void {
    const set = (value: number, isOver: boolean): void => this.of.change(handle.key, String(within(handle, value)), isOver);
    for (const input of box.querySelectorAll('input')) {
      const isBox = input.type === 'number';
      input.addEventListener('keydown', (event) => (isBox && isOfText(event)) || this.onKey(handle, event), { signal });
      if (!isBox) input.addEventListener('input', () => set(Number(input.value), false), { signal });
      input.addEventListener('change', () => (Number.isFinite(input.valueAsNumber) ? set(input.valueAsNumber, true) : this.show()), { signal });
    }
    for (const mark of box.querySelectorAll<HTMLElement>('.mark-key')) mark.addEventListener('click', () => set(Number(mark.dataset.value), true), { signal });
    for (const plate of handle.plates ?? []) this.grip(handle, plate, set);
  }

  private onKey(handle: NumberHandle, event: KeyboardEvent): void {
    const value = afterKey(handle, Number(this.of.value(handle.key)), event);
    if (value === undefined) return;
    event.preventDefault();
    this.of.change(handle.key, String(value), true);
  }

  private grip(handle: NumberHandle, plate: number, set: (value: number, isOver: boolean) => void): void {
    const { of } = this;
    const value = (): number => Number(of.value(handle.key));
    const { key, from, to, digits } = handle;
    this.grips.add({
      key,
      plate,
      label: nameOf(handle, of.language),
      place: () => of.gripAt(plate, key, [value()]),
      move: (place, isOver) => set(of.numbersAt(plate, key, place)[0] ?? value(), isOver),
      onKey: (event) => this.onKey(handle, event),
      said: () => ({ words: spoken(handle, value(), of.language), now: value().toFixed(digits), from, to }),
    });
  }

  private listenToPoint(handle: PointHandle, box: HTMLElement, signal: AbortSignal): void {
    const count = this.of.points(handle).length;
    for (const input of box.querySelectorAll('input')) {
      const axis = Number(input.dataset.axis);
      const set = (value: number): void => this.put(handle, this.row(handle), axis === 0 ? [value, this.shown(handle, this.row(handle))[1]] : [this.shown(handle, this.row(handle))[0], value], true);
      input.addEventListener('change', () => (Number.isFinite(input.valueAsNumber) ? set(input.valueAsNumber) : this.show()), { signal });
      input.addEventListener('keydown', (event) => isOfText(event) || this.inBox(handle, axis, event, set), { signal });
    }
    box.querySelector('select')?.addEventListener('change', () => this.show(), { signal });
    for (const plate of handle.plates) for (const row of rowsFor(handle, count)) this.pointGrip(handle, plate, row, count);
  }

  private inBox(handle: PointHandle, axis: number, event: KeyboardEvent, set: (value: number) => void): void {
    const value = afterKey(handle, this.shown(handle, this.row(handle))[axis] ?? 0, event);
    if (value === undefined) return;
    event.preventDefault();
    set(value);
  }

  private pointGrip(handle: PointHandle, plate: number, row: number, count: number): void {
    const { of } = this;
    const { key, from, to, digits } = handle;
    this.grips.add({
      key,
      plate,
      label: pointName(handle, of.language, row, count),
      place: () => of.gripAt(plate, key, of.points(handle)[row] ?? handle.origin),
      move: (place, isOver) => {
        const [x = 0, y = 0] = of.numbersAt(plate, key, place);
        this.put(handle, row, onLine(handle, shownOf(handle, [x, y])), isOver);
      },
      onKey: (event) => {
        const next = pointAfterKey(handle, this.shown(handle, row), event);
        if (!next) return;
        event.preventDefault();
        this.put(handle, row, next, true);
      },
      said: () => ({ words: this.spokenPoint(handle, row), now: this.shown(handle, row)[0].toFixed(digits), from, to }),
      taken: () => this.select(handle, row),
    });
  }

  /** The row that the boxes show. */
  private row(handle: PointHandle): number {
    return Number(this.boxOf(handle)?.querySelector('select')?.value ?? rowsFor(handle, 1)[0]);
  }

  private select(handle: PointHandle, row: number): void {
    const select = this.boxOf(handle)?.querySelector('select');
    if (!select || select.value === String(row)) return;
    select.value = String(row);
    this.show();
  }

  private shown(handle: PointHandle, row: number): Place {
    return shownOf(handle, this.of.points(handle)[row] ?? handle.origin);
  }

  /** Moves a point to coordinates as they are shown. */
  private put(handle: PointHandle, row: number, [x, y]: Place, isOver: boolean): void {
    const { origin, scale, from, to, area = [from, from, to, to] } = handle;
    const limited = (value: number, axis: 0 | 1): number => within({ ...handle, from: area[axis], to: area[axis + 2] ?? to }, value);
    this.of.move(handle, row, [origin[0] + scale * limited(x, 0), origin[1] + scale * limited(y, 1)], isOver);
  }

  private spokenPoint(handle: PointHandle, row: number): string {
    const [x, y] = this.shown(handle, row).map((value) => number(value, handle.digits));
    return `x ${x ?? ''}, y ${y ?? ''} ${handle.unit[this.of.language]}`.trim();
  }

  /** Shows the present values. */
  show(): void {
    for (const handle of this.all) {
      const box = this.boxOf(handle);
      if (box && handle.kind === 'point') this.fillPoint(handle, box);
      for (const input of (handle.kind !== 'point' && box?.querySelectorAll('input')) || []) {
        if (handle.kind === 'choice') input.checked = input.value === this.of.value(handle.key);
        else if (handle.kind === 'number') this.fill(input, handle, Number(this.of.value(handle.key)));
      }
    }
    this.grips.show();
  }

  private fill(input: HTMLInputElement, handle: NumberHandle, value: number): void {
    fillNumber(input, value.toFixed(handle.digits));
    if (input.type !== 'range') return;
    input.setAttribute('aria-valuetext', spoken(handle, value, this.of.language));
    input.style.setProperty('--share', String((value - handle.from) / (handle.to - handle.from)));
  }

  private fillPoint(handle: PointHandle, box: HTMLElement): void {
    const shown = this.shown(handle, this.row(handle));
    box.querySelectorAll('input').forEach((input, axis) => fillNumber(input, fixed(shown[axis] ?? 0, handle.digits)));
  }
}

/** A finger finds a line that is within this many fine strides. */
const FINDS = 2.5;

/** The place of a drag, which a near line takes. */
function onLine({ line, fine }: PointHandle, [x, y]: Place): Place {
  return line !== undefined && Math.abs(y - line) <= FINDS * fine ? [x, line] : [x, y];
}

/** Keys that move within the text of a box. */
const isOfText = ({ key }: KeyboardEvent): boolean => ['ArrowLeft', 'ArrowRight', 'Home', 'End'].includes(key);

/** Writes a number into an input, unless the same number is being typed there. */
function fillNumber(input: HTMLInputElement, text: string): void {
  const isTyped = input.type === 'number' && input === document.activeElement && Number(input.value) === Number(text);
  if (input.value !== text && !isTyped) input.value = text;
}

function spoken({ digits, unit }: NumberHandle, value: number, language: Language): string {
  return `${number(value, digits)} ${unit[language]}`.trim();
}
