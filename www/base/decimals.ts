/**
 * Signs that number boxes drop or refuse. A comma counts as the decimal sign: where the browser's own language writes a
 * point, browsers drop a comma, so that 0,5 becomes 5. The minus sign and the dash that printed texts have count as the
 * hyphen that browsers read: else −3 becomes 3. A number with two such commas or points has no sure meaning, and browsers
 * drop one of them: the text that was typed is refused as a whole.
 */

import { soon } from './soon';

/** Numbers with one comma, or the comma alone, as it is typed or pasted. Others may be lists, or have groups of digits. */
const COMMA = /^[^.,]*,[^.,]*$/;

/** The sign before a number, or alone, as it is typed. */
const MINUS = /^\s*[\u2212\u2013]/;

/** Points and commas, also those of input methods for Chinese and Japanese. */
const SIGNS = /[.,．，。、｡､]/g;

/** Signs that browsers drop from a text that an input method writes. */
const DROPPED = /[,，。、｡､]/;

/** The texts of number boxes whose numbers are not sure. */
const unsure = new WeakMap<HTMLInputElement, string>();

/** The text of a number box: as it was typed if its number is not sure. */
export function typedIn(box: HTMLInputElement): string {
  return unsure.get(box) ?? box.value;
}

/** Begins to read these signs in the whole page. */
export function readSigns(): void {
  const hasPoint = !new Intl.NumberFormat().format(0.5).includes(',');
  /** The number of letters before an input. If they do not become more, some were replaced, and perhaps a sign. */
  let letters = 0;
  document.addEventListener('beforeinput', (event) => {
    const box = numberBox(event);
    if (!box) return;
    const { data } = event;
    const signs = data?.match(SIGNS)?.length ?? 0;
    const { value } = box;
    letters = signs > 1 ? -1 : value.length;
    if (data && (signs > 1 || unsure.has(box) || (signs && /\./.test(value)))) unsure.set(box, signs > 1 ? data : typedIn(box) + data);
    if (!data || !event.cancelable) return;
    const plain = data.replace(MINUS, '-');
    const read = hasPoint && COMMA.test(plain) ? plain.replace(',', '.') : plain;
    if (read === data) return;
    event.preventDefault();
    // Number boxes tell no place of the cursor, so only this command can write there; it keeps the browser's own undo.
    // eslint-disable-next-line @typescript-eslint/no-deprecated
    document.execCommand('insertText', false, read);
  });
  document.addEventListener('input', (event) => {
    const box = numberBox(event);
    if (box && box.value.length <= letters) unsure.delete(box);
  });
  document.addEventListener('compositionend', (event) => {
    const box = numberBox(event);
    if (box && DROPPED.test(event.data)) unsure.set(box, event.data);
  });
  // Boxes that do not ask for the typed text see an empty one, which changes nothing.
  document.addEventListener(
    'change',
    (event) => {
      const box = numberBox(event);
      if (!box || !unsure.has(box)) return;
      box.value = '';
      // Those that ask do so while this event goes on.
      soon(() => unsure.delete(box));
    },
    { capture: true },
  );
}

function numberBox({ target }: Event): HTMLInputElement | undefined {
  return target instanceof HTMLInputElement && target.type === 'number' ? target : undefined;
}
