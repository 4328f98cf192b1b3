/** Pieces of the glossary's small pictures. Places are units of 120 x 80. */
import type { Place } from '../figures/place';
import { at, circle } from './plate';
import type { Bubbles, Studio } from './studio';

export type Draw = (module: Bubbles) => string;

export const [WIDTH, HEIGHT] = [120, 80];
export const MIDDLE: Place = [WIDTH / 2, HEIGHT / 2];

export const bubble = (place: Place, radius: number): string => circle(place, radius, 'bubble');
/** A circle without its inside. */
export const ring = ([x, y]: Place, radius: number, kind: string): string => `<path class="${kind}" d="M${at(x - radius)} ${at(y)}a${at(radius)} ${at(radius)} 0 1 0 ${at(2 * radius)} 0a${at(radius)} ${at(radius)} 0 1 0 ${at(-2 * radius)} 0z"/>`;
export const dot = (place: Place, kind = 'centre', radius = 2.5): string => circle(place, radius, kind);
export const square = ([x, y]: Place, half: number, kind = 'bubble'): string => `<path class="${kind}" d="M${at(x - half)} ${at(y - half)}h${at(2 * half)}v${at(2 * half)}h${at(-2 * half)}z"/>`;
export const closed = (points: readonly Place[], kind: string): string => `<path class="${kind}" d="M${points.map(([x, y]) => `${at(x)} ${at(y)}`).join('L')}z"/>`;

/**
 * A small picture shows the middle band of the square picture. `placed` gives units for shares of its side, `shared`
 * the reverse.
 */
export const placed = ([x, y]: Place): Place => [x * WIDTH, y * WIDTH - (WIDTH - HEIGHT) / 2];
export const shared = ([x, y]: Place): Place => [x / WIDTH, (y + (WIDTH - HEIGHT) / 2) / WIDTH];

/** Points as words of a recipe. */
export const listed = (points: readonly Place[]): string[] => points.map((place) => shared(place).map((part) => part.toFixed(4)).join(','));

/** A studio with this recipe, whose fields are made. */
function opened(module: Bubbles, recipe: string): Studio {
  const studio = new module.Bubblestone(recipe);
  while (['domain', 'fields'].includes(studio.stage())) studio.tick(100, 0);
  return studio;
}

/** The answer of a recipe's studio to a question, once its fields are made. */
export function ask<T>(module: Bubbles, recipe: string, question: (studio: Studio) => T): T {
  const studio = opened(module, recipe);
  const answer = question(studio);
  studio.free();
  return answer;
}

/** The answers of a packing to a question, at each of its first steps. */
export function asked<T>(module: Bubbles, recipe: string, steps: number, question: (studio: Studio) => T): T[] {
  return ask(module, recipe, (studio) =>
    Array.from({ length: steps }, (_, step) => {
      studio.hold(step);
      while (!studio.reach(100));
      return question(studio);
    }),
  );
}
