/**
 * The page's state. The visitor's actions change the store; the engine and everything visible follow it: recipe ->
 * studio -> view, never the other way.
 *
 * The recipe in the store is a link, which the engine checks and writes. So a step of the history is a link, undo opens
 * one, and the whole history fits into the browser's storage (history.ts, memory.ts).
 */

import type { Preset } from '../module/types';
import type { Camera, Cut, Zoomed } from './viewing';

export interface State {
  /** The recipe's link, without '#', as the engine writes it. */
  readonly recipe: string;
  /** The word of the present generator. */
  readonly make: string;
  /** The link to open once its generator is loaded; '' if there is none. */
  readonly coming: string;
  /** Something is being dragged (a slider, a point): the recipe changes without making steps of the history. */
  readonly held: boolean;
  /** The recipes before this one, nearest last, and after it, nearest first. */
  readonly past: readonly string[];
  readonly future: readonly string[];
  /** The preset that was opened, and its recipe. Undefined if the recipe does not come from a preset. */
  readonly preset: { shown: Preset; recipe: string } | undefined;
  /** The recipe is the visitor's own work, not only an opened link or preset. */
  readonly own: boolean;
  /** The work is stored in this browser. */
  readonly stored: boolean;
  /** Packing steps per frame; below 1, one step takes several frames. */
  readonly pace: number;
  readonly paused: boolean;
  /** The view's word. */
  readonly view: string;
  /** The words of the view's overlays. */
  readonly overlays: readonly string[];
  /** The zoom and its middle. */
  readonly zoom: Zoomed;
  /** The number of copies of the picture along each side, to show a tile. */
  readonly repeat: number;
  /** The finished picture is shown as finely as the screen can. */
  readonly fine: boolean;
  /** The tools for a closer look that are open. */
  readonly light: boolean;
  readonly layers: boolean;
  readonly compare: boolean;
  /** The compared picture stands beside the page's own and forms in step; otherwise it is under a divider. */
  readonly beside: boolean;
  /** The stage of the picture beside; 'done' while there is none. */
  readonly other: string;
  readonly plots: boolean;
  /** Whether the bodies are shown by a camera, and that camera; undefined until the visitor chose one. */
  readonly turn: boolean;
  readonly camera: Camera | undefined;
  /** The plane beyond which bodies are cut away. */
  readonly cut: Cut | undefined;
  /** The single body whose making is shown: its number and step (`ID:STEP`), and the camera. */
  readonly body: { readonly subject: string; readonly camera: Camera } | undefined;
  /** The step of a body that a link asks for (`ID:STEP`), until it is shown; '' if there is none. */
  readonly asked: string;
  /** Locks against randomising and presets: groups of parameters, and the seed. */
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

  /** Applies changes, and calls the listeners of the values that really changed. */
  update(change: Partial<State>): void {
    const before = this.now;
    this.now = { ...before, ...change };
    const changed = (Object.keys(change) as (keyof State)[]).filter((key) => this.now[key] !== before[key]);
    if (!changed.length) return;
    for (const { keys, listener } of this.listeners) {
      if (keys.some((key) => changed.includes(key))) listener(this.now, before);
    }
  }

  /** Calls `listener` after changes of any of these values. Listeners are called in the order in which they were added. */
  on(keys: readonly (keyof State)[], listener: Listener): void {
    this.listeners.push({ keys, listener });
  }
}
