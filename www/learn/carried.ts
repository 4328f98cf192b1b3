/**
 * The state of a chapter that the link to the other language carries: the figure, the chosen answers, the counted hands, and
 * the screen of a class. Answers, hands and screen leave the address once they are read, as the visitor may share it.
 */
import { takeValue } from '../state/link';
import type { Lesson } from './lesson';

/** The words of the chosen answers, of the raised hands, and of the screen of a class, in the address of the other language. */
const CHOSEN = 'chosen';
const HANDS = 'hands';
const CLASS = 'class';

/** A number of hands: what their box can hold. */
const COUNT = /^\d{1,2}$/;

/** An answer, and the box for its number of hands. */
interface Answer {
  /** The key of its question and its value. */
  readonly key: string;
  readonly input: HTMLInputElement;
  readonly hands: HTMLInputElement | undefined;
}

function handsBeside(input: HTMLInputElement): HTMLInputElement | undefined {
  const box = input.closest('label')?.nextElementSibling;
  return box instanceof HTMLInputElement ? box : undefined;
}

const answers = (): readonly Answer[] =>
  [...document.querySelectorAll<HTMLInputElement>('[data-ask] input[type="radio"]')].map((input) => ({
    key: `${input.closest('[data-ask]')?.getAttribute('data-ask') ?? ''}.${input.value}`,
    input,
    hands: handsBeside(input),
  }));

const word = (name: string, values: readonly string[]): string => (values.length ? `${name}=${values.join(',')}` : '');

/** Makes the link to the other language open the same state. */
export function keepState(link: HTMLAnchorElement, lesson: Lesson | undefined): void {
  const follow = (): void => {
    const all = answers();
    const chosen = all.filter(({ input }) => input.checked).map(({ key }) => key);
    const hands = all.flatMap(({ key, hands }) => (hands && COUNT.test(hands.value) ? [`${key}.${hands.value}`] : []));
    const screen = lesson?.screen ?? -1;
    link.hash = [location.hash.slice(1), word(CHOSEN, chosen), word(HANDS, hands), word(CLASS, screen < 0 ? [] : [String(screen)])].filter(Boolean).join('&');
  };
  // The figures write the address without an event.
  for (const event of ['pointerdown', 'focus', 'click']) link.addEventListener(event, follow);
}

/** Chooses the answers that were chosen in the other language, and writes the hands that were counted there. */
export function restore(): void {
  const chosen = takeValue(CHOSEN).split(',');
  const counts = takeValue(HANDS).split(',');
  for (const { key, input, hands } of answers()) {
    const count = counts.find((one) => one.startsWith(`${key}.`))?.slice(key.length + 1) ?? '';
    if (hands && COUNT.test(count)) hands.value = count;
    if (!chosen.includes(key)) continue;
    input.checked = true;
    input.dispatchEvent(new Event('change', { bubbles: true }));
  }
}

/** The screen of the class in the other language; undefined if there was none. */
export function takeScreen(): number | undefined {
  const screen = takeValue(CLASS);
  return screen ? Number(screen) : undefined;
}
