/** Shows an outline in stones. It has its own engine, which works in idle time while the dialog is open. */
import { isEnd } from '../../module/stages';
import type { Ring } from '../../module/types';
import { idle, wantsStill } from '../../base/dom';
import { Engine, type Told } from '../../state/engine';
import { area } from '../geometry/plane';

/** Milliseconds of one idle slice, and between two drawings of unfinished work. */
const SLICE = 6;
const DRAWINGS = 150;

const VIEW = 'auto';

/** With more cells, a step of packing is too long for idle time: the preview then shows fewer, larger cells. */
const MOST_CELLS = 5000;

export class Preview {
  readonly canvas: HTMLCanvasElement;
  /** The size of cells, limited by the program for this side, and their approximate number. */
  cells = 0;
  count = 0;
  private readonly engine: Engine;
  private readonly tell: (problem: string, done: boolean) => void;
  private readonly still = wantsStill();
  private waiting = false;
  /** A drawing has been started; its pieces come before further work. */
  private owed = false;
  private drawn = 0;

  /** After each slice, `tell` gets the reason why there can be no stones, or ''. */
  constructor(canvas: HTMLCanvasElement, recipe: string, tell: (problem: string, done: boolean) => void, failed: () => void) {
    this.canvas = canvas;
    this.tell = tell;
    this.engine = new Engine(recipe, failed);
    document.addEventListener('visibilitychange', this.wake);
  }

  /** Shows these rings, with lengths in sides. Returns whether the engine accepts them, and its notices. */
  show(rings: Ring[], values: readonly [key: string, text: string][]): Told {
    const { engine } = this;
    for (const [key, text] of values) engine.set(key, text);
    const side = engine.side();
    const told = engine.setOutline(rings.map((ring) => ring.map(([x, y]) => [x * side, y * side])));
    this.cells = Number(engine.get('cs'));
    this.count = (rings.reduce((sum, ring) => sum + area(ring), 0) * side * side) / this.cells ** 2;
    if (this.isCoarse) engine.set('cs', (this.cells * Math.sqrt(this.count / MOST_CELLS)).toFixed(2));
    this.canvas.hidden = true;
    this.drawn = performance.now() + DRAWINGS;
    this.owed = false;
    if (!told.refused) this.wake();
    return told;
  }

  /** The preview shows fewer, larger cells than the picture will have. */
  get isCoarse(): boolean {
    return this.count > MOST_CELLS;
  }

  end(): void {
    document.removeEventListener('visibilitychange', this.wake);
    this.engine.free();
  }

  private readonly wake = (): void => {
    if (this.waiting) return;
    this.waiting = true;
    void idle(50).then(() => {
      this.waiting = false;
      if (this.engine.alive && !document.hidden) this.goOn();
    });
  };

  private goOn(): void {
    const { engine } = this;
    if (!isEnd(engine.stage()) && !this.owed) engine.tick(SLICE, 100_000);
    const stage = engine.stage();
    // Visitors who prefer reduced motion see finished pictures only.
    const due = isEnd(stage) || (!this.still && performance.now() >= this.drawn);
    this.owed = due && !engine.prepare(VIEW, SLICE);
    if (due && !this.owed && stage !== 'error') this.paint();
    const done = isEnd(stage) && !this.owed;
    this.tell(engine.problem(), done);
    if (!done) this.wake();
  }

  private paint(): void {
    const { engine, canvas } = this;
    const context = canvas.getContext('2d');
    if (!context) return;
    const side = engine.side();
    if (canvas.width !== side) canvas.width = canvas.height = side;
    engine.draw(context, VIEW);
    canvas.hidden = false;
    this.drawn = performance.now() + DRAWINGS;
  }
}
