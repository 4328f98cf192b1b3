/** A refusal of the module, carried to the page through what makes a file. */
import type { Notice } from '../../module/types';

export class Refusal extends Error {
  readonly notice: Notice;

  constructor(notice: Notice) {
    super(notice.text);
    this.notice = notice;
  }
}

/** What was made; throws a Refusal where there is none. */
export function given<T extends object>(made: T | Notice): T {
  if ('code' in made) throw new Refusal(made);
  return made;
}
