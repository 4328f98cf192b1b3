/** The handles of a figure: a slider with a number box, buttons of a choice, and grips on plates. */
import { nameOf } from '../draw/tools';
import { toW, WIDTH } from '../draw/plate';
import type { Figure, Language, NumberHandle } from '../figures/figure';
import { number } from '../figures/words';
import { afterKey, within } from './strides';

/** Parts of the figure that handles use. */
export interface Handled {
  readonly figure: Figure;
  readonly language: Language;
  /** The value of a handle as it stands. */
  value(key: string): string;
  /** Sets it; `isOver` is false while a drag goes on. */
  change(key: string, text: string, isOver: boolean): void;
  /** The place of a grip, in shares of its plate. */
  gripAt(plate: number, key: string): readonly [number, number];
}

interface Grip {
  readonly element: HTMLElement;
  /** As large as its plate, and moved as a whole, so that the layout stays. */
  readonly carrier: HTMLElement;
  readonly handle: NumberHandle;
  readonly plate: number;
}

export class Handles {
  private readonly of: Handled;
  private readonly place: HTMLElement;
  private readonly grips: Grip[] = [];

  constructor(of: Handled, place: HTMLElement, signal: AbortSignal) {
    [this.of, this.place] = [of, place];
    for (const handle of [...of.figure.handles, ...of.figure.more]) {
      const box = place.querySelector<HTMLElement>(`.handle[data-key="${handle.key}"]`);
      if (!box) continue;
      if (handle.kind === 'choice') box.addEventListener('change', (event) => of.change(handle.key, (event.target as HTMLInputElement).value, true), { signal });
      else this.listen(handle, box, signal);
    }
  }

  private listen(handle: NumberHandle, box: HTMLElement, signal: AbortSignal): void {
    const set = (value: number, isOver: boolean): void => this.of.change(handle.key, String(within(handle, value)), isOver);
    for (const input of box.querySelectorAll('input')) {
      const isBox = input.type === 'number';
      input.addEventListener('keydown', (event) => this.onKey(handle, event, isBox), { signal });
      if (!isBox) input.addEventListener('input', () => set(Number(input.value), false), { signal });
      input.addEventListener('change', () => (Number.isFinite(input.valueAsNumber) ? set(input.valueAsNumber, true) : this.show()), { signal });
    }
    for (const plate of handle.plates ?? []) this.grip(handle, plate, set, signal);
  }

  private onKey(handle: NumberHandle, event: KeyboardEvent, isBox: boolean): void {
    if (isBox && ['ArrowLeft', 'ArrowRight', 'Home', 'End'].includes(event.key)) return;
    const value = afterKey(handle, Number(this.of.value(handle.key)), event);
    if (value === undefined) return;
    event.preventDefault();
    this.of.change(handle.key, String(value), true);
  }

  /** A grip takes the finger; a tap elsewhere on its plate moves it there, and the page scrolls as ever. */
  private grip(handle: NumberHandle, plate: number, set: (value: number, isOver: boolean) => void, signal: AbortSignal): void {
    const box = this.place.querySelector<HTMLElement>(`.plate-box[data-plate="${plate}"]`);
    if (!box) return;
    const element = document.createElement('div');
    element.className = `grip grip-${handle.key}`;
    // It is there once it has a value.
    element.hidden = true;
    element.tabIndex = 0;
    element.role = 'slider';
    element.ariaLabel = nameOf(handle, this.of.language);
    const carrier = document.createElement('div');
    carrier.className = 'grip-carrier';
    carrier.append(element);
    box.append(carrier);
    this.grips.push({ element, carrier, handle, plate });
    const at = ({ clientX }: MouseEvent): number => {
      const { left, width } = box.getBoundingClientRect();
      return toW(((clientX - left) / width) * WIDTH);
    };
    element.addEventListener('pointerdown', (event) => element.setPointerCapture(event.pointerId), { signal });
    element.addEventListener('pointermove', (event) => element.hasPointerCapture(event.pointerId) && set(at(event), false), { signal });
    element.addEventListener('pointerup', (event) => element.hasPointerCapture(event.pointerId) && set(at(event), true), { signal });
    element.addEventListener('keydown', (event) => this.onKey(handle, event, false), { signal });
    box.addEventListener('click', (event) => event.target !== element && set(at(event), true), { signal });
    signal.addEventListener('abort', () => carrier.remove());
  }

  /** Shows the values as they stand. */
  show(): void {
    for (const handle of [...this.of.figure.handles, ...this.of.figure.more]) {
      const box = this.place.querySelector<HTMLElement>(`.handle[data-key="${handle.key}"]`);
      const text = this.of.value(handle.key);
      for (const input of box?.querySelectorAll('input') ?? []) {
        if (handle.kind === 'choice') input.checked = input.value === text;
        else this.fill(input, handle, Number(text));
      }
    }
    for (const grip of this.grips) this.put(grip);
  }

  private fill(input: HTMLInputElement, handle: NumberHandle, value: number): void {
    const text = value.toFixed(handle.digits);
    if (input.value !== text && !(input.type === 'number' && input === document.activeElement && Number(input.value) === Number(text))) input.value = text;
    if (input.type === 'range') {
      input.setAttribute('aria-valuetext', spoken(handle, value, this.of.language));
      input.style.setProperty('--share', String((value - handle.from) / (handle.to - handle.from)));
    }
  }

  private put({ element, carrier, handle, plate }: Grip): void {
    const [x, y] = this.of.gripAt(plate, handle.key);
    const value = Number(this.of.value(handle.key));
    element.hidden = false;
    carrier.style.transform = `translate(${100 * x}%, ${100 * y}%)`;
    element.ariaValueMin = String(handle.from);
    element.ariaValueMax = String(handle.to);
    element.ariaValueNow = value.toFixed(handle.digits);
    element.ariaValueText = spoken(handle, value, this.of.language);
  }
}

function spoken({ digits, unit }: NumberHandle, value: number, language: Language): string {
  return `${number(value, digits)} ${unit[language]}`.trim();
}
