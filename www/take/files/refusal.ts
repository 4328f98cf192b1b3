/** A refusal of the module, as an error for the code that makes files. */
import type { Notice } from '../../module/types';

export class Refusal extends Error {
  readonly notice: Notice;

  constructor(notice: Notice) {
    super(notice.text);
    this.notice = notice;
  }
}

/** Returns the result; throws a Refusal if it is a notice. */
export function given<T extends object>(made: T | Notice): T {
  if ('code' in made) throw new Refusal(made);
  return made;
}
