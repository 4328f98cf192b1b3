/** Corners and edges of a building whose bricks are turned by hand: rows of the recipe. */
import type { Work } from '../state/work';

/** The parameter that holds them, and the numbers of corners and edges in it. */
const KEY = 'flips';
const TURNED = [0, 1];

/** The act that turns the bricks of a feature, or turns them back; undefined if that cannot be done. */
export function flipOf(work: Work, [kind, number]: readonly [kind: number, number: number]): (() => void) | undefined {
  const { engine } = work;
  if (!TURNED.includes(kind) || !engine.schema.some(({ key }) => key === KEY)) return undefined;
  return () => {
    const rows = engine.list(KEY);
    const others = rows.filter((row) => row[0] !== kind || row[1] !== number);
    const turned = others.length < rows.length ? others : [...rows, [kind, number]];
    work.set(KEY, turned.map((row) => row.join()).join(';'));
  };
}
