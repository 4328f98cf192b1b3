/** The state of a figure in the address: its name, the words of its recipe, a step, and the place that is looked at. */
import { figureOf } from '../figures/figures';
import type { Figure } from '../figures/figure';

export interface State {
  readonly recipe: string;
  readonly step: number;
  readonly at: readonly number[];
}

/** The words that are not the recipe's. */
const OWN = ['fig', 'step', 'at'];

export function stateWords(name: string, { recipe, step, at }: State): string {
  return [`fig=${name}`, recipe, `step=${step}`, ...(at.length ? [`at=${at.map((value) => value.toFixed(3)).join(',')}`] : [])].join('&');
}

/** The figure that a fragment opens, and its state. */
export function stateIn(fragment: string): { readonly figure: Figure; readonly state: State } | undefined {
  const pairs = new Map(fragment.split('&').map((word) => [word.split('=')[0] ?? '', word.slice(word.indexOf('=') + 1)]));
  const figure = figureOf(pairs.get('fig') ?? '');
  if (!figure) return undefined;
  const recipe = fragment.split('&').filter((word) => word && !OWN.includes(word.split('=')[0] ?? '')).join('&');
  const step = whole(pairs.get('step'), figure.opens, figure.last);
  const at = placeIn(pairs.get('at'), figure);
  return { figure, state: { recipe: recipe || figure.recipe, step, at } };
}

function whole(text: string | undefined, otherwise: number, most: number): number {
  const value = Number(text ?? otherwise);
  return Number.isFinite(value) ? Math.max(0, Math.min(most, Math.round(value))) : otherwise;
}

/** The place looked at: the numbers of the address, as far as the figure's handle can have them. */
function placeIn(text: string | undefined, { at, handles }: Figure): readonly number[] {
  const handle = handles.find(({ key }) => key === 'mark' || key === 'at');
  const numbers = text?.split(',').map(Number) ?? [];
  if (!handle || handle.kind === 'choice' || numbers.length !== at.length || !numbers.every(Number.isFinite)) return at;
  const [from, to] = handle.kind === 'point' ? [0, 1] : [handle.from, handle.to];
  return numbers.map((value) => Math.max(from, Math.min(to, value)));
}

/** The state of a figure before anything is done. */
export function opening(figure: Figure): State {
  return { recipe: figure.recipe, step: figure.opens, at: figure.at };
}
