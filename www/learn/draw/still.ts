/** A figure as it stands in the static page: its picture at the opening step, its tools, and the text of its state. */
import { figureOf } from '../figures/figures';
import type { Figure, Language } from '../figures/figure';
import { curveOf, platesOf, stopsOf } from './picture';
import type { View } from './plate';
import { Reading } from './reading';
import { zeroOf, type Bubbles } from './studio';
import { toolsOf } from './tools';

/** The inside of `.figure-stage`. The module must be initialised; its numbers are those that the page will show. */
export function stillOf(module: Bubbles, name: string, language: Language): string {
  const figure = figureOf(name);
  if (!figure) throw new Error(`There is no figure ${name}.`);
  const readings = figure.packings.map((own) => new Reading(module, figure, figure.recipe, own));
  for (const reading of readings) while (!reading.advance(1000));
  const step = figure.opens;
  const zero = zeroOf(module);
  const view: View = { traces: readings, step, last: figure.last, curve: curveOf(module), zero, mark: figure.mark, isZeroShown: false, stops: stopsOf(figure, readings), language };
  const told = figure.told({ traces: readings, step, trials: [], mark: figure.mark ?? 0, zero }, language);
  const html = markupOf(platesOf(figure, view), toolsOf(figure, language, (key) => valueOf(readings, step, figure, key)), told);
  for (const reading of readings) reading.free();
  return html;
}

/** The value of a handle at a step. */
function valueOf([reading]: readonly Reading[], step: number, { mark }: Figure, key: string): string {
  return key === 'mark' ? String(mark ?? 0) : key === 'w' ? String(reading?.moments[step]?.w ?? 0) : (reading?.value(key) ?? '');
}

function markupOf(plates: readonly string[], tools: string, told: string): string {
  const boxes = plates.map((plate, k) => `<div class="plate-box" data-plate="${k}"><div class="plate-svg">${plate}</div></div>`).join('');
  return `<div class="plates plates-${plates.length}">${boxes}</div><div class="figure-tools">${tools}</div><p class="figure-told">${told}</p>`;
}
