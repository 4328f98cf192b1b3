/**
 * Another picture beside the page's own. Both form in step, and a changed control changes both. Other values of the
 * second recipe stay as they are. Undo restores both.
 */
import { isEnd } from '../module/stages';
import { t } from '../words/look';
import { byId, frame, make, say, wantsStill } from '../base/dom';
import type { Engine } from '../state/engine';
import { valuesIn } from '../state/link';
import type { Store } from '../state/store';
import type { Camera } from '../state/viewing';
import type { Partner, Work } from '../state/work';
import { Loop } from '../picture/loop';
import type { View } from '../picture/view';
import { Gestures } from '../turn/gestures';
import { homeOf } from '../state/asked-view';
import { ALL_AROUND } from '../turn/camera';
import { OtherFrames } from '../turn/others';
import { Together } from './together';
import { Zoom } from './zoom';
import '../styles/late/beside.css';

export class Beside implements Partner {
  readonly sheet = make('div', { class: 'sheet', id: 'beside' });
  private readonly work: Work;
  private readonly store: Store;
  private readonly view: View;
  private readonly own: Loop;
  private readonly frame = byId('frame');
  private readonly canvas = make('canvas', { role: 'img', 'aria-labelledby': 'beside-name' });
  private readonly names = [make('p', { class: 'beside-name', id: 'beside-name' }), make('p', { class: 'beside-name own' })] as const;
  private engine: Engine | undefined;
  private loop: Loop | undefined;
  /** Its frames, for generators that are seen by frames only. */
  private frames: OtherFrames | undefined;
  /** The name of the other recipe, and the link that has this name. */
  private title = '';
  private link = '';
  /** For each recipe of the page, the other recipe that stood beside it, to restore it on Undo. */
  private readonly pairs = new Map<string, string>();
  /** The page's recipe after the last change. */
  private last = '';

  constructor(work: Work, view: View, own: Loop) {
    this.work = work;
    this.store = work.store;
    this.view = view;
    this.own = own;
    this.sheet.append(make('div', { class: 'pane' }, this.canvas));
    new Zoom(this.store, () => undefined, this.sheet);
    // Two fingers zoom the pictures, not the page.
    this.sheet.addEventListener('touchstart', (event) => event.touches.length > 1 && event.cancelable && event.preventDefault(), { passive: false });
    this.store.on(['recipe'], () => this.goBack());
    this.store.on(['paused', 'pace'], () => this.drive());
    this.store.on(['view', 'overlays'], () => this.loop?.redraw());
    view.drawn(() => this.tell());
  }

  show(on: boolean): void {
    this.frame.toggleAttribute('data-beside', on);
    if (on) {
      byId('sheet').before(this.sheet, this.names[0]);
      byId('sheet').after(this.names[1]);
      // On a phone, the new layout may leave the pictures small: scrolls to where they are large.
      void frame().then(() => byId('enlarge').hidden || byId('enlarge').click());
      return;
    }
    for (const element of [this.sheet, ...this.names]) element.remove();
    this.loop?.end();
    this.frames?.end();
    this.engine = this.loop = this.frames = this.own.pair = this.work.partner = undefined;
    this.store.update({ other: 'done' });
  }

  /**
   * Shows the picture of this engine beside the page's own. Both begin again; if less motion is preferred, only the
   * other one works.
   */
  take(engine: Engine, title: string): void {
    this.loop?.end();
    this.frames?.end();
    this.engine = engine;
    [this.title, this.link] = [title, engine.link()];
    this.loop = new Loop(engine, (stage) => this.shownAt(stage), (stage, changed) => this.drawn(stage, changed));
    this.frames = engine.offers('frames') ? this.framesOf(engine, this.loop) : undefined;
    this.loop.painter = this.frames?.painter;
    this.canvas.hidden = engine.offers('frames');
    this.loop.pair = this.own.pair = new Together(this.work.engine, engine);
    this.work.partner = this;
    this.pairs.clear();
    this.remember();
    this.store.update({ other: engine.stage() });
    this.drive();
    this.loop.begin();
    // Visitors who prefer less motion see the present picture.
    if (wantsStill()) return;
    if (!isEnd(this.work.engine.stage())) return this.restart();
    this.work.restart();
    this.own.changed();
  }

