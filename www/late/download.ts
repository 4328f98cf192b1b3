/** Hands bytes to the visitor as a file. */
import { make } from '../base/dom';

export function offer(blob: Blob, name: string): void {
  const url = URL.createObjectURL(blob);
  make('a', { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 60_000);
}
