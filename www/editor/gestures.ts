/** Mouse, pen and finger over the canvas: what is pressed, dragged, and clicked twice. */
import type { Point } from '../module/types';
import type { Editor } from './editor';
import type { Place } from './geometry/figures';
import { DOUBLE, Pen } from './pen';
import type { Part } from './sheet';

/** CSS pixels from which a press is a drag, and within which two presses are at one place; for fingers more. */
const SLACK = 3;
const NEAR = 9;
const NEAR_FOR_FINGERS = 24;

type Hold = { pointer: number; x: number; y: number; moved: boolean; finger: boolean } & (
  | { holds: 'point'; place: Place; twice: boolean }
  | { holds: 'figure'; figure: number; last: Point }
  | { holds: 'knob'; figure: number }
  | { holds: 'pen' }
  | { holds: 'seed' }
);

export class Gestures {
  private readonly editor: Editor;
  private hold: Hold | undefined;
  private pen: Pen | undefined;
  private before = { time: -Infinity, x: 0, y: 0 };

  constructor(editor: Editor) {
    this.editor = editor;
    const { layer } = editor.sheet;
    layer.addEventListener('pointerdown', (event) => this.down(event));
    // A point that is pressed has the keyboard, which browsers do not give to every button, and not to what came only now.
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

  /** What is drawn becomes a figure as it is. */
  finish(): void {
    const figure = this.pen?.finish();
    this.draft();
    if (figure) this.editor.add({ ...figure, value: this.editor.firstValue });
    else this.editor.showBar();
  }

  cancel(): void {
    this.hold = undefined;
    this.pen?.cancel();
    this.draft();
    if (this.editor.armed) this.editor.disarm();
    this.editor.showBar();
  }

  /** Enter ends what is drawn, Escape takes it back, Backspace and undo its last point. */
  key({ key, ctrlKey, metaKey, shiftKey }: KeyboardEvent): boolean {
    if (!this.pen?.open && !(this.editor.armed && key === 'Escape')) return false;
    const undo = key.toLowerCase() === 'z' && (ctrlKey || metaKey) && !shiftKey;
    if (key === 'Escape') this.cancel();
    else if (key === 'Enter') this.finish();
    else if (undo || key === 'Backspace' || key === 'Delete') this.pen?.back();
    else return false;
    this.draft();
    this.editor.showBar();
    return true;
  }

  private down(event: PointerEvent): void {
    const { editor } = this;
    if (this.hold) return this.second();
    if (event.button !== 0) return;
    const at = editor.sheet.at(event, editor.side);
    const finger = event.pointerType === 'touch';
    const twice = event.timeStamp - this.before.time < DOUBLE && Math.hypot(event.clientX - this.before.x, event.clientY - this.before.y) < (finger ? NEAR_FOR_FINGERS : NEAR);
    this.before = { time: event.timeStamp, x: event.clientX, y: event.clientY };
    // What is being drawn may begin and go on anywhere: an island in a hole, a line over another one.
    const part: Part = this.pen?.open || editor.armed ? { part: 'nothing' } : editor.sheet.part(event.target);
    const common = { pointer: event.pointerId, x: event.clientX, y: event.clientY, moved: false, finger };
    if (part.part === 'point') {
      this.hold = { ...common, holds: 'point', place: part.place, twice };
      editor.mark(part.place);
      editor.focus();
    } else if (part.part === 'edge') {
      const { figure, index } = part.place;
      // Adding a point and dragging it on is one step.
      editor.hold();
      editor.addAfter(part.place);
      this.before.time = -Infinity;
      this.hold = { ...common, holds: 'point', place: { figure, index: index + 1 }, twice: false };
    } else if (part.part === 'knob') {
      this.hold = { ...common, holds: 'knob', figure: part.figure };
    } else if (part.part === 'line' && twice) {
      this.before.time = -Infinity;
      editor.split(part.figure, at);
    } else if (part.part === 'line' && editor.loose(part.figure)) {
      this.hold = { ...common, holds: 'figure', figure: part.figure, last: at };
      editor.mark({ figure: part.figure, index: 0 });
    } else if (part.part === 'nothing') {
      this.begin(common, at, event.shiftKey);
    }
    if (!this.hold) return;
    editor.sheet.layer.setPointerCapture(event.pointerId);
    editor.sheet.layer.toggleAttribute('data-busy', part.part !== 'nothing');
  }

  /** Presses the canvas itself. */
  private begin(common: Omit<Hold, 'holds' | 'place' | 'twice' | 'figure' | 'last'>, at: Point, snaps: boolean): void {
    const { editor } = this;
    const form = editor.sort?.form;
    if (form === 'seed') this.hold = { ...common, holds: 'seed' };
    else if (form === 'line' || form === 'spot' || (form === 'ring' && editor.armed)) {
      this.pen ??= new Pen(form, editor.side);
      this.pen.press(editor.snapped(at, snaps, undefined, this.pen.last));
      this.hold = { ...common, holds: 'pen' };
      editor.sheet.layer.focus({ preventScroll: true });
    }
  }

  /** Two fingers are for the picture, not for its points. */
  private second(): void {
    const pen = this.hold?.holds === 'pen';
    this.hold = undefined;
    if (pen) {
      this.pen?.lift();
      this.draft();
      this.editor.showBar();
    }
    this.editor.drop();
  }

  private move(event: PointerEvent): void {
    const { editor, hold } = this;
    const raw = editor.sheet.at(event, editor.side);
    if (!hold) {
      if (!this.pen?.open || event.pointerType === 'touch') return;
      this.pen.hover(editor.snapped(raw, event.shiftKey, undefined, this.pen.last));
      return this.draft();
    }
    if (hold.pointer !== event.pointerId) return;
    if (!hold.moved && Math.hypot(event.clientX - hold.x, event.clientY - hold.y) < SLACK * (hold.finger ? 2 : 1)) return;
    hold.moved = true;
    if (hold.holds === 'seed') return;
    if (hold.holds === 'pen') {
      this.pen?.draw(editor.snapped(raw, event.shiftKey, undefined, this.pen.last), event.shiftKey);
      return this.draft();
    }
    editor.hold();
    if (hold.holds === 'point') editor.move(hold.place, editor.snapped(raw, event.shiftKey, hold.place));
    else if (hold.holds === 'knob') editor.widen(hold.figure, raw);
    else {
      const at = editor.snapped(raw, false, undefined);
      editor.shift(hold.figure, [at[0] - hold.last[0], at[1] - hold.last[1]]);
      hold.last = at;
    }
  }

  private up(event: PointerEvent): void {
    const { editor, hold } = this;
    if (hold?.pointer !== event.pointerId) return;
    this.hold = undefined;
    if (hold.moved) this.before.time = -Infinity;
    if (hold.holds === 'pen') this.ink(hold, event);
    else if (hold.holds === 'seed' && !hold.moved) editor.addFigure(editor.sheet.at(event, editor.side));
    else if (hold.holds === 'point' && hold.twice && !hold.moved) {
      this.before.time = -Infinity;
      editor.take(hold.place);
    }
    editor.drop();
  }

  private ink({ moved, finger }: Hold, event: PointerEvent): void {
    const { editor, pen } = this;
    const at = editor.snapped(editor.sheet.at(event, editor.side), event.shiftKey, undefined, pen?.last);
    const near = (finger ? NEAR_FOR_FINGERS : NEAR) * editor.sheet.unit(editor.side);
    const figure = pen?.release(at, moved, near, event.timeStamp);
    this.draft();
    if (figure) editor.add({ ...figure, value: editor.firstValue });
    else editor.showBar();
  }

  /** The browser took the pointer away, as for scrolling. */
  private lost(event: PointerEvent): void {
    this.editor.sheet.layer.removeAttribute('data-busy');
    if (this.hold?.pointer === event.pointerId) this.second();
  }

  private draft(): void {
    const { editor } = this;
    editor.sheet.draft(this.pen?.shown() ?? '', editor.sort?.broad ? (editor.firstValue / 100) * editor.side : 0);
  }
}
