/**
 * Painting on a surface: strokes on the frame become rows of the recipe, each a step of the history.
 *
 * With a tool chosen, one finger or the mouse paints on the model. Beside the model they turn it as usual, as do two
 * fingers, the other buttons, and keys. Keys paint in the middle of the frame: Enter sets a point, or erases, and
 * Enter again at the same place ends the line.
 */
import { t } from '../../words/space';
import { byId, make, say } from '../../base/dom';
import { notice } from '../../base/messages';
import { applies, recipeOf } from '../../state/rules';
import type { Work } from '../../state/work';
import type { FramePlace } from '../../picture/frames/source';
import { Overlay, type Painted } from './overlay';
import { distance, fromLine, placesOf, rowOf, simplified, STEPS, textOf, type ModelPlace } from './places';
import { TOOLS, Tools, type Tool } from './tools';

/** The surface that is painted on. */
export interface Surface {
  /** The element that contains the frame and receives its events. */
  readonly host: HTMLElement;
  /** The place on the model at a place of the last frame; undefined beside the model. */
  placeAt(spot: FramePlace): ModelPlace | undefined;
  /** The place in the last frame of a place on the model; undefined if it is hidden. */
  spotOf(place: ModelPlace): FramePlace | undefined;
}

/** The most points of one line. */
const POINTS = 20;

/**
 * Distances in steps: two places closer than SAME are the same; the eraser reaches NEAR; a spot has RADIUS unless a
 * larger or smaller one is drawn, and at least LEAST.
 */
const SAME = 24;
const NEAR = 170;
const RADIUS = 400;
const LEAST = 80;

interface PaintStroke {
  readonly pointer: PointerEvent;
  readonly places: ModelPlace[];
  readonly path: FramePlace[];
}

export class Painter {
  private readonly work: Work;
  private readonly surface: Surface;
  private readonly overlay = new Overlay();
  private readonly tools: Tools;
  private readonly told = make('p', { class: 'said', role: 'status', id: 'paint-told' });
  private tool: Tool | undefined;
  private drawn: PaintStroke | undefined;
  /** The points that were set by keys. */
  private keyed: ModelPlace[] = [];
  /** Events that are passed on to the frame. */
  private readonly passed = new WeakSet<Event>();

