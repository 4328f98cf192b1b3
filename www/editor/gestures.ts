/** Presses, drags and double clicks over the canvas, by mouse, pen or finger. */
import type { Point } from '../module/types';
import type { EditedFigures } from './edited';
import type { FigurePoint } from './geometry/figures';
import { DOUBLE, Pen } from './pen';
import type { SheetPart } from './sheet';

/**
 * A press that moves by SLACK CSS pixels, or twice that by finger, is a drag. Two presses closer than NEAR are at one
 * place.
 */
const SLACK = 3;
const NEAR = 9;
const NEAR_FOR_FINGERS = 24;

type Hold = { pointer: number; x: number; y: number; moved: boolean; finger: boolean } & (
  | { holds: 'point'; place: FigurePoint; twice: boolean }
  | { holds: 'figure'; figure: number; last: Point }
  | { holds: 'knob'; figure: number }
  | { holds: 'pen' }
  | { holds: 'seed' }
);

export class Gestures {
  private readonly figures: EditedFigures;
  private hold: Hold | undefined;
  private pen: Pen | undefined;
  private before = { time: -Infinity, x: 0, y: 0 };

  constructor(figures: EditedFigures) {
    this.figures = figures;
    const { layer } = figures.sheet;
    layer.addEventListener('pointerdown', (event) => this.down(event));
    // A pressed point has the focus now. Browsers would take it away from some buttons, and from a point that this press made.
    layer.addEventListener('mousedown', (event) => this.hold?.holds === 'point' && event.preventDefault());
    layer.addEventListener('pointermove', (event) => this.move(event));
    layer.addEventListener('pointerup', (event) => this.up(event));
    layer.addEventListener('lostpointercapture', (event) => this.lost(event));
  }

  /** A line is being drawn. */
  get drawing(): boolean {
    return this.pen?.open ?? false;
  }

  reset(): void {
    this.hold = undefined;
    this.pen = undefined;
    this.before.time = -Infinity;
    this.draft();
  }

  /** Ends the figure being drawn as it is. */
  finish(): void {
    const figure = this.pen?.finish();
    this.draft();
    if (figure) this.figures.add({ ...figure, value: this.figures.firstValue });
    else this.figures.follow();
  }

  cancel(): void {
    this.hold = undefined;
    this.pen?.cancel();
    this.draft();
    if (this.figures.armed) this.figures.disarm();
    this.figures.follow();
  }

  /** While drawing, Enter ends the figure, Escape cancels it, and Backspace or undo removes its last point. */
  key({ key, ctrlKey, metaKey, shiftKey }: KeyboardEvent): boolean {
    if (!this.pen?.open && !(this.figures.armed && key === 'Escape')) return false;
    const undo = key.toLowerCase() === 'z' && (ctrlKey || metaKey) && !shiftKey;
    if (key === 'Escape') this.cancel();
    else if (key === 'Enter') this.finish();
    else if (undo || key === 'Backspace' || key === 'Delete') this.pen?.back();
    else return false;
    this.draft();
    this.figures.follow();
    return true;
  }

  private down(event: PointerEvent): void {
    const { figures } = this;
    if (this.hold) return this.second();
    // A finger beside another one draws nothing, even if the browser has taken the first one over.
    if (event.button !== 0 || !event.isPrimary) return;
    const at = figures.sheet.at(event, figures.side);
    const finger = event.pointerType === 'touch';
    const twice = event.timeStamp - this.before.time < DOUBLE && Math.hypot(event.clientX - this.before.x, event.clientY - this.before.y) < (finger ? NEAR_FOR_FINGERS : NEAR);
    this.before = { time: event.timeStamp, x: event.clientX, y: event.clientY };
    // A figure may begin and go on anywhere: an island in a hole, or a line over another one.
    const part: SheetPart = this.pen?.open || figures.armed ? { part: 'nothing' } : figures.sheet.part(event.target);
    const common = { pointer: event.pointerId, x: event.clientX, y: event.clientY, moved: false, finger };
    if (part.part === 'point') {
      this.hold = { ...common, holds: 'point', place: part.place, twice };
      figures.mark(part.place);
      figures.focus();
    } else if (part.part === 'edge') {
      const { figure, index } = part.place;
      // Adding a point and dragging it is one step of the history.
      figures.hold();
      figures.addAfter(part.place);
      this.before.time = -Infinity;
      this.hold = { ...common, holds: 'point', place: { figure, index: index + 1 }, twice: false };
    } else if (part.part === 'knob') {
      this.hold = { ...common, holds: 'knob', figure: part.figure };
    } else if (part.part === 'line' && twice) {
      this.before.time = -Infinity;
      figures.split(part.figure, at);
    } else if (part.part === 'line' && figures.loose(part.figure)) {
      this.hold = { ...common, holds: 'figure', figure: part.figure, last: at };
      figures.mark({ figure: part.figure, index: 0 });
    } else if (part.part === 'nothing') {
      this.begin(common, at, event.shiftKey);
    }
    if (!this.hold) return;
    figures.sheet.layer.setPointerCapture(event.pointerId);
    figures.sheet.layer.toggleAttribute('data-busy', part.part !== 'nothing');
  }

