/** The state of a figure in the address: its name, the words of its recipe, a step, and the place that is looked at. */
import type { Figure } from '../figures/figure';
import { markAt } from '../figures/marks';

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

/** The words of a figure's state for the studio, which shows the step of the packing, or the directions. */
export function studioWords({ steps }: Figure, { recipe, step }: Pick<State, 'recipe' | 'step'>): string {
  if (steps === 'walk') return `${recipe}&view=direction`;
  return `${recipe}&view=packed${steps === 'step' ? `&step=${step}` : ''}`;
}

/** The name of the figure that a fragment opens; '' if it opens none. */
export function figureIn(fragment: string): string {
  return wordsOf(fragment).get('fig') ?? '';
}

/** A figure's state in a fragment. */
export function stateIn(fragment: string, figure: Figure): State {
  const words = wordsOf(fragment);
  const recipe = fragment.split('&').filter((word) => word && !OWN.includes(word.split('=')[0] ?? '')).join('&');
  return { recipe: recipe || figure.recipe, step: whole(words.get('step'), figure.opens, figure.last), at: placeIn(words.get('at'), figure) };
}

function wordsOf(fragment: string): ReadonlyMap<string, string> {
  return new Map(fragment.split('&').map((word) => [word.split('=')[0] ?? '', word.slice(word.indexOf('=') + 1)]));
}

function whole(text: string | undefined, otherwise: number, most: number): number {
  const value = Number(text ?? otherwise);
  return Number.isFinite(value) ? Math.max(0, Math.min(most, Math.round(value))) : otherwise;
}

/** The place looked at: the numbers of the address, as far as the figure's handle can have them. */
function placeIn(text: string | undefined, figure: Figure): readonly number[] {
  const numbers = text?.split(',').map(Number) ?? [];
  if (numbers.length !== figure.at.length || !numbers.every(Number.isFinite)) return figure.at;
  return numbers.map((value, k) => {
    const [from, to] = limitsOf(figure, k);
    return Math.max(from, Math.min(to, value));
  });
}

/** The limits of a number of the place looked at: those of its handle, or the sides of the picture. */
function limitsOf({ handles, more }: Figure, k: number): readonly [from: number, to: number] {
  const all = [...handles, ...more];
  const own = all.find(({ key }) => markAt(key) === k);
  if (own?.kind === 'number') return [own.from, own.to];
  const point = all.find(({ key }) => key === 'at');
  if (point?.kind !== 'point' || !point.area) return [0, 1];
  const { origin, scale, area } = point;
  const share = (axis: number, shown: number): number => (origin[axis] ?? 0) + scale * shown;
  return k ? [share(1, area[1]), share(1, area[3])] : [share(0, area[0]), share(0, area[2])];
}

/** The state of a figure before anything is done. */
export function opening(figure: Figure): State {
  return { recipe: figure.recipe, step: figure.opens, at: figure.at };
}
