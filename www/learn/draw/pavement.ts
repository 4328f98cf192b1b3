/** A pavement taken apart: stones, the cells that they fill, the bubbles that the cells are made of, and two of these. */
import type { Cell, View } from '../figures/figure';
import { number } from '../figures/words';
import { arrow, at, circle, pick, PULL, PUSH, svg, symbol, text, WIDTH } from './plate';

const SIDE = WIDTH - 16;
const OFF = 8;

/** A number of tints, given by a cell's number, so that neighbours mostly differ. */
const TINTS = 4;

/** The radius of the two bubbles that are left. */
const LARGE = 78;

/** The length of the arrows on these two, which show only the direction. */
const ARROW = 34;

type Form = 'stones' | 'cells' | 'bubbles' | 'two';
const FORMS: readonly Form[] = ['stones', 'cells', 'bubbles', 'two'];

const place = (share: number): number => OFF + share * SIDE;

export function pavement(view: View, packing: number): string {
  const cells = view.traces[packing]?.cells ?? [];
  const pair = pairOf(cells);
  const whole = FORMS[view.step - 1];
  const form = (cell: Cell): Form => whole ?? FORMS[Math.min(3, Math.floor(cell.x * 4))] ?? 'two';
  // If the pair is shown large, all small bubbles stand back, those of the pair, too.
  const drawn = cells.map((cell) => one(cell, form(cell), whole ? [] : pair)).join('');
  const two = whole === 'two' ? large(view, pair) : '';
  const said = view.language === 'ja' ? '石畳の石と、もとになったバブル' : 'The stones of a pavement and the bubbles they are made of';
  return svg(WIDTH, said, drawn + two);
}

function one(cell: Cell, form: Form, pair: readonly Cell[]): string {
  if (form === 'stones') return stone(cell);
  if (form === 'cells') return `<path class="cell" d="${edges(cell, 1)}"/>`;
  const kind = form === 'two' && !pair.includes(cell) ? 'bubble faint' : 'bubble';
  return circle([place(cell.x), place(cell.y)], cell.radius * SIDE, kind);
}

/** A stone: its cell, shrunk and rounded, with a lit edge. */
function stone(cell: Cell): string {
  return `<path class="joint" d="${edges(cell, 1)}"/><path class="stone tint${cell.id % TINTS}" d="${rounded(cell, 0.9)}"/><path class="lit" d="${rounded(cell, 0.74)}"/>`;
}

function corners({ x, y, outline }: Cell, share: number): (readonly [number, number])[] {
  return Array.from({ length: outline.length / 2 }, (_, k) => [place(x + share * ((outline[2 * k] ?? x) - x)), place(y + share * ((outline[2 * k + 1] ?? y) - y))] as const);
}

function edges(cell: Cell, share: number): string {
  return `M${corners(cell, share).map(([x, y]) => `${at(x)} ${at(y)}`).join('L')}z`;
}

/** A closed curve through the middles of the edges, near the corners. */
function rounded(cell: Cell, share: number): string {
  const all = corners(cell, share);
  const next = (k: number): readonly [number, number] => all[(k + 1) % all.length] ?? [0, 0];
  const toward = ([a, b]: readonly [number, number], [c, d]: readonly [number, number]): string => `${at(a + 0.3 * (c - a))} ${at(b + 0.3 * (d - b))}`;
  const parts = all.map((corner, k) => {
    const before = all[(k + all.length - 1) % all.length] ?? corner;
    return `${k ? 'L' : 'M'}${toward(corner, before)}Q${at(corner[0])} ${at(corner[1])} ${toward(corner, next(k))}`;
  });
  return `${parts.join('')}z`;
}

/** The cell nearest to the middle of the right quarter, and its nearest neighbour there. */
function pairOf(cells: readonly Cell[]): readonly Cell[] {
  const far = (cell: Cell, x: number, y: number): number => Math.hypot(cell.x - x, cell.y - y);
  const nearest = (all: readonly Cell[], x: number, y: number): Cell | undefined => [...all].sort((a, b) => far(a, x, y) - far(b, x, y))[0];
  const right = cells.filter(({ x }) => x > 0.75);
  const first = nearest(right, 0.86, 0.5);
  const second = first && nearest(right.filter((cell) => cell !== first), first.x, first.y);
  return first && second ? [first, second] : [];
}

/** The two remaining bubbles, large, as in all other figures of the chapter, with their true distance and force. */
function large({ curve, language }: View, [one, other]: readonly Cell[]): string {
  if (!one || !other) return '';
  const w = Math.hypot(other.x - one.x, other.y - one.y) / (one.radius + other.radius);
  const force = curve.reduce((best, point) => (Math.abs(point[0] - w) < Math.abs(best[0] - w) ? point : best), curve[0] ?? [0, 0, 0])[1];
  const middle = WIDTH / 2;
  const [left, right] = [middle - LARGE * w, middle + LARGE * w];
  const kind = force > 0 ? 'push' : 'pull';
  const rings = [left, right].map((x) => circle([x, middle], LARGE, 'bubble') + circle([x, middle], 4, 'centre')).join('');
  const backs = [left, right].map((x) => circle([x, middle], LARGE + 10, 'back')).join('');
  const words = `${symbol('w', 'w')} = ${number(w, 3)}: ${pick(force > 0 ? PUSH : PULL, language)}`;
  const back = `<rect class="back" x="${at(middle - 70)}" y="${at(middle - LARGE - 40)}" width="140" height="26" rx="6"/>`;
  return `${backs}${back}${rings}${arrow(left, middle, -ARROW * Math.sign(force), kind)}${arrow(right, middle, ARROW * Math.sign(force), kind)}${text(middle, middle - LARGE - 22, words, `force-name ${kind}`)}`;
}
