/**
 * The one place of all that the page knows by itself. What the visitor does changes the store; the engine and whatever
 * is seen follow it: recipe -> studio -> view, never the other way.
 *
 * The recipe in it is a link, which the engine checks and writes. So a step of the history is a link, undo opens one,
 * and the whole history fits into the browser's storage (history.ts, memory.ts).
 */

import type { Preset } from '../module/types';
import type { Camera, Zoomed } from './viewing';

export interface State {
  /** The recipe's link, without '#', as the engine writes it. */
  readonly recipe: string;
  /** The word of the generator at work. */
  readonly make: string;
  /** The link that is to be opened once its generator has come; '' where none is waited for. */
  readonly coming: string;
  /** Something is being dragged (a slider, a point): the recipe still changes, and is no step of the history yet. */
  readonly held: boolean;
  /** Recipes before and after this one, the nearest last and first. */
  readonly past: readonly string[];
  readonly future: readonly string[];
  /** The preset that the recipe is, or was made from by hand, and its recipe; undefined of recipes that came otherwise. */
  readonly preset: { shown: Preset; recipe: string } | undefined;
  /** The recipe is the visitor's own work, not just a link or a preset that was opened. */
  readonly own: boolean;
  /** The work is stored in this browser. */
  readonly stored: boolean;
  /** Packing steps a frame; below 1, several frames share one. */
  readonly pace: number;
  readonly paused: boolean;
  /** What is shown: a word of the views. */
  readonly view: string;
  /** What is drawn over it. */
  readonly overlays: readonly string[];
  /** How much closer than all of the picture, and where. */
  readonly zoom: Zoomed;
  /** So many copies of the picture stand along each side, as of a tile. */
  readonly repeat: number;
  /** The finished picture is shown as finely as the screen can. */
  readonly fine: boolean;
  /** Tools for looking closer that are shown. */
  readonly light: boolean;
  readonly layers: boolean;
  readonly compare: boolean;
  /** What is compared stands beside the picture, and forms together with it; else under a divider. */
  readonly beside: boolean;
  /** The stage of what stands beside the picture; 'done' while nothing does. */
  readonly other: string;
  readonly plots: boolean;
  /** The picture's bodies are seen from a slant, and where from; undefined until that was chosen. */
  readonly turn: boolean;
  readonly camera: Camera | undefined;
  /** One body alone, while it is shown how that is made: the number and the step (`ID:STEP`), and where it is seen from. */
  readonly body: { readonly subject: string; readonly camera: Camera } | undefined;
  /** What chance and presets leave alone: groups of parameters, and the seed. */
  readonly locks: readonly string[];
  /** The sort of figures whose points are shown; undefined while nothing is edited. */
  readonly editing: string | undefined;
  /** The stage at work, then 'done' or 'error'. */
  readonly stage: string;
}

type Listener = (now: State, before: State) => void;

export class Store {
  private now: State;
  private readonly listeners: { keys: readonly (keyof State)[]; listener: Listener }[] = [];

  constructor(first: State) {
    this.now = first;
  }

  get state(): State {
    return this.now;
  }

  /** Takes changes over, and tells those who listen to what did change. */
  update(change: Partial<State>): void {
    const before = this.now;
    this.now = { ...before, ...change };
    const changed = (Object.keys(change) as (keyof State)[]).filter((key) => this.now[key] !== before[key]);
    if (!changed.length) return;
    for (const { keys, listener } of this.listeners) {
      if (keys.some((key) => changed.includes(key))) listener(this.now, before);
    }
  }

  /** `listener` is called after changes of any of these; in the order in which listeners came. */
  on(keys: readonly (keyof State)[], listener: Listener): void {
    this.listeners.push({ keys, listener });
  }
}