  /** Handles a press on the canvas itself. */
  private begin(common: Omit<Hold, 'holds' | 'place' | 'twice' | 'figure' | 'last'>, at: Point, snaps: boolean): void {
    const { figures } = this;
    const form = figures.sort?.form;
    if (form === 'seed') this.hold = { ...common, holds: 'seed' };
    else if (form === 'line' || form === 'spot' || (form === 'ring' && figures.armed)) {
      this.pen ??= new Pen(form, figures.side);
      this.pen.press(figures.snapped(at, snaps, undefined, this.pen.last));
      this.hold = { ...common, holds: 'pen' };
      figures.sheet.layer.focus({ preventScroll: true });
    }
  }

  /** A second finger ends the drag: two fingers move the picture, not its points. */
  private second(): void {
    const pen = this.hold?.holds === 'pen';
    this.hold = undefined;
    if (pen) {
      this.pen?.lift();
      this.draft();
      this.figures.follow();
    }
    this.figures.drop();
  }

  private move(event: PointerEvent): void {
    const { figures, hold } = this;
    const raw = figures.sheet.at(event, figures.side);
    if (!hold) {
      if (!this.pen?.open || event.pointerType === 'touch') return;
      this.pen.hover(figures.snapped(raw, event.shiftKey, undefined, this.pen.last));
      return this.draft();
    }
    if (hold.pointer !== event.pointerId) return;
    if (!hold.moved && Math.hypot(event.clientX - hold.x, event.clientY - hold.y) < SLACK * (hold.finger ? 2 : 1)) return;
    hold.moved = true;
    if (hold.holds === 'seed') return;
    if (hold.holds === 'pen') {
      this.pen?.draw(figures.snapped(raw, event.shiftKey, undefined, this.pen.last), event.shiftKey);
      return this.draft();
    }
    figures.hold();
    if (hold.holds === 'point') figures.move(hold.place, figures.snapped(raw, event.shiftKey, hold.place));
    else if (hold.holds === 'knob') figures.widen(hold.figure, raw);
    else {
      const at = figures.snapped(raw, false, undefined);
      figures.shift(hold.figure, [at[0] - hold.last[0], at[1] - hold.last[1]]);
      hold.last = at;
    }
  }

  private up(event: PointerEvent): void {
    const { figures, hold } = this;
    if (hold?.pointer !== event.pointerId) return;
    this.hold = undefined;
    if (hold.moved) this.before.time = -Infinity;
    if (hold.holds === 'pen') this.ink(hold, event);
    else if (hold.holds === 'seed' && !hold.moved) figures.addFigure(figures.sheet.at(event, figures.side));
    else if (hold.holds === 'point' && hold.twice && !hold.moved) {
      this.before.time = -Infinity;
      figures.take(hold.place);
    }
    figures.drop();
  }

  private ink({ moved, finger }: Hold, event: PointerEvent): void {
    const { figures, pen } = this;
    const at = figures.snapped(figures.sheet.at(event, figures.side), event.shiftKey, undefined, pen?.last);
    const near = (finger ? NEAR_FOR_FINGERS : NEAR) * figures.sheet.unit(figures.side);
    const figure = pen?.release(at, moved, near, event.timeStamp);
    this.draft();
    if (figure) figures.add({ ...figure, value: figures.firstValue });
    else figures.follow();
  }

  /** The browser took the pointer over, for example to scroll. */
  private lost(event: PointerEvent): void {
    this.figures.sheet.layer.removeAttribute('data-busy');
    if (this.hold?.pointer === event.pointerId) this.second();
  }

  private draft(): void {
    const { figures } = this;
    figures.sheet.draft(this.pen?.shown() ?? '', figures.sort?.broad ? (figures.firstValue / 100) * figures.side : 0);
  }
}
