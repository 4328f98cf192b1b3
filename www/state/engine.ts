/**
 * The studio in WebAssembly behind one guard. When a call fails, the page is notified once; later calls return
 * harmless values instead of failing again.
 */
import type { Bubblestone } from '../../pkg/bubblestone.js';
import type { RecipeFile } from '../../pkg-house/bubblestone.js';
import { knowingAll } from '../module/generators';
import { leaveModule, moduleFor, useModule, type Module } from '../module/load';
import type { SceneStudio } from '../module/scene';
import type { Absence, Answer, Generator, Notice, Parameter, Point, Preset, Probe, Ring, Status } from '../module/types';
import { parameterIn, presetIn, said } from '../words/words';
import { NO_ANSWER, NO_GENERATOR, NO_STATUS } from './answers';
import { FileSearch } from './search';

/** The result of setting a value. */
export interface SetResult {
  /** The value cannot be used; the old one stays. */
  refused: boolean;
  /** Why it was refused, clamped or corrected. */
  sentences: string[];
}

export class Engine {
  private core: Bubblestone | undefined;
  private module: Module | undefined;
  private readonly crashed: (error: unknown, link: string) => void;
  private dead = false;
  private lastLink: string;
  private made: Generator[] | undefined;
  private readonly search = new FileSearch();
  private readonly rows = new Map<string, Parameter[]>();
  private readonly known = new Map<string, Preset[]>();

