/**
 * Marks in the browser's own timeline: when what a visitor waits for was there for the first time. `npm run visit` and
 * the browser's tools read them; see docs/times.md.
 */

/**
 * `cells`: the first drawing of cells, which move from then on. `frame`: the first frame of bodies, which may be coarse.
 * `made`: the picture is worked out. `picture`: it stands on the screen in full.
 */
type Mark = 'cells' | 'frame' | 'made' | 'picture';

const made = new Set<Mark>();

/** Marks the first time only. */
export function mark(name: Mark): void {
  if (made.has(name)) return;
  made.add(name);
  performance.mark(name);
}
