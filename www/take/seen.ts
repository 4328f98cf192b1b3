/** What the turntable shows now, and where from. */
import { cameraWords, HOME } from '../state/asked-view';
import type { Store } from '../state/store';
import type { Seen } from './files/turn';

export function seenNow({ state: { body, camera } }: Store): Seen {
  return { subject: body?.subject ?? '', camera: cameraWords(body?.camera ?? camera ?? HOME) };
}
