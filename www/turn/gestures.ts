/**
 * Pointers, wheel and keys on the turntable. The page can always be scrolled: a vertical move of one finger scrolls
 * it, unless the finger has moved sideways first. The wheel scrolls it, unless the visitor has zoomed in first or the
 * turntable has the focus.
 */
import { wantsStill } from '../base/dom';
import { ARROWS } from '../late/arrows';
import type { Camera } from '../state/viewing';
import { dragged, nearer, turned, type Heights, type Spot } from './camera';

/** The receiver of the gestures. */
export interface Hands {
  readonly camera: () => Camera;
  readonly heights: () => Heights;
  /** `moving` means that more moves follow. */
  take(camera: Camera, moving: boolean): void;
  home(): void;
  leave(): void;
  /** A click, or a finger's tap; places are in fractions of the sides. */
  tap(x: number, y: number): void;
  /** A mouse rests at a place. Without a place: it has left. */
  over(x?: number, y?: number): void;
  /** Enter was pressed: it picks the body in the middle. */
  enter(): void;
}

/** A place on the screen, in pixels. */
interface ScreenPoint {
  readonly x: number;
  readonly y: number;
}

/**
 * A single pointer: the place where it went down, whether it has moved, and whether it drags the ground rather than
 * turns the camera.
 */
interface Begun extends ScreenPoint {
  readonly ground: boolean;
  moves: boolean;
}

/** Degrees for a move from one edge of the frame to the other. */
const ROUND = 220;
const UP = 130;

/**
 * The effect of a key: degrees, and fractions of the frame. A press of a zoom button multiplies the distance by
 * CLOSER.
 */
const KEY = { round: 10, up: 5, drag: 0.08 };
export const CLOSER = 1 / 1.3;

/** A pointer that moves fewer pixels than this has clicked; fingers are less steady. */
const SLACK = { mouse: 4, touch: 9 };

/**
 * A mouse rests for REST milliseconds before a body is shown; after a pause of STOPPED milliseconds the wheel or keys
 * have stopped. A throw goes on at the mean speed of its `last` milliseconds, but at most at `most`, in degrees per
 * millisecond. It decays with the time constant `dies`, and ends below `least`.
 */
const REST = 120;
const STOPPED = 220;
const THROW = { last: 90, dies: 260, least: 0.01, most: 0.2 };

export class Gestures {
  private readonly stand: HTMLElement;
  private readonly hands: Hands;
  /** The picture is embedded in another page. */
  private readonly alone: boolean;
  private readonly down = new Map<number, ScreenPoint>();
  private begun: Begun | undefined;
  /** The last moves of a turn: their times, and their angles in degrees. */
  private trail: { at: number; round: number; up: number }[] = [];
  private flying = 0;
  private stopping = 0;
  private resting = 0;
  private telling = false;
  /** The wheel has zoomed in since the pointer entered. */
  private wheeled = false;

  constructor(stand: HTMLElement, hands: Hands, alone: boolean) {
    this.stand = stand;
    this.hands = hands;
    this.alone = alone;
    this.listen('pointerdown', (event) => this.press(event));
    this.listen('pointermove', (event) => this.move(event));
    this.listen('pointerup', (event) => this.release(event, true));
    for (const sign of ['pointercancel', 'lostpointercapture'] as const) this.listen(sign, (event) => this.release(event, false));
    this.listen('pointerleave', ({ pointerType }) => {
      this.wheeled = false;
      // A finger leaves with its tap, whose answer is still to come.
      if (pointerType === 'mouse') this.rest();
    });
    this.listen('wheel', (event) => this.wheel(event));
    this.listen('keydown', (event) => this.key(event));
    this.listen('dblclick', (event) => {
      event.preventDefault();
      this.hands.home();
    });
    this.listen('contextmenu', (event) => event.preventDefault());
    // Two fingers move the camera, not the page.
    this.listen('touchstart', (event) => event.touches.length > 1 && event.cancelable && event.preventDefault());
    // Taps are handled by their pointer events.
    this.listen('click', () => undefined);
  }

  /** Lets go of all pointers: the frame is gone, so it would not hear of their release. */
  end(): void {
    this.down.clear();
    this.begun = undefined;
    this.stand.toggleAttribute('data-held', false);
    this.stop();
  }

  /** Stops all motion that continues by itself. */
  stop(): void {
    cancelAnimationFrame(this.flying);
    clearTimeout(this.stopping);
    this.flying = this.stopping = 0;
    this.rest();
  }

