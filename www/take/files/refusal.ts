/** A refusal of the module, thrown through the code that makes a file up to the page. */
import type { Notice } from '../../module/types';

export class Refusal extends Error {
  readonly notice: Notice;

  constructor(notice: Notice) {
    super(notice.text);
    this.notice = notice;
  }
}

/** Returns the result; throws a Refusal if the module refused. */
export function given<T extends object>(made: T | Notice): T {
  if ('code' in made) throw new Refusal(made);
  return made;
}
