/** Handles on the numbers of the place that is looked at: `mark` is the first, `mark-1` the second, and so on. */
const MARK = /^mark(?:-(\d+))?$/;

/** The place of a handle's number in `at`; `undefined` if its key is a parameter's. */
export function markAt(key: string): number | undefined {
  const found = MARK.exec(key);
  return found ? Number(found[1] ?? 0) : undefined;
}
