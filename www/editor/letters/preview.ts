/** What an outline would look like in stones: an engine of its own works in idle moments as long as the dialog is open. */
import { isEnd } from '../../module/stages';
import type { Ring } from '../../module/types';
import { idle, wantsStill } from '../../base/dom';
import { Engine, type Told } from '../../state/engine';
import { area } from '../geometry/plane';

/** Milliseconds of work in one idle slice, and between two drawings of work in progress. */
const SLICE = 6;
const DRAWINGS = 150;

const VIEW = 'auto';

/** A step of the packing of more cells takes too long for an idle moment: they are shown larger, and fewer. */
const MOST_CELLS = 5000;

export class Preview {
  readonly canvas: HTMLCanvasElement;
  /** The size of cells, which the program keeps within what a picture of that side may have; and how many there will be, about. */
  cells = 0;
  count = 0;
  private readonly engine: Engine;
  private readonly tell: (problem: string, done: boolean) => void;
  private readonly still = wantsStill();
  private waiting = false;
  /** A drawing is made in pieces, before there is more work. */
  private owed = false;
  private drawn = 0;

  /** `tell` gets why there can be no stones, or '', after each slice. */
  constructor(canvas: HTMLCanvasElement, recipe: string, tell: (problem: string, done: boolean) => void, failed: () => void) {
    this.canvas = canvas;
    this.tell = tell;
    this.engine = new Engine(recipe, failed);
    document.addEventListener('visibilitychange', this.wake);
  }

  /** Shows these rings, with lengths in sides; answers whether they will do, and what is to be said of them. */
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

  /** Cells are shown larger than they will be. */
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
    // Who asks for less motion sees finished pictures only.
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
