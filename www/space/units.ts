/** The unit of a file that tells none: the key of the parameter, and another unit if the file is far too large. */
import { RefusedFile } from './trial';

export const UNIT = 'unit';

/** The unit of files without one. */
export const METRES = 'm';

/** The refusal of a building that would have a usual size in another unit. */
const UNUSUAL = 'masonry_units';

/** The unit in which a refused file would have a usual size; undefined if it was refused for another reason. */
export function otherUnit(error: unknown): string | undefined {
  if (!(error instanceof RefusedFile) || error.notice.code !== UNUSUAL) return undefined;
  const unit = error.notice.args[UNIT];
  return typeof unit === 'object' && 'word' in unit ? unit.word : undefined;
}
