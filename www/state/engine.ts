/**
 * The studio in WebAssembly behind one guard: when a call fails, the page is told once, and later
 * calls answer with harmless values instead of failing again.
 */
import type { Bubblestone } from '../../pkg/bubblestone.js';
import { dropModule, loadModule, moduleFor, type Module } from '../module/load';
import type { Absence, Answer, Generator, Histograms, Parameter, Point, Preset, Probe, Ring, Series, Status } from '../module/types';
import { parameterIn, presetIn, said, t } from '../words/words';

/** What became of what was asked for. */
export interface Told {
  /** It cannot be used, and what was there stays. */
  refused: boolean;
  /** Why it was refused, or what was clamped or mended. */
  sentences: string[];
}

const NO_ANSWER: Answer = { refused: true, notices: [] };

const NO_GENERATOR: Generator = { word: '', title: '', stages: [], bases: [], overlays: [], offers: [] };

const NO_STATUS: Status = {
  cells: 0,
  steps: 0,
  largestMove: 0,
  energy: 0,
  added: 0,
  removed: 0,
  converged: false,
  stones: 0,
  ms: {},
};

/** Loads the module that a link needs. Throws an Error whose message is a sentence for the visitor. */
export async function load(link: string): Promise<void> {
  if (typeof WebAssembly !== 'object') {
    throw new Error(t('no_wasm'));
  }
  try {
    await loadModule(link);
  } catch (error) {
    if (error instanceof WebAssembly.CompileError) {
      throw new Error(t('old_wasm'), { cause: error });
    }
    throw new Error(t('lost_wasm'), { cause: error });
  }
}

export class Engine {
  /** Is told when a link of a generator that had to be loaded is open at last, or cannot be; with what is to be said. */
  arrived: (sentences: string[], failed: boolean) => void = () => undefined;
  private core: Bubblestone | undefined;
  private module: Module | undefined;
  /** A link whose module is on its way; what was there before is at work, and seen, until then. */
  private coming: string | undefined;
  private readonly crashed: (error: unknown, link: string) => void;
  private dead = false;
  private lastLink: string;
  private made: Generator[] | undefined;
  private readonly rows = new Map<string, Parameter[]>();
  private readonly known = new Map<string, Preset[]>();

