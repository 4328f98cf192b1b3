/**
 * Signs that number boxes drop or refuse. A comma counts as the decimal sign: where the browser's own language writes a
 * point, browsers drop a comma, so that 0,5 becomes 5. The minus sign and the dash that printed texts have count as the
 * hyphen that browsers read: else −3 becomes 3.
 */

/** Numbers with one comma, or the comma alone, as it is typed or pasted. Others may be lists, or have groups of digits. */
const COMMA = /^[^.,]*,[^.,]*$/;

/** The sign before a number, or alone, as it is typed. */
const MINUS = /^\s*[\u2212\u2013]/;

/** Begins to read these signs in the whole page. */
export function readSigns(): void {
  const hasPoint = !new Intl.NumberFormat().format(0.5).includes(',');
  document.addEventListener('beforeinput', (event) => {
    const { target, data } = event;
    if (!(target instanceof HTMLInputElement) || target.type !== 'number' || !data || !event.cancelable) return;
    const plain = data.replace(MINUS, '-');
    const read = hasPoint && COMMA.test(plain) ? plain.replace(',', '.') : plain;
    if (read === data) return;
    event.preventDefault();
    // Number boxes tell no place of the cursor, so only this command can write there; it keeps the browser's own undo.
    // eslint-disable-next-line @typescript-eslint/no-deprecated
    document.execCommand('insertText', false, read);
  });
}