  /** Ends a motion that still continues, before a press or a key that picks. */
  private settle(): void {
    if (this.flying || this.stopping) this.hands.take(this.hands.camera(), false);
    this.stop();
  }

  /** Listens to an event, and keeps it from the picture below. */
  private listen<K extends keyof HTMLElementEventMap>(sign: K, act: (event: HTMLElementEventMap[K]) => void): void {
    this.stand.addEventListener(
      sign,
      (event) => {
        if (sign !== 'keydown') event.stopPropagation();
        act(event);
      },
      { passive: false },
    );
  }

  private get box(): DOMRect {
    return this.stand.getBoundingClientRect();
  }

  /** The place of a point from the middle of the frame, in shorter sides. */
  private spot({ x, y }: ScreenPoint): Spot {
    const { left, top, width, height } = this.box;
    const short = Math.min(width, height);
    return [(x - left - width / 2) / short, (y - top - height / 2) / short];
  }

  private press(event: PointerEvent): void {
    const { pointerId, button, pointerType, shiftKey, clientX: x, clientY: y } = event;
    this.settle();
    if (pointerType !== 'touch' && button > 2) return;
    this.down.set(pointerId, { x, y });
    // A drag may leave the frame before it counts as one, and a card may come under the pointer.
    this.stand.setPointerCapture(pointerId);
    this.begun = this.down.size === 1 ? { x, y, moves: false, ground: shiftKey || button > 0 } : undefined;
    // Two fingers never tap.
    if (!this.begun) this.stand.toggleAttribute('data-held', true);
    this.trail = [];
  }

  private move(event: PointerEvent): void {
    const { pointerId, pointerType, clientX: x, clientY: y } = event;
    const before = this.down.get(pointerId);
    if (!before) {
      if (pointerType === 'mouse') this.hover(event);
      return;
    }
    const other = [...this.down].find(([id]) => id !== pointerId)?.[1];
    if (other) this.pinch(before, { x, y }, other);
    else if (this.begun) this.drag(before, { x, y }, this.begun, event);
    if (other || this.begun?.moves) this.down.set(pointerId, { x, y });
  }

  private drag(before: ScreenPoint, now: ScreenPoint, begun: Begun, event: PointerEvent): void {
    const [dx, dy] = [now.x - begun.x, now.y - begun.y];
    const { timeStamp: at, pointerType } = event;
    const touch = pointerType === 'touch';
    if (!begun.moves && Math.hypot(dx, dy) < (touch ? SLACK.touch : SLACK.mouse)) return;
    // A vertical move scrolls the page.
    if (!begun.moves && touch && Math.abs(dy) > Math.abs(dx)) return;
    this.stand.toggleAttribute('data-held', true);
    begun.moves = true;
    const [from, to] = [this.spot(before), this.spot(now)];
    const [right, down] = [to[0] - from[0], to[1] - from[1]];
    if (begun.ground) return this.hands.take(dragged(this.hands.camera(), from, to), true);
    const [round, up] = [right * ROUND, down * UP];
    this.trail = [...this.trail.filter((one) => one.at > at - THROW.last), { at, round, up }];
    this.hands.take(turned(this.hands.camera(), round, up, this.hands.heights()), true);
  }

  /** Pinching zooms. Rotating two fingers, or moving them sideways, turns the camera. Moving both vertically tilts it. */
  private pinch(before: ScreenPoint, now: ScreenPoint, other: ScreenPoint): void {
    const apart = (p: ScreenPoint): number => Math.max(20, Math.hypot(p.x - other.x, p.y - other.y));
    const way = (p: ScreenPoint): number => (Math.atan2(p.y - other.y, p.x - other.x) * 180) / Math.PI;
    const twist = ((way(now) - way(before) + 540) % 360) - 180;
    const [from, to, still] = [this.spot(before), this.spot(now), this.spot(other)];
    const middle: Spot = [(to[0] + still[0]) / 2, (to[1] + still[1]) / 2];
    const [right, down] = [(to[0] - from[0]) / 2, (to[1] - from[1]) / 2];
    const closer = nearer(this.hands.camera(), apart(before) / apart(now), middle);
    this.stand.toggleAttribute('data-held', true);
    this.hands.take(turned(closer, right * ROUND + twist, down * UP, this.hands.heights()), true);
  }