  /** Gestures on either picture turn both. */
  private framesOf(engine: Engine, loop: Loop): OtherFrames {
    const { store } = this;
    const frames = new OtherFrames(engine, store, loop);
    const home = homeOf(engine.generator);
    const none = (): void => undefined;
    const hands = {
      camera: () => store.state.camera ?? home,
      heights: () => ALL_AROUND,
      take: (camera: Camera) => store.update({ camera }),
      home: () => store.update({ camera: undefined }),
      leave: none,
      tap: none,
      over: none,
      enter: none,
    };
    new Gestures(frames.canvas, hands, false);
    this.sheet.append(frames.canvas);
    return frames;
  }

  /** A control has changed: copies the changed values to the other recipe, if it has these parameters. */
  follow(): void {
    const { engine, last } = this;
    const own = this.work.engine;
    if (!engine) return;
    const [before, now] = [new Set(valuesIn(last)), new Set(valuesIn(own.link()))];
    const keys = [...before, ...now].filter((pair) => before.has(pair) !== now.has(pair)).map((pair) => pair.replace(/=.*/s, ''));
    const known = new Set(engine.schema.map(({ key }) => key));
    for (const key of new Set(keys)) if (known.has(key)) engine.set(key, own.get(key));
    this.remember();
    this.loop?.changed();
  }

  step(): void {
    this.engine?.step();
    this.loop?.redraw();
  }

  restart(): void {
    this.engine?.restart();
    this.loop?.changed();
  }

  /** The page has another recipe: restores the other recipe that stood beside it before. */
  private goBack(): void {
    const { engine } = this;
    if (!engine) return;
    const then = this.pairs.get(this.store.state.recipe);
    if (then === undefined || then === engine.link()) return this.tell();
    engine.open(then);
    this.last = this.store.state.recipe;
    this.loop?.changed();
  }

  private remember(): void {
    this.last = this.store.state.recipe;
    if (this.engine) this.pairs.set(this.last, this.engine.link());
  }

  private drive(): void {
    const { loop } = this;
    const { paused, pace } = this.store.state;
    if (!loop) return;
    if (loop.paused !== paused) loop.paused = paused;
    loop.stepsPerFrame = pace;
  }

  /** Visitors who prefer less motion see finished or paused pictures only. */
  private shownAt(stage: string): string | undefined {
    return !wantsStill() || isEnd(stage) || this.store.state.paused ? this.view.words : undefined;
  }

  private drawn(stage: string, changed: boolean): void {
    const { engine, canvas } = this;
    if (!engine?.alive) return;
    const context = canvas.getContext('2d');
    const words = this.shownAt(stage);
    if (context && !engine.offers('frames') && changed && words !== undefined) {
      const side = engine.side();
      if (canvas.width !== side) canvas.width = canvas.height = side;
      engine.draw(context, words);
    }
    this.store.update({ other: stage });
    this.tell();
  }

  /** Writes names and counts below both. */
  private tell(): void {
    const { engine } = this;
    if (!engine) return;
    const { preset, recipe } = this.store.state;
    const mine = preset ? named(preset.shown.figure || preset.shown.title, preset.recipe === recipe) : t('compare_mine');
    write(this.names[0], named(this.title, engine.link() === this.link), engine);
    write(this.names[1], mine, this.work.engine);
  }
}

function named(name: string, same: boolean): string {
  return same ? name : t('compare_after', { name });
}

function write(line: HTMLElement, name: string, engine: Engine): void {
  if (!line.firstChild) line.append(make('strong'), make('span'));
  const [title, counts] = line.children;
  if (title) say(title, name);
  if (counts) say(counts, engine.problem() || counted(engine));
}

/**
 * Counts and time. The time covers the stages up to the present one, because later stages still hold the times of the
 * previous picture.
 */
function counted(engine: Engine): string {
  const { cells, steps, ms } = engine.status();
  const { stages, offers } = engine.generator;
  const at = stages.indexOf(engine.stage());
  const spent = stages.slice(0, at < 0 ? stages.length : at + 1).reduce((sum, word) => sum + (ms[word] ?? 0), 0);
  return t(offers.includes('forming') ? 'compare_counts' : 'compare_cells', { cells, steps, seconds: (spent / 1000).toFixed(2) });
}