  /** The link's module must be loaded. Never throws; a failure is passed to `crashed` with the last known link. */
  constructor(link: string, crashed: (error: unknown, link: string) => void) {
    this.crashed = crashed;
    this.lastLink = link.replace(/^#/, '');
    this.begin(link);
  }

  private begin(link: string): void {
    const module = moduleFor(link);
    if (!module) throw new Error('The module of a link was not loaded before it was opened.');
    this.module = module;
    this.made = undefined;
    useModule(module);
    this.core = this.guard(() => new module.Bubblestone(link), undefined);
    this.seek();
  }

  private end(): void {
    this.ask((core) => core.free(), undefined);
    this.core = undefined;
    this.search.end();
    if (this.module) leaveModule(this.module);
    this.module = undefined;
  }

  /** The present generator. */
  get generator(): Generator {
    const word = this.ask((core) => core.generator(), '');
    this.made ??= this.guard(() => this.module?.generators(), undefined) ?? [];
    return this.made.find((one) => one.word === word) ?? NO_GENERATOR;
  }

  /** The parameters of the present generator. */
  get schema(): Parameter[] {
    const { word } = this.generator;
    return kept(this.rows, word, () => this.guard(() => this.module?.schema(word).map((row) => parameterIn(word, row)), undefined) ?? []);
  }

  /** The presets of the present generator. */
  get presets(): Preset[] {
    const { word } = this.generator;
    return kept(this.known, word, () => this.guard(() => this.module?.presets(word).map(presetIn), undefined) ?? []);
  }

  /** Whether the present generator offers this part; see `Generator` of the module. */
  offers(part: string): boolean {
    return this.generator.offers.includes(part);
  }

  get alive(): boolean {
    return !this.dead;
  }

  /** Opens a link, whose module must be loaded. If that is another module, the previous one is released. */
  open(link: string): string[] {
    if (this.dead) return [];
    this.lastLink = link.replace(/^#/, '');
    this.search.end();
    if (moduleFor(link) === this.module) {
      const notices = this.ask((core) => core.open(link), []);
      this.seek();
      return notices.map(knowingAll).map(said);
    }
    this.end();
    this.begin(link);
    return this.notices();
  }

  /** Goes on with a studio of this module that has begun to work on a link. The previous studio is released. */
  adopt(studio: SceneStudio, module: Module): void {
    if (this.dead) return studio.free();
    this.search.end();
    // The new use is counted first, so that the module stays.
    useModule(module);
    this.end();
    [this.module, this.made, this.core] = [module, undefined, studio];
    this.link();
    this.seek();
  }

  notices(): string[] {
    return this.ask((core) => core.notices(), []).map(knowingAll).map(said);
  }

  /** The link's fragment, without '#'. */
  link(): string {
    this.lastLink = this.ask((core) => core.link(), this.lastLink);
    return this.lastLink;
  }

  set(key: string, text: string): SetResult {
    const answer = told(this.ask((core) => core.set(key, text), NO_ANSWER));
    this.seek();
    return answer;
  }

  get(key: string): string {
    return this.ask((core) => core.get(key), '');
  }

  /** A parameter's default in the present recipe: some defaults depend on the kind of stone. */
  defaultOf({ key, kind, default: plain }: Parameter): string {
    if (kind !== 'number' && kind !== 'int') return plain;
    return this.ask((core) => String(core.defaultOf(key)), plain);
  }

  /** Works for about `budget` milliseconds; true if the picture may have changed. */
  tick(budget: number, steps: number): boolean {
    return !this.search.on && this.ask((core) => core.tick(budget, steps), false);
  }

  /** While live, the cells flow after each change. At the end they are made again, exactly as the link describes. */
  live(on: boolean): void {
    this.ask((core) => core.setLive(on), undefined);
  }

  step(): void {
    this.ask((core) => core.step(), undefined);
  }

  /** Makes the steps again, from the held one if there is one. */
  restart(): void {
    this.ask((core) => core.restart(), undefined);
  }

  /** Holds a step of the packing, which `reach` makes; without a step, lets go. */
  hold(step?: number): void {
    this.ask((core) => core.hold(step), undefined);
  }

  /** Works for about `budget` milliseconds towards the held step; true when it is reached. */
  reach(budget: number): boolean {
    return this.ask((core) => core.reach(budget), true);
  }

  /** The word of the stage at work, then 'done', or 'error' if the recipe gives no picture. */
  stage(): string {
    return this.search.on ? (this.generator.stages[0] ?? '') : this.ask((core) => core.stage(), 'error');
  }

  /** Why the stage is 'error'; '' without an error. */
  problem(): string {
    const problem = this.ask((core) => core.problem(), undefined);
    return problem ? said(problem) : '';
  }

  /** The value of a parameter that mends the problem, if the problem's sentence names one. */
  remedy(): readonly [key: string, value: string] | undefined {
    const { row, fits } = this.ask((core) => core.problem(), undefined)?.args ?? {};
    return typeof row === 'object' && 'name' in row && typeof fits === 'string' ? [row.key, fits] : undefined;
  }

  status(): Status {
    return this.ask((core) => core.status(), NO_STATUS);
  }

  /** Prepares a view's pieces for about `budget` milliseconds; true when only `draw` is left to do. */
  prepare(view: string, budget: number): boolean {
    return this.ask((core) => core.prepare(view, budget), true);
  }

  /** Draws a view: words joined by '+', at most one base and any overlays; see `draw` of the module. Returns the pixels along its side. */
  draw(context: CanvasRenderingContext2D, view: string): number {
    return this.ask((core) => core.draw(context, view), 0);
  }


  /** The caption of a view: the meaning of its colours, or a count; '' if it has none. */
  caption(view: string): string {
    const caption = this.askWhole((studio) => studio.caption(view), undefined);
    return caption ? said(caption) : '';
  }

  /** Remarks on the result: repairs, and parts that do not fit well. */
  remarks(): Notice[] {
    return this.ask((core) => core.remarks(), []);
  }

  /** The parts of a view that show nothing, by word, with the reason. */
  absences(view: string): Map<string, Absence> {
    const told = this.ask((core) => core.absences(view), []);
    return new Map(told.map((one) => one.split(':') as [string, Absence]));
  }

  /** The difference in height between black and white in the view 'height', in pixels; 0 before there are heights. */
  heightRange(): number {
    return this.ask((core) => core.heightRange(), 0);
  }

  /** The cell at a place in picture units. */
  probe([x, y]: Point): Probe | undefined {
    return this.ask((core) => core.probe(x, y), undefined);
  }

  digest(): string {
    return this.ask((core) => core.digest(), '');
  }

  side(): number {
    return this.ask((core) => core.side(), 512);
  }

  setOutline(rings: Ring[]): SetResult {
    const points = new Float64Array(rings.flat(2));
    const lengths = new Uint32Array(rings.map((ring) => ring.length));
    return told(this.ask((core) => core.setOutline(points, lengths), NO_ANSWER));
  }

  /** Another link with an outline, whose unit is the side of the picture. The present recipe stays. */
  drawn(link: string, rings: Ring[]): SetResult & { link: string } {
    const { module } = this;
    const refused = { link: '', refused: true, sentences: [] };
    if (!module) return refused;
    return this.guard(() => {
      const studio = new module.Bubblestone(link);
      const points = new Float64Array(rings.flat(2)).map((value) => value * studio.side());
      const answer = told(studio.setOutline(points, new Uint32Array(rings.map((ring) => ring.length))));
      const drawn = { ...answer, link: studio.link() };
      studio.free();
      return drawn;
    }, refused);
  }

  outline(): Ring[] {
    const none = { points: new Float64Array(), rings: new Uint32Array() };
    const { points, rings } = this.ask((core) => core.outline(), none);
    const flat = rowsOf(points, rings, 2);
    return flat.map((ring) => Array.from({ length: ring.length / 2 }, (_, k): Point => [ring[2 * k] ?? 0, ring[2 * k + 1] ?? 0]));
  }

  /** The rows of a list parameter; lengths are in sides of the picture. */
  list(key: string): number[][] {
    const none = { numbers: new Float64Array(), rows: new Uint32Array() };
    const { numbers, rows } = this.ask((core) => core.list(key), none);
    return rowsOf(numbers, rows, 1);
  }

  /** The index of the part of the outline that contains this place; -1 outside. */
  part([x, y]: Point): number {
    return this.ask((core) => core.part(x, y), -1);
  }

  /** Calls the studio; returns `otherwise` if it has failed. */
  ask<T>(call: (core: Bubblestone) => T, otherwise: T): T {
    const core = this.core;
    return core ? this.guard(() => call(core), otherwise) : otherwise;
  }

  /** Calls the whole module; returns `otherwise` if another module is at work. */
  askWhole<T>(call: (studio: SceneStudio) => T, otherwise: T): T {
    return this.ask((core) => (isWhole(core) ? call(core) : otherwise), otherwise);
  }

  /** The files that the work waits for; empty while they are being searched for. */
  missing(): RecipeFile[] {
    return this.search.on ? [] : this.waitsFor();
  }

  /** The files that the recipe names. */
  files(): RecipeFile[] {
    return this.askWhole((studio) => studio.recipeFiles(), []);
  }

  private waitsFor(): RecipeFile[] {
    return this.askWhole((studio) => studio.missingFiles(), []);
  }

  randomSeed(): number {
    return this.guard(() => this.module?.random_seed(), undefined) ?? 1;
  }

  private seek(): void {
    if (this.core) this.search.begin(this.core, this.waitsFor());
  }

  free(): void {
    this.end();
    this.dead = true;
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

/** Splits numbers into rows. A row's length is given in items, and an item has `each` numbers. */
function rowsOf(numbers: Float64Array, lengths: Uint32Array, each: number): number[][] {
  let at = 0;
  return Array.from(lengths, (length) => Array.from(numbers.slice(at, (at += each * length))));
}

function isWhole(core: Bubblestone): core is SceneStudio {
  return 'missingFiles' in core;
}

function kept<T>(all: Map<string, T>, key: string, made: () => T): T {
  const value = all.get(key) ?? made();
  all.set(key, value);
  return value;
}

function told({ refused, notices }: Answer): SetResult {
  return { refused, sentences: notices.map(said) };
}
