/** Shows an outline in stones. It has its own engine, which works in idle time while the dialog is open. */
import { isEnd } from '../../module/stages';
import type { Ring } from '../../module/types';
import type { SetResult } from '../../state/engine';
import { PACE } from '../../state/viewing';
import { PictureHost } from '../../picture/host';
import { IDLE } from '../../picture/loop';
import { area } from '../geometry/plane';

/** With more cells, a step of packing is too long for idle time: the preview then shows fewer, larger cells. */
const MOST_CELLS = 5000;

export class Preview {
  readonly canvas: HTMLCanvasElement;
  /** The size of cells, limited by the program for this side, and their approximate number. */
  cells = 0;
  count = 0;
  private readonly host: PictureHost;

  /** After each slice, `tell` gets the reason why there can be no stones, or ''. */
  constructor(canvas: HTMLCanvasElement, recipe: string, tell: (problem: string, done: boolean) => void, failed: () => void) {
    this.canvas = canvas;
    this.host = new PictureHost(recipe, {
      canvas,
      view: () => 'auto',
      worked: (stage, _, drawn) => {
        if (drawn && stage !== 'error') canvas.hidden = false;
        tell(this.host.engine.problem(), isEnd(stage));
      },
      crashed: failed,
    });
    this.host.loop.rhythm = IDLE;
    this.host.drive({ paused: false, pace: PACE.still });
  }

  /** Shows these rings, with lengths in sides. Returns whether the engine accepts them, and its notices. */
  show(rings: Ring[], values: readonly [key: string, text: string][]): SetResult {
    const { engine, loop } = this.host;
    for (const [key, text] of values) engine.set(key, text);
    const side = engine.side();
    const told = engine.setOutline(rings.map((ring) => ring.map(([x, y]) => [x * side, y * side])));
    this.cells = Number(engine.get('cs'));
    this.count = (rings.reduce((sum, ring) => sum + area(ring), 0) * side * side) / this.cells ** 2;
    if (this.isCoarse) engine.set('cs', (this.cells * Math.sqrt(this.count / MOST_CELLS)).toFixed(2));
    this.canvas.hidden = true;
    if (!told.refused) loop.begin();
    return told;
  }

  /** The preview shows fewer, larger cells than the picture will have. */
  get isCoarse(): boolean {
    return this.count > MOST_CELLS;
  }

  end(): void {
    this.host.free();
  }
}
