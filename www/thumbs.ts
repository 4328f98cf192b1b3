/**
 * The small pictures of the presets, made by a second engine when the first one rests: the same
 * recipes, scaled down to a quarter of their side.
 */
import { make } from './dom';
import { Engine } from './engine';
import { isEnd } from './loop';
import type { Preset } from './types';

/** Lengths of the recipe that shrink with the picture. */
const LENGTHS = ['cs', 'hs', 'af'];

/** Lengths that skin measures in parts of a cell. */
const OF_CELLS = ['af'];

/** Side at which the small pictures are made, in pixels. */
const SIDE = 160;

/** Milliseconds of work in one idle slice. */
const SLICE = 6;

interface Thumb {
  readonly preset: Preset;
  readonly canvas: HTMLCanvasElement;
}

export class Thumbs {
  private readonly queue: Set<Thumb>;
  private readonly resting: () => boolean;
  private work: { thumb: Thumb; engine: Engine } | undefined;
  private waiting = false;

  /** `resting` tells whether the main engine has nothing to do. */
  constructor(thumbs: Thumb[], resting: () => boolean) {
    this.queue = new Set(thumbs);
    this.resting = resting;
  }

  /** Goes on with the next one when the browser has time. */
  wake(): void {
    if (this.waiting || !(this.work ?? this.next())) return;
    this.waiting = true;
    whenIdle(() => {
      this.waiting = false;
      if (document.hidden || !this.resting()) return;
      this.go();
      this.wake();
    });
  }

  /** The first one in sight, or else the first of the group that is unfolded: none is made for nobody. */
  private next(): Thumb | undefined {
    const shown = [...this.queue].filter(({ canvas }) => canvas.offsetParent);
    return shown.find(({ canvas }) => inSight(canvas)) ?? shown[0];
  }

  private go(): void {
    const thumb = this.work?.thumb ?? this.next();
    if (!thumb) return;
    const { engine } = (this.work ??= { thumb, engine: this.begin(thumb.preset) });
    engine.tick(SLICE, 100_000);
    const stage = engine.stage();
    if (!isEnd(stage)) return;
    if (stage === 'done') paint(engine, thumb.canvas);
    this.queue.delete(thumb);
    engine.free();
    this.work = undefined;
  }

  /** A preset whose small picture fails only stays without one: its own run will say why. */
  private begin(preset: Preset): Engine {
    const engine = new Engine(preset.link, () => this.queue.clear());
    const scale = SIDE / engine.side();
    const skin = engine.get('stone') === 'skin';
    for (const key of LENGTHS) {
      if (!skin || !OF_CELLS.includes(key)) engine.set(key, String(Number(engine.get(key)) * scale));
    }
    engine.set('size', String(SIDE));
    return engine;
  }
}

function inSight(canvas: HTMLCanvasElement): boolean {
  const box = canvas.getBoundingClientRect();
  const frame = canvas.closest('ul')?.getBoundingClientRect() ?? box;
  return box.bottom > frame.top && box.top < frame.bottom && box.right > frame.left && box.left < frame.right;
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
