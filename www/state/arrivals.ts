/** Links whose generator may not be loaded yet. The page stays as it is until the generator is loaded. */
import { placeOf } from '../module/generators';
import { loadModule, moduleFor } from '../module/load';
import { t, type PageWord } from '../words/words';
import { make } from '../base/dom';
import { reasonOf } from '../base/errors';
import { moreWords } from '../base/language';
import { alertOf, clear, underWay } from '../base/messages';

/** Milliseconds. A faster load is not announced. */
const SOON = 250;

/** Whether a link can be opened at once. */
export function isHere(link: string): boolean {
  return moduleFor(link) !== undefined;
}

/**
 * Loads the module that a link needs. Throws an Error whose message is a sentence for the visitor, in the language of the
 * page, which has come when `spoken` ends.
 */
export async function load(link: string, lost: PageWord = 'lost_wasm', spoken?: Promise<void>): Promise<void> {
  const failure = async (word: PageWord, cause?: unknown): Promise<Error> => {
    await spoken;
    return new Error(t(word), { cause });
  };
  if (typeof WebAssembly !== 'object') throw await failure('no_wasm');
  try {
    await Promise.all([loadModule(link), placeOf(link) > 0 ? moreWords() : undefined]);
  } catch (error) {
    throw await failure(reasonWord(error) ?? lost, error);
  }
}

/** The cause that an error of a load tells, unless it is the connection. Browsers tell a lack of memory in several ways. */
function reasonWord(error: unknown): PageWord | undefined {
  const reason = reasonOf(error);
  if (error instanceof RangeError || /out of memory/i.test(reason)) return 'no_memory';
  // All browsers call the first bytes of a module its magic. Others come if a network answers with a page of its own.
  return error instanceof WebAssembly.CompileError && !/magic/i.test(reason) ? 'old_wasm' : undefined;
}

export class Arrivals {
  private readonly tell: (link: string) => void;
  /** Counts the requests. A load for an earlier request is ignored when it ends. */
  private turn = 0;
  private timer = 0;

  /** `tell` gets the link that is waited for, and '' once there is none. */
  constructor(tell: (link: string) => void = () => undefined) {
    this.tell = tell;
  }

  /** Calls `act` once the link can be opened: at once if its generator is loaded. Cancels any earlier wait. */
  reach(link: string, act: () => void): void {
    this.cancel();
    if (isHere(link)) act();
    else void this.bring(link, act);
  }

  /** Cancels the wait. */
  cancel(): void {
    this.turn += 1;
    clearTimeout(this.timer);
    clear('module');
    this.tell('');
  }

  private async bring(link: string, act: () => void): Promise<void> {
    const { turn } = this;
    this.tell(link);
    this.timer = window.setTimeout(() => underWay('module', t('module_coming'), this.button('module_stay', () => this.cancel())), SOON);
    let failure: string | undefined;
    try {
      await load(link, 'lost_module');
    } catch (error) {
      failure = reasonOf(error);
    }
    if (turn !== this.turn) return;
    if (failure === undefined) act();
    this.cancel();
    if (failure !== undefined) alertOf('module', failure, this.button('module_again', () => this.reach(link, act)));
  }

  private button(word: PageWord, act: () => void): HTMLElement {
    const button = make('button', { type: 'button' }, t(word));
    button.addEventListener('click', act);
    return button;
  }
}
