/**
 * Marks in the browser's own timeline: the first times of events that a visitor waits for. `npm run visit` and the
 * browser's tools read them; see docs/times.md.
 */

/**
 * `cells`: the first drawing of cells, which move from then on. `frame`: the first frame of bodies, which may be coarse.
 * `made`: the picture is computed. `picture`: the finished picture is on the screen.
 */
type Mark = 'cells' | 'frame' | 'made' | 'picture';

const made = new Set<Mark>();

/** Sets a mark, the first time only. */
export function mark(name: Mark): void {
  if (made.has(name)) return;
  made.add(name);
  performance.mark(name);
}

/** Whether a mark is set. */
export function isMarked(name: Mark): boolean {
  return made.has(name);
}
