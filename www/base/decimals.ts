/**
 * A comma in a number box counts as the decimal sign. Where the browser's own language writes a point, browsers drop a
 * comma, so that 0,5 becomes 5, or refuse the number.
 */

/** Numbers with one comma, or the comma alone, as it is typed or pasted. Others may be lists, or have groups of digits. */
const COMMA = /^[^.,]*,[^.,]*$/;

/** Begins to read commas in the whole page. */
export function readCommas(): void {
  if (new Intl.NumberFormat().format(0.5).includes(',')) return;
  document.addEventListener('beforeinput', (event) => {
    const { target, data } = event;
    if (!(target instanceof HTMLInputElement) || target.type !== 'number' || !data || !COMMA.test(data)) return;
    event.preventDefault();
    // Number boxes tell no place of the cursor, so only this command can write there; it keeps the browser's own undo.
    // eslint-disable-next-line @typescript-eslint/no-deprecated
    document.execCommand('insertText', false, data.replace(',', '.'));
  });
}
