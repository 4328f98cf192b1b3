/** Two bubbles, and below the right one the track of its distance: time goes down. */
import type { View } from '../figures/figure';
import { at, circle, guideDown, line, momentOf, NOTHING, path, pick, PULL, PUSH, svg, symbol, text, WIDEST, WIDTH, X } from './plate';
import { BELOW, bubbles } from './bubbles';
import { HEIGHT } from './force';

const [TOP, BOTTOM] = [BELOW + 24, HEIGHT - 24];

/** Where the names of stops stand. */
const NAMED = 1.62;

/** The room between the names of two stops. */
const APART = 15;

export function track(view: View, packing: number, title: string): string {
  const Y = (step: number): number => TOP + (step / view.last) * (BOTTOM - TOP);
  const moments = view.traces[packing]?.moments.slice(0, view.step + 1) ?? [];
  const points = moments.map(({ w, step }) => [X(Math.min(w, WIDEST + 0.2)), Y(step)] as const);
  const now = momentOf(view, packing);
  const guide = now?.left === 0 ? guideDown(now.w, BELOW - 8, TOP, Y(now.step)) : '';
  const here = now && X(now.w) < WIDTH ? circle([X(now.w), Y(now.step)], 5.5, 'here') : '';
  const said = view.language === 'ja' ? '二つのバブルと、時間とともに変わる距離wの跡' : 'Two bubbles, and the track of their distance w over time';
  return svg(HEIGHT, title ? `${title}. ${said}` : said, `${scale(view, Y)}${guide}${path(points, 'track')}${stops(view, packing, Y)}${here}${title ? text(6, 16, title, 'plate-title', 'start') : ''}${bubbles(view, packing)}`);
}

function scale({ language, last }: View, Y: (step: number) => number): string {
  const bands = ([[0, 1, 'push', PUSH], [1, 1.5, 'pull', PULL], [1.5, WIDEST, 'none', NOTHING]] as const).map(
    ([from, to, kind, words]) =>
      `<rect class="band ${kind}" x="${at(X(from))}" y="${TOP}" width="${at(X(to) - X(from))}" height="${BOTTOM - TOP}"/>${text(X((from + to) / 2), TOP - 6, pick(words, language), `band-name ${kind}`)}`,
  );
  const marks = [0, 0.5, 1, 1.5, 2].map((w) => `${line([X(w), BOTTOM], [X(w), BOTTOM + 4], 'tick')}${text(X(w), BOTTOM + 16, String(w), 'number')}`);
  const steps = [0, last / 2, last].map((step) => text(X(0) - 8, Y(step) + 4, String(step), 'number', 'end'));
  const name = text(X(0) - 34, (TOP + BOTTOM) / 2 - 22, language === 'ja' ? '時間' : 'time', 'number', 'middle');
  const rest = line([X(1), TOP], [X(1), BOTTOM], 'stable');
  return `${bands.join('')}${rest}${marks.join('')}${steps.join('')}${name}${text(X(WIDEST) + 2, BOTTOM + 16, symbol('w', 'w'), 'number', 'end')}`;
}

/**
 * The name of a stop: right of the bands, with a line from its dot, or left of a dot that is there. It lies on the track,
 * or somewhat lower if another name is near.
 */
function named(x: number, y: number, low: number, words: string): string {
  if (x + 8 > X(NAMED) - 5) return text(x - 9, y + 4, words, 'stop-name halo', 'end');
  return `${line([x + 8, y], [X(NAMED) - 5, low], 'leader')}${text(X(NAMED), low + 4, words, 'stop-name halo', 'start')}`;
}

/** The stops that have been passed, except one at the last step: on the track, with their names where there is room. */
function stops(view: View, packing: number, Y: (step: number) => number): string {
  let free = -Infinity;
  const passed = view.stops.filter(({ step }) => step > 0 && step <= view.step && step < view.last);
  return passed
    .map(({ name, step }) => {
      const w = view.traces[packing]?.moments[step]?.w ?? 0;
      const dot = circle([X(Math.min(w, WIDEST)), Y(step)], 3, 'stop');
      const low = Math.max(Y(step), free + APART);
      if (packing > 0 || low > Y(step) + APART) return packing > 0 ? '' : dot;
      free = low;
      return `${dot}${named(X(Math.min(w, WIDEST)), Y(step), low, pick(name, view.language))}`;
    })
    .join('');
}
