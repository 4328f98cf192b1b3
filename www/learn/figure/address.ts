/** The state of a figure in the address: its name, the words of its recipe, a step, and the place that is looked at. */
import { figureOf } from '../figures/figures';
import type { Figure } from '../figures/figure';

export interface State {
  readonly recipe: string;
  readonly step: number;
  readonly mark: number | undefined;
}

/** The words that are not the recipe's. */
const OWN = ['fig', 'step', 'at'];

export function stateWords(name: string, { recipe, step, mark }: State): string {
  return [`fig=${name}`, recipe, `step=${step}`, ...(mark === undefined ? [] : [`at=${mark.toFixed(3)}`])].join('&');
}

/** The figure that a fragment opens, and its state. */
export function stateIn(fragment: string): { readonly figure: Figure; readonly state: State } | undefined {
  const pairs = new Map(fragment.split('&').map((word) => [word.split('=')[0] ?? '', word.slice(word.indexOf('=') + 1)]));
  const figure = figureOf(pairs.get('fig') ?? '');
  if (!figure) return undefined;
  const recipe = fragment.split('&').filter((word) => word && !OWN.includes(word.split('=')[0] ?? '')).join('&');
  const step = whole(pairs.get('step'), figure.opens, figure.last);
  const mark = share(pairs.get('at'), figure);
  return { figure, state: { recipe: recipe || figure.recipe, step, mark } };
}

function whole(text: string | undefined, otherwise: number, most: number): number {
  const value = Number(text ?? otherwise);
  return Number.isFinite(value) ? Math.max(0, Math.min(most, Math.round(value))) : otherwise;
}

function share(text: string | undefined, { mark, handles }: Figure): number | undefined {
  const handle = handles.find(({ key }) => key === 'mark');
  const value = Number(text ?? mark);
  if (mark === undefined || handle?.kind !== 'number') return undefined;
  return Number.isFinite(value) ? Math.max(handle.from, Math.min(handle.to, value)) : mark;
}

/** The state of a figure before anything is done. */
export function opening(figure: Figure): State {
  return { recipe: figure.recipe, step: figure.opens, mark: figure.mark };
}
