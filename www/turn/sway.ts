/**
 * A swing of the camera by itself, some degrees there and back, which shows a new visitor that bodies can be turned. It
 * happens once, and only if nothing was touched since the bodies came. It ends where it began.
 */
import { wantsStill } from '../base/dom';
import { keep, kept } from '../base/storage';
import type { Camera } from '../state/viewing';
import { ALL_AROUND, turned } from './camera';

/** The swing's milliseconds, and its widest angle in degrees. */
const TIME = 3600;
const WIDE = 11;

/** The longest time of a frame that counts, in milliseconds: on slow machines the swing takes longer instead of jumping. */
const LONGEST = 100;

/** The key of the note that the visitor has seen the swing, or has turned bodies. */
const SEEN = 'swayed';

/** These events end the swing. */
const TOUCHES = ['pointerdown', 'touchstart', 'keydown', 'wheel', 'scroll'] as const;

export class Sway {
  private frame = 0;
  private passed = 0;
  private last = 0;
  /** Whether the swing may still begin. */
  private waits = kept(SEEN) === undefined;
  private readonly see: () => void;
  private readonly touched = ({ type, target }: Event): void => {
    // Lists may scroll by themselves.
    if (type !== 'scroll' || target === document) this.end();
  };

  /** `see` is called when the angle has changed. */
  constructor(see: () => void) {
    this.see = see;
  }

  /** The bodies have come: from now on a touch prevents the swing. */
  arm(): void {
    if (this.waits) for (const sign of TOUCHES) addEventListener(sign, this.touched, { capture: true, passive: true });
  }

  /** Begins the swing, unless it has been prevented. */
  begin(): void {
    if (!this.waits || this.goes) return;
    this.waits = false;
    if (wantsStill()) return this.end();
    keep(SEEN, 'yes');
    this.last = performance.now();
    this.frame = requestAnimationFrame((now) => this.go(now));
  }

  /** Ends the swing, and prevents it from now on. */
  end(): void {
    const { goes } = this;
    for (const sign of TOUCHES) removeEventListener(sign, this.touched, { capture: true });
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    this.waits = false;
    if (goes) this.see();
  }

  /** Notes that the visitor has turned bodies. */
  learnt(): void {
    keep(SEEN, 'yes');
    this.end();
  }

  get goes(): boolean {
    return this.frame !== 0;
  }

  /** The camera of this moment; `camera` is the one at rest. */
  of(camera: Camera): Camera {
    const part = this.passed / TIME;
    return this.goes ? turned(camera, WIDE * Math.sin(2 * Math.PI * part) * Math.sin(Math.PI * part), 0, ALL_AROUND) : camera;
  }

  private go(now: number): void {
    this.passed += Math.min(LONGEST, Math.max(0, now - this.last));
    this.last = now;
    if (this.passed >= TIME) return this.end();
    this.frame = requestAnimationFrame((next) => this.go(next));
    this.see();
  }
}