  constructor(work: Work, surface: Surface) {
    this.work = work;
    this.surface = surface;
    this.tools = new Tools({ choose: (tool) => this.choose(tool === this.tool ? undefined : tool), flip: () => this.flip() });
    const { host } = surface;
    host.append(this.overlay.element, this.told);
    byId('frame').after(this.tools.element);
    this.listen('pointerdown', (event) => this.press(event));
    this.listen('pointermove', (event) => this.move(event));
    this.listen('pointerup', (event) => this.release(event));
    this.listen('pointercancel', (event) => this.lose(event));
    this.listen('keydown', (event) => this.key(event));
    this.listen('dblclick', () => this.tool !== undefined);
    this.tools.element.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape' || !this.tool) return;
      event.stopPropagation();
      this.choose(undefined);
    });
    work.store.on(['recipe', 'make'], () => this.show());
    work.store.on(['stage'], () => this.draw());
    this.show();
  }

  /** Chooses a tool; undefined for none. */
  choose(tool: Tool | undefined): void {
    this.tool = tool;
    this.drawn = undefined;
    this.keyed = [];
    this.surface.host.toggleAttribute('data-paint', tool !== undefined);
    this.show();
    if (tool) say(this.told, t(`paint_${tool}_title`));
  }

  /**
   * To be called after each new frame. Painted rows are shown while the visitor paints or erases, and while the cells
   * follow them; they do not lie on the finished picture.
   */
  draw(): void {
    const { tool, keyed, drawn, surface } = this;
    const isBusy = tool === 'erase' || drawn !== undefined || keyed.length > 0 || this.work.store.state.stage !== 'done';
    const painted = tool && isBusy ? this.painted() : [];
    const line = tool === 'spots' || tool === 'stretch' ? (drawn?.path.slice(0, 1) ?? []) : (drawn?.path ?? []);
    if (tool && keyed.length) painted.push({ key: tool, places: keyed });
    this.overlay.draw(painted, (place) => surface.spotOf(place), line, tool ?? '');
  }

  /** All painted rows; a spot is its middle. */
  private painted(): Painted[] {
    return TOOLS.flatMap((key) =>
      key === 'erase' || !this.isUseful(key) ? [] : this.rows(key).map((row) => ({ key, places: placesOf(isSpot(key) ? row.slice(0, 3) : row) })),
    );
  }

  private rows(key: Tool): number[][] {
    return this.work.engine.list(key);
  }

  private isUseful(key: Tool): boolean {
    const { engine } = this.work;
    const row = engine.schema.find((parameter) => parameter.key === key);
    return row !== undefined && applies(row, recipeOf(engine));
  }

  private show(): void {
    const isOffered = this.work.engine.offers('paint');
    this.tools.element.hidden = !isOffered;
    if (!isOffered) return;
    const useful = TOOLS.filter((tool) => (tool === 'erase' ? this.painted().length > 0 : this.isUseful(tool)));
    if (this.tool && !useful.includes(this.tool)) return this.choose(undefined);
    this.tools.show(this.tool, useful, this.work.engine.get('flip') === '1');
    this.draw();
  }

  private flip(): void {
    this.work.set('flip', this.work.engine.get('flip') === '1' ? '0' : '1');
  }

  /** Listens to events of the host. If `act` returns true, it has used the event, and the frame does not get it. */
  private listen<K extends keyof HTMLElementEventMap>(sign: K, act: (event: HTMLElementEventMap[K]) => boolean): void {
    this.surface.host.addEventListener(
      sign,
      (event) => {
        if (this.passed.has(event) || !act(event)) return;
        event.stopPropagation();
        if (event.cancelable) event.preventDefault();
      },
      { capture: true, passive: false },
    );
  }

  private spot({ clientX, clientY }: MouseEvent): FramePlace {
    const { left, top, width, height } = this.surface.host.getBoundingClientRect();
    return [(clientX - left) / width, (clientY - top) / height];
  }

  private press(event: PointerEvent): boolean {
    const { tool, drawn } = this;
    if (!tool) return false;
    if (drawn) {
      // With a second finger, both turn the model.
      this.passOn(drawn.pointer);
      this.cancel();
      return false;
    }
    if (event.button !== 0 || event.shiftKey) return false;
    const spot = this.spot(event);
    const place = this.surface.placeAt(spot);
    if (!place) return false;
    // The frame gets this pointer as well once another finger touches.
    const stand = this.surface.host.querySelector<HTMLElement>('[tabindex]');
    stand?.setPointerCapture(event.pointerId);
    stand?.focus({ preventScroll: true });
    this.drawn = { pointer: event, places: [place], path: [spot] };
    this.draw();
    return true;
  }

  /** Passes a withheld event on to the frame. */
  private passOn(event: PointerEvent): void {
    const { pointerId, pointerType, isPrimary, clientX, clientY, button } = event;
    const again = new PointerEvent('pointerdown', { pointerId, pointerType, isPrimary, clientX, clientY, button, bubbles: true, cancelable: true });
    this.passed.add(again);
    event.target?.dispatchEvent(again);
  }

  private move(event: PointerEvent): boolean {
    const { drawn } = this;
    // While a tool is chosen, no card of a body is shown under the mouse.
    if (drawn?.pointer.pointerId !== event.pointerId) return this.tool !== undefined && event.buttons === 0 && event.pointerType === 'mouse';
    const all = 'getCoalescedEvents' in event ? event.getCoalescedEvents() : [];
    for (const one of all.length ? all : [event]) {
      const spot = this.spot(one);
      const place = this.surface.placeAt(spot);
      if (!place) continue;
      drawn.path.push(spot);
      drawn.places.push(place);
    }
    this.draw();
    return true;
  }

  private release(event: PointerEvent): boolean {
    const { drawn, tool } = this;
    if (!tool || drawn?.pointer.pointerId !== event.pointerId) return false;
    this.drawn = undefined;
    this.take(tool, drawn.places);
    return true;
  }

  private lose(event: PointerEvent): boolean {
    if (this.drawn?.pointer.pointerId !== event.pointerId) return false;
    this.cancel();
    return true;
  }

  private cancel(): void {
    this.drawn = undefined;
    this.draw();
  }

  private key({ key, ctrlKey, metaKey, altKey }: KeyboardEvent): boolean {
    const { tool, keyed } = this;
    if (!tool || ctrlKey || metaKey || altKey) return false;
    if (key === 'Escape') {
      if (keyed.length) {
        this.keyed = [];
        this.draw();
      } else this.choose(undefined);
      return true;
    }
    if (key === 'Backspace' && keyed.length) {
      this.keyed.pop();
      this.draw();
      return true;
    }
    if (key !== 'Enter') return false;
    const place = this.surface.placeAt([0.5, 0.5]);
    if (!place) say(this.told, t('paint_beside'));
    else if (tool === 'erase' || isSpot(tool)) this.take(tool, [place]);
    else this.set(tool, place);
    return true;
  }

  /** Sets a point of a line by a key. */
  private set(tool: Tool, place: ModelPlace): void {
    const last = this.keyed.at(-1);
    if (!last || distance(last, place) > SAME) this.keyed.push(place);
    else {
      const places = this.keyed;
      this.keyed = [];
      this.take(tool, places);
      return;
    }
    say(this.told, t('paint_point', { n: this.keyed.length }));
    this.draw();
  }

  /** Writes a finished stroke into the recipe. */
  private take(tool: Tool, places: readonly ModelPlace[]): void {
    const [first, last] = [places[0], places.at(-1)];
    if (!first || !last) return;
    if (tool === 'erase') return this.erase(first);
    if (isSpot(tool)) {
      const radius = Math.max(LEAST, distance(first, last) > SAME ? distance(first, last) : RADIUS);
      return this.write(tool, [...this.rows(tool), [...rowOf([first]), radius / STEPS, this.tools.valueOf(tool)]]);
    }
    const line = simplified(places, POINTS);
    if (line.length > 2 || distance(first, last) > SAME) return this.write(tool, [...this.rows(tool), rowOf(line)]);
    notice('value', t('paint_short'));
    this.draw();
  }

  /** Erases the nearest row. */
  private erase(place: ModelPlace): void {
    const all = TOOLS.flatMap((key) => (key === 'erase' ? [] : this.rows(key).map((row, at) => ({ key, at, off: fromLine(place, placesOf(isSpot(key) ? row.slice(0, 3) : row)) }))));
    const [nearest] = all.filter(({ key }) => this.isUseful(key)).sort((a, b) => a.off - b.off);
    if (!nearest || nearest.off > NEAR) {
      notice('value', t('paint_nothing'));
      return this.draw();
    }
    this.write(nearest.key, this.rows(nearest.key).toSpliced(nearest.at, 1));
    say(this.told, t('paint_gone'));
  }

  private write(key: Tool, rows: readonly number[][]): void {
    const { sentences } = this.work.write(key, textOf(rows));
    notice('value', ...sentences);
    this.show();
  }
}

function isSpot(tool: Tool): tool is 'spots' | 'stretch' {
  return tool === 'spots' || tool === 'stretch';
}