  private release(event: PointerEvent, up: boolean): void {
    if (!this.down.delete(event.pointerId)) return;
    const { begun } = this;
    // The last finger of several goes on as one that was put down now.
    const [stays] = this.down.size === 1 ? this.down.values() : [];
    this.begun = stays && { ...stays, moves: false, ground: false };
    if (this.down.size) return;
    const held = this.stand.hasAttribute('data-held');
    this.stand.toggleAttribute('data-held', false);
    if (held) return this.fly(event.timeStamp);
    if (!up || !begun || begun.ground) return;
    const { left, top, width, height } = this.box;
    this.hands.tap((event.clientX - left) / width, (event.clientY - top) / height);
  }

  /** A turn continues after its release, and slows down. */
  private fly(at: number): void {
    const last = this.trail.filter((one) => one.at > at - THROW.last);
    const time = Math.max(16, at - (last[0]?.at ?? at));
    let round = last.reduce((sum, one) => sum + one.round, 0) / time;
    let up = last.reduce((sum, one) => sum + one.up, 0) / time;
    if (last.length < 2 || wantsStill()) return this.hands.take(this.hands.camera(), false);
    const limit = Math.min(1, THROW.most / Math.max(THROW.least, Math.hypot(round, up)));
    [round, up] = [round * limit, up * limit];
    let before = performance.now();
    const on = (now: number): void => {
      const span = Math.min(64, Math.max(0, now - before));
      before = now;
      const less = Math.exp(-span / THROW.dies);
      [round, up] = [round * less, up * less];
      const goes = Math.hypot(round, up) > THROW.least;
      this.flying = goes ? requestAnimationFrame(on) : 0;
      this.hands.take(turned(this.hands.camera(), round * span, up * span, this.hands.heights()), goes);
    };
    this.flying = requestAnimationFrame(on);
  }

  /** The wheel scrolls the page until the visitor zooms in, and again once the camera is as far out as it goes. */
  private wheel(event: WheelEvent): void {
    const { deltaY, deltaMode, ctrlKey } = event;
    const focused = this.stand.contains(document.activeElement);
    if (!ctrlKey && !focused && !(this.wheeled || (deltaY < 0 && !this.alone))) return;
    const lines = deltaMode === WheelEvent.DOM_DELTA_LINE ? 30 : 1;
    const camera = this.hands.camera();
    const next = nearer(camera, Math.exp(deltaY * lines * (ctrlKey ? 0.01 : 0.0015)), this.spot(event));
    if (next[2] === camera[2] && !ctrlKey) return;
    event.preventDefault();
    this.wheeled = true;
    this.soon(next);
  }

  private key(event: KeyboardEvent): void {
    const { key, shiftKey, ctrlKey, metaKey, altKey } = event;
    if (ctrlKey || metaKey || altKey) return;
    const { hands } = this;
    const camera = hands.camera();
    const way = ARROWS[key];
    if (way && shiftKey) this.soon(dragged(camera, [0, 0], [-way[0] * KEY.drag, -way[1] * KEY.drag]));
    else if (way) this.soon(turned(camera, way[0] * KEY.round, -way[1] * KEY.up, hands.heights()));
    else if (key === '+' || key === '=') this.soon(nearer(camera, CLOSER));
    else if (key === '-') this.soon(nearer(camera, 1 / CLOSER));
    else if (key === '0' || key === 'Home') hands.home();
    else if (key === 'Escape') hands.leave();
    else if (key === 'Enter') {
      this.settle();
      hands.enter();
    } else return;
    event.preventDefault();
  }

  /** Moves the camera; more moves may follow. After a pause the camera counts as stopped. */
  soon(camera: Camera): void {
    this.stop();
    this.hands.take(camera, true);
    this.stopping = window.setTimeout(() => this.hands.take(this.hands.camera(), false), STOPPED);
  }

  private hover({ clientX, clientY }: PointerEvent): void {
    clearTimeout(this.resting);
    const tell = (): void => {
      const { left, top, width, height } = this.box;
      this.telling = true;
      this.hands.over((clientX - left) / width, (clientY - top) / height);
    };
    // Once one body is shown, the card follows the pointer without delay.
    if (this.telling) tell();
    else this.resting = window.setTimeout(tell, REST);
  }

  private rest(): void {
    clearTimeout(this.resting);
    this.telling = false;
    this.hands.over();
  }
}
