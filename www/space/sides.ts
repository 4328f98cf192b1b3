/** The side of a model's open parts that is its outside: the key of the parameter, and its values. */
export const SIDE = 'side';
export const GUESSED = 'guess';
const OTHER = 'other';

/** The remark on a file whose own outsides look like insides. */
const INWARD = 'model_faces_in';

/** Whether the recipe asks for the other side. */
export function isOther(value: string): boolean {
  return value === OTHER;
}

/** The value that makes the side outside which is inside now. `remarks` are the codes of the remarks on the surface. */
export function otherSide(value: string, remarks: readonly string[]): string {
  if (value === OTHER) return GUESSED;
  return value === GUESSED || !remarks.includes(INWARD) ? OTHER : GUESSED;
}
