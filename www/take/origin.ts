/**
 * The origin of a saved file: pictures and drawings carry their link, and can be opened like recipes. A PNG file
 * holds the link as a text with the program's name as keyword, an SVG file as metadata.
 */
import { textIn, withText } from './files/png';

/** The program that writes these files. Files of other programs are not read. */
export const PROGRAM = 'Bubblestone';

/** A copy of the file with the address inside. */
export async function signed(file: Blob, address: string): Promise<Blob> {
  if (file.type === 'image/png') return withText(file, PROGRAM, address);
  const text = await file.text();
  const inside = text.indexOf('>') + 1;
  const origin = `\n<metadata>${PROGRAM}: ${address.replaceAll('&', '&amp;')}</metadata>`;
  return new Blob([text.slice(0, inside), origin, text.slice(inside)], { type: file.type });
}

/** The content of a canvas as a PNG file with the address inside; undefined if the browser cannot make one. */
export async function signedPng(canvas: HTMLCanvasElement, address: string): Promise<Blob | undefined> {
  const picture = await new Promise<Blob | null>((resolve) => canvas.toBlob(resolve, 'image/png'));
  return picture ? signed(picture, address) : undefined;
}

/** The address in a saved file, read from its first bytes; undefined if there is none. */
export function originIn(bytes: Uint8Array): string | undefined {
  const inPicture = textIn(bytes, PROGRAM);
  if (inPicture !== undefined) return inPicture;
  const inDrawing = new RegExp(`^<svg [^>]*>\\s*<metadata>${PROGRAM}: ([^<]*)</metadata>`).exec(new TextDecoder().decode(bytes));
  return inDrawing?.[1]?.replaceAll('&amp;', '&');
}
