/**
 * The small pictures of the presets, made by a second engine when the first one rests: the same
 * recipes, scaled down to a quarter of their side.
 */
import { make } from './dom';
import { Engine } from './engine';
import type { Preset } from './types';

/** Lengths of the recipe that shrink with the picture. */
const LENGTHS = ['cs', 'hs', 'af'];

/** Side at which the small pictures are made, in pixels. */
const SIDE = 160;

/** Milliseconds of work in one idle slice. */
const SLICE = 6;

export class Thumbs {
  private readonly queue: { preset: Preset; canvas: HTMLCanvasElement }[];
  private readonly resting: () => boolean;
  private engine: Engine | undefined;
  private waiting = false;

  /** `resting` tells whether the main engine has nothing to do. */
  constructor(queue: { preset: Preset; canvas: HTMLCanvasElement }[], resting: () => boolean) {
    this.queue = [...queue];
    this.resting = resting;
  }

  /** Goes on with the next one when the browser has time. */
  wake(): void {
    if (this.waiting || !this.queue.length) return;
    this.waiting = true;
    whenIdle(() => {
      this.waiting = false;
      if (document.hidden || !this.resting()) return;
      this.work();
      this.wake();
    });
  }

  private work(): void {
    const next = this.queue[0];
    if (!next) return;
    this.engine ??= this.begin(next.preset);
    this.engine.tick(SLICE, 100_000);
    if (!this.engine.alive) return;
    if (this.engine.stage() !== 'done') return;
    paint(this.engine, next.canvas);
    this.queue.shift();
    this.engine.free();
    this.engine = undefined;
  }

  /** A preset whose small picture fails only stays without one: its own run will say why. */
  private begin(preset: Preset): Engine {
    const engine = new Engine(preset.link, () => this.queue.splice(0));
    const scale = SIDE / engine.side();
    for (const key of LENGTHS) engine.set(key, String(Number(engine.get(key)) * scale));
    engine.set('size', String(SIDE));
    return engine;
  }
}

/** Safari has no idle callbacks. */
function whenIdle(call: () => void): void {
  if ('requestIdleCallback' in window) requestIdleCallback(call);
  else setTimeout(call, 50);
}

function paint(engine: Engine, canvas: HTMLCanvasElement): void {
  const whole = make('canvas', { width: String(SIDE), height: String(SIDE) });
  const from = whole.getContext('2d');
  if (!from) return;
  engine.draw(from, 'picture');
  canvas.getContext('2d')?.drawImage(whole, 0, 0, canvas.width, canvas.height);
  canvas.dataset['painted'] = '';
}