  /** The module of the link has to be there. Never throws; a failure reaches `crashed` with the last known link. */
  constructor(link: string, crashed: (error: unknown, link: string) => void) {
    this.crashed = crashed;
    this.lastLink = link.replace(/^#/, '');
    this.begin(link);
  }

  private begin(link: string): void {
    this.module = moduleFor(link);
    this.made = undefined;
    this.core = this.guard(() => this.module && new this.module.Bubblestone(link), undefined);
  }

  /** What is made now. */
  get generator(): Generator {
    const word = this.ask((core) => core.generator(), '');
    this.made ??= this.guard(() => this.module?.generators(), undefined) ?? [];
    return this.made.find((one) => one.word === word) ?? NO_GENERATOR;
  }

  /** The parameters of what is made now. */
  get schema(): Parameter[] {
    const { word } = this.generator;
    return kept(this.rows, word, () => this.guard(() => this.module?.schema(word).map(parameterIn), undefined) ?? []);
  }

  /** The presets of what is made now. */
  get presets(): Preset[] {
    const { word } = this.generator;
    return kept(this.known, word, () => this.guard(() => this.module?.presets(word).map(presetIn), undefined) ?? []);
  }

  get alive(): boolean {
    return !this.dead;
  }

  /** Opens a link, at once or, where its generator is not here yet, when it has come: `arrived` tells of that. */
  open(link: string): string[] {
    this.coming = undefined;
    if (!this.knows(link)) {
      void this.bring(link);
      return [];
    }
    this.lastLink = link.replace(/^#/, '');
    return this.ask((core) => core.open(link), []).map(said);
  }

  /** Is what a link asks for still on its way? */
  get waits(): boolean {
    return this.coming !== undefined;
  }

  private knows(link: string): boolean {
    return this.module !== undefined && moduleFor(link) === this.module;
  }

  private async bring(link: string): Promise<void> {
    this.coming = link.replace(/^#/, '');
    try {
      await load(link);
    } catch (error) {
      // Another link was opened meanwhile.
      if (this.coming !== link) return;
      this.coming = undefined;
      this.arrived([error instanceof Error ? error.message : String(error)], true);
      return;
    }
    if (this.dead || this.coming !== link) return;
    this.coming = undefined;
    const { core, module } = this;
    this.guard(() => core?.free(), undefined);
    this.lastLink = link;
    this.begin(link);
    this.arrived(this.notices(), false);
    if (module && module !== this.module) dropModule(module);
  }

  notices(): string[] {
    return this.ask((core) => core.notices(), []).map(said);
  }

  /** The link's fragment, without '#'. */
  link(): string {
    if (this.coming !== undefined) return this.coming;
    this.lastLink = this.ask((core) => core.link(), this.lastLink);
    return this.lastLink;
  }

  set(key: string, text: string): Told {
    this.coming = undefined;
    return told(this.ask((core) => core.set(key, text), NO_ANSWER));
  }

  get(key: string): string {
    return this.ask((core) => core.get(key), '');
  }

  /** A parameter's default in the recipe at hand: that of some numbers depends on the kind of stone. */
  defaultOf({ key, kind, default: plain }: Parameter): string {
    if (kind !== 'number' && kind !== 'int') return plain;
    return this.ask((core) => String(core.defaultOf(key)), plain);
  }

  /** Works for about `budget` milliseconds; true when what is shown may have changed. */
  tick(budget: number, steps: number): boolean {
    return this.ask((core) => core.tick(budget, steps), false);
  }

  /** While live, the cells flow after each change; the end of it makes them anew, as the link asks. */
  live(on: boolean): void {
    this.ask((core) => core.setLive(on), undefined);
  }

  step(): void {
    this.ask((core) => core.step(), undefined);
  }

  restart(): void {
    this.ask((core) => core.restart(), undefined);
  }

  /** The word of the stage at work, then 'done', or 'error' where no pavement can be made. */
  stage(): string {
    return this.ask((core) => core.stage(), 'error');
  }

  /** Why the stage is 'error'; '' while all is well. */
  problem(): string {
    const problem = this.ask((core) => core.problem(), undefined);
    return problem ? said(problem) : '';
  }

  status(): Status {
    return this.ask((core) => core.status(), NO_STATUS);
  }

  /** Draws a view's pieces for about `budget` milliseconds; true when `draw` has only the rest to do. */
  prepare(view: string, budget: number): boolean {
    return this.ask((core) => core.prepare(view, budget), true);
  }

  /** Draws a view: words joined by '+', at most one of a base, any of overlays; see `draw` of the module. */
  draw(context: CanvasRenderingContext2D, view: string): void {
    this.ask((core) => core.draw(context, view), undefined);
  }

  /** What of a view shows nothing, by its word, and why. */
  absences(view: string): Map<string, Absence> {
    const told = this.ask((core) => core.absences(view), []);
    return new Map(told.map((one) => one.split(':') as [string, Absence]));
  }

  /** From black to white in the view 'height', in pixels; 0 before there is anything. */
  heightRange(): number {
    return this.ask((core) => core.heightRange(), 0);
  }

  /** The cell at a place in picture units. */
  probe([x, y]: Point): Probe | undefined {
    return this.ask((core) => core.probe(x, y), undefined);
  }

  /** How the packing went so far. */
  series(): Series {
    const none = { step: new Float64Array(), energy: new Float64Array(), move: new Float64Array() };
    return this.ask((core) => core.series(), none);
  }

  histograms(): Histograms {
    const none = { from: 0, to: 0, counts: new Uint32Array() };
    return this.ask((core) => core.histograms(), { size: none, angle: none });
  }

  digest(): string {
    return this.ask((core) => core.digest(), '');
  }

  side(): number {
    return this.ask((core) => core.side(), 512);
  }

  setOutline(rings: Ring[]): Told {
    this.coming = undefined;
    const points = new Float64Array(rings.flat(2));
    const lengths = new Uint32Array(rings.map((ring) => ring.length));
    return told(this.ask((core) => core.setOutline(points, lengths), NO_ANSWER));
  }

  outline(): Ring[] {
    const none = { points: new Float64Array(), rings: new Uint32Array() };
    const { points, rings } = this.ask((core) => core.outline(), none);
    let at = 0;
    return Array.from(rings, (count) =>
      Array.from({ length: count }, (): Point => {
        const point: Point = [points[at] ?? 0, points[at + 1] ?? 0];
        at += 2;
        return point;
      }),
    );
  }

  /** The rows of a list parameter; lengths in sides of the picture. */
  list(key: string): number[][] {
    const none = { numbers: new Float64Array(), rows: new Uint32Array() };
    const { numbers, rows } = this.ask((core) => core.list(key), none);
    let at = 0;
    return Array.from(rows, (count) => Array.from(numbers.slice(at, (at += count))));
  }

  /** The part of the outline that holds this place; -1 outside. */
  part([x, y]: Point): number {
    return this.ask((core) => core.part(x, y), -1);
  }

  randomSeed(): number {
    return this.guard(() => this.module?.random_seed(), undefined) ?? 1;
  }

  free(): void {
    if (!this.dead) this.ask((core) => core.free(), undefined);
    this.dead = true;
  }

  private ask<T>(call: (core: Bubblestone) => T, otherwise: T): T {
    const core = this.core;
    return core ? this.guard(() => call(core), otherwise) : otherwise;
  }

  private guard<T>(call: () => T, otherwise: T): T {
    if (this.dead) return otherwise;
    try {
      return call();
    } catch (error) {
      this.dead = true;
      this.crashed(error, this.lastLink);
      return otherwise;
    }
  }
}

function kept<T>(all: Map<string, T>, key: string, made: () => T): T {
  const value = all.get(key) ?? made();
  all.set(key, value);
  return value;
}

function told({ refused, notices }: Answer): Told {
  return { refused, sentences: notices.map(said) };
}
