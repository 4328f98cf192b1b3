/** A figure as it stands in the static page: its picture at the opening step, its tools, and the text of its state. */
import type { Figure, Language, Trial, View } from '../figures/figure';
import { shownOf } from './chapters';
import { curveOf, lastStepOf, notesOf, platesOf, stopsOf, toldOf, type Shown } from './picture';
import { Reading, shownPoints, shownValue } from './reading';
import { zeroOf, type Bubbles } from './studio';
import { toolsOf } from './tools';

/** The inside of `.figure-stage`. The module must be initialised; its numbers are those that the page will show. */
export function stillOf(module: Bubbles, name: string, language: Language): string {
  const shown = shownOf(name);
  const { figure } = shown;
  const readings = figure.packings.map((own) => new Reading(module, figure, figure.recipe, own));
  for (const reading of readings) while (!reading.advance(1000));
  const html = markupOf(shown, viewOf(module, figure, readings, language), readings);
  for (const reading of readings) reading.free();
  return html;
}

function viewOf(module: Bubbles, figure: Figure, readings: readonly Reading[], language: Language): View {
  const last = lastStepOf(figure, readings);
  const step = Math.min(figure.opens, last);
  const stops = stopsOf(figure, readings);
  return { traces: readings, step, last, furthest: step, curve: curveOf(module), zero: zeroOf(module), at: figure.at, trials: trialsOf(figure, readings, step), isStill: true, isZeroShown: false, answered: new Set(), stops, language };
}

/** The trial of the start that the figure opens with, if its end is seen already. */
function trialsOf({ trial }: Figure, [reading]: readonly Reading[], step: number): Trial[] {
  const own = reading && trial?.(reading, step);
  return own ? [own] : [];
}

function markupOf(shown: Shown & { readonly chapter: string }, view: View, readings: readonly Reading[]): string {
  const { figure, chapter } = shown;
  const { step, last, at, language } = view;
  const notes = notesOf(figure, view);
  const drawn = platesOf(shown, view);
  const boxes = drawn.map((plate, k) => titled(figure, k, notes[k], language, `<div class="plate-box" data-plate="${k}"><div class="plate-svg">${plate}</div></div>`));
  const tools = toolsOf(figure, language, { step, last, value: (key) => shownValue(readings, step, at, key), points: (handle) => shownPoints(readings, step, at, handle) });
  return `<div class="${classesOf(figure, drawn)}" data-chapter="${chapter}">${boxes.join('')}</div><div class="figure-tools">${tools}</div><p class="figure-told">${toldOf(figure, view)}</p>`;
}

/**
 * The classes of the plates' box: how many plates and how many twins there are, and whether twins have words. A style that
 * asks for them with `:has` would be worked out anew at each step.
 */
function classesOf({ plates }: Figure, drawn: readonly string[]): string {
  const twins = drawn.filter((_, k) => isTwin(plates, k));
  const all = `plates plates-${drawn.length}`;
  if (!twins.length) return all;
  return `${all} twins twins-${twins.length}${twins.some((plate) => plate.includes('<text')) ? ' worded' : ''}`;
}

/** Whether a titled plate is compared with another one, which is drawn in the same way. */
function isTwin(plates: Figure['plates'], k: number): boolean {
  const { title, draw } = plates[k] ?? {};
  return title !== undefined && draw !== 'track' && plates.some((other, at) => at !== k && other.draw === draw);
}

/** A plate with its title, unless the drawing shows the title itself. The note changes with the steps. */
function titled({ plates }: Figure, k: number, note: string | undefined, language: Language, box: string): string {
  const { title, draw } = plates[k] ?? {};
  if (!title || draw === 'track') return box;
  const follows = note === undefined ? '' : ` <output class="plate-note" data-plate="${k}">${note}</output>`;
  return `<div class="plate-cell${isTwin(plates, k) ? ' twin' : ''}"><p class="plate-name"><b>${title[language]}</b>${follows}</p>${box}</div>`;
}
